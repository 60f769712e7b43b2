// SPDX-License-Identifier: MIT
// Histograms of errors in radii, engines side by side.
const Histograms = (() => {
  const {el, num, plain, power} = Format;
  const {list} = Data;
  const parts = PlotParts;

  const isDecade = (x) => x > 0 && Math.abs(Math.log10(x) - Math.round(Math.log10(x))) < 0.01;
  function edgeName(x) {
    if (!(x > 0 && x < 0.0099)) return plain(x);
    return isDecade(x) ? power(Math.round(Math.log10(x))) : num(x);
  }
  /** The first and the last bin are open. */
  function rangeName(i, edges) {
    if (i === 0) return `below ${edgeName(edges[1])}`;
    return i + 2 < edges.length ? `${edgeName(edges[i])} to ${edgeName(edges[i + 1])}`
                                : `${edgeName(edges[i])} and more`;
  }

  /** The bins from the first to the last in which something is: [begin, end). */
  function usedBins(lists) {
    const length = Math.max(...lists.map((counts) => counts.length));
    const used = Array.from({length}, (_, i) => i).filter((i) => lists.some((counts) => counts[i] > 0));
    return [Math.max(0, used[0] - 1), Math.min(length, used[used.length - 1] + 2)];
  }

  function config(field, engines) {
    const [begin, end] = usedBins(engines.map((e) => e[field]));
    const edges = list(Data.run.histogram_edges);
    const labels = Array.from({length: end - begin}, (_, i) => rangeName(begin + i, edges));
    const tick = (i) => (begin + i === 0 ? '0' : edgeName(edges[begin + i]));
    const totals = engines.map((e) => e[field].reduce((sum, n) => sum + n, 0));
    const isFine = labels.length > 14; // not every bin has room for a name then
    return {
      type: 'line',
      data: {
        labels,
        datasets: engines.map((e, i) => {
          const counts = e[field].slice(begin, end);
          return {
            label: `${e.name} (${Format.count(totals[i])})`,
            data: counts.map((n) => 100 * n / totals[i]),
            counts,
            borderColor: Data.colour(e.name),
            backgroundColor: Data.colour(e.name),
            borderWidth: 2,
            pointRadius: counts.map((n) => (n > 0 ? 4 : 0)),
            ...parts.pointMark(e.name)
          };
        }),
      },
      options: {
        interaction: {mode: 'index', intersect: false},
        plugins: {
          legend: {labels: {usePointStyle: true, boxHeight: 7}},
          tooltip: {
            callbacks: {
              title: ([item]) => `${item.label} radii`,
              label: (item) => `${engines[item.datasetIndex].name}: ${num(item.parsed.y)} %, ${
                  Format.count(item.dataset.counts[item.dataIndex])} contacts`,
            }
          }
        },
        scales: {
          x: {
            title: {display: true, text: 'radii of the ball, where each bin begins'},
            grid: {display: false},
            ticks: {
              autoSkip: false,
              maxRotation: 0,
              callback: (i) => (!isFine || begin + i === 0 || isDecade(edges[begin + i]) ? tick(i) : null)
            }
          },
          y: {title: {display: true, text: '% of its contacts'}, beginAtZero: true},
        },
      },
    };
  }

  function figure(field, scene, caption, note) {
    const engines = list(scene.engines).filter((e) => list(e[field]).some((n) => n > 0));
    const text = el('figcaption', null, caption, el('small', null, note));
    if (engines.length === 0)
      return {figure: el('figure', null, text, parts.nothing('No contact to show.')), draw: () => {}};
    const c = parts.canvas(`${caption}: ${engines.map((e) => e.name).join(', ')}`);
    c.dataset.plot = field;
    return {
      figure: el('figure', null, text, parts.frame(c, true)),
      draw: () => parts.draw(c, config(field, engines))
    };
  }

  return {figure};
})();
