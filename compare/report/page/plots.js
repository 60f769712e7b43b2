// SPDX-License-Identifier: MIT
// Work against precision: what each setting of each engine costs, and how exact it is.
const Plots = (() => {
  const {
    el,
    plain,
    bothAngles,
    count,
    time,
    plainTime,
    withInterval,
    rate,
    rateInterval,
    rateWithInterval,
    isNumber,
    power,
    dash
  } = Format;
  const {list} = Data;
  const parts = PlotParts;

  const isExact = (row) => row.engine === 'exact';
  /** Of which only the substeps vary: its points are a line. */
  const isBySubsteps = (row) => !row.engine.startsWith('box2d');

  /** The tunneled rate with the further impacts of the proof; the interval is known without them only. */
  function tunneledOf(row) {
    const r = row.tunneled_rate;
    if (!r || !isNumber(r.count) || !(r.of > 0)) return null;
    if (!row.proof) return r;
    return {count: r.count + row.proof.tunneled, of: r.of + row.proof.contacts};
  }
  const isNone = (row) => tunneledOf(row)?.count === 0;

  // The two questions that are put to every setting.
  const questions = {
    error: {
      title: 'Direction error after an impact (rad, p95)',
      caption: 'Error against time',
      note: 'how far off the ball flies, 95th percentile; down and left is better',
      value: (row) => row.direction_error_p95,
      front: 'front_by_error',
      remark: 'A ball that is lost counts as \u03c0: a setting that loses more than 5% is there.',
    },
    tunneled: {
      title: 'Impacts that tunnel (%)',
      caption: 'Tunneling against time',
      note: 'share of impacts at which the ball passes; bars are 95% intervals',
      value: (row) => {
        const r = tunneledOf(row);
        return r && r.count / r.of;
      },
      range: (row) => (isNone(row) ? null : [tunneledOf(row).low, tunneledOf(row).high]),
      front: 'front_by_misses',
      most: 1,
      remark:
          'None lost in n impacts lies at the lower edge; at 95% the rate is below 3/n then, as the table has it.',
    },
  };

  const isTimed = (row) => isNumber(row.ns_per_ball_second) && row.ns_per_ball_second > 0;
  const drawable = (question, rows) =>
      rows.filter((row) => isTimed(row) && !isExact(row) && isNumber(question.value(row)));
  const exactTime = (rows) => rows.find((row) => isExact(row) && isTimed(row))?.ns_per_ball_second;

  function shortName(row) {
    const steps = row.settings?.substeps;
    return isBySubsteps(row) && isNumber(steps) ? `\u00d7${steps}` : row.label;
  }

  function toPoint(question, row, floor) {
    const value = question.value(row);
    const times = row.ns_per_ball_second_interval;
    const range = question.range?.(row);
    const isFront = Boolean(row[question.front]);
    return {
      x: row.ns_per_ball_second,
      y: value > floor ? value : floor,
      row,
      isFront,
      xs: Array.isArray(times) && isNumber(times[0]) && isNumber(times[1]) ? times : null,
      ys: range && range.every(isNumber) ? range : null,
      name: isFront || isBySubsteps(row) ? shortName(row) : null,
    };
  }

  function series(engine, points) {
    const colour = Data.colour(engine);
    const bySubsteps =
        [...points].sort((a, b) => (a.row.settings?.substeps ?? 0) - (b.row.settings?.substeps ?? 0));
    return {
      label: engine,
      data: bySubsteps,
      borderColor: colour,
      backgroundColor: colour,
      pointBackgroundColor: bySubsteps.map((p) => (p.isFront ? colour : Data.css('--bg'))),
      pointBorderColor: colour,
      pointBorderWidth: 1.8,
      ...parts.pointMark(engine),
      pointRadius: 5,
      pointHoverRadius: 8,
      showLine: isBySubsteps({engine}),
      borderWidth: 2,
      clip: false,
    };
  }

  function frontSeries(points) {
    const front =
        points.filter((p) => p.isFront).map(({x, y}) => ({x, y})).sort((a, b) => a.x - b.x || b.y - a.y);
    return {
      label: 'Pareto front',
      data: front,
      showLine: true,
      stepped: true,
      pointStyle: 'line',
      pointRadius: 0,
      pointHitRadius: 0,
      pointHoverRadius: 0,
      borderColor: Data.css('--muted'),
      backgroundColor: Data.css('--muted'),
      borderDash: [5, 4],
      borderWidth: 1.5,
      order: 10,
    };
  }

  function proofText({proof}) {
    if (!proof) return dash;
    return `${proof.tunneled > 0 ? count(proof.tunneled) : 'none'} in ${count(proof.contacts)}`;
  }
  const rowName = (row) => (isExact(row) || !row.label ? row.engine : `${row.engine}: ${row.label}`);
  function tooltip(row) {
    const lines =
        [`time ${time(row.ns_per_ball_second)}` +
         (row.ns_per_ball_second_interval ? ` (${row.ns_per_ball_second_interval.map(time).join(' to ')})`
                                          : '')];
    lines.push(`direction error, p95: ${bothAngles(row.direction_error_p95)} rad`);
    for (const [name, r] of [['tunneled', tunneledOf(row)], ['missed', row.miss_rate]]) {
      if (!r || !(r.of > 0)) continue;
      const range = rateInterval(r);
      lines.push(`${name}: ${rate(r)} %${range ? ` (${range})` : ''}, ${count(r.count)} of ${count(r.of)}`);
    }
    if (row.proof) lines.push(`of these in the proof: ${proofText(row)}`);
    if (row.front_by_error) lines.push('on the front of error');
    if (row.front_by_misses) lines.push('on the front of tunneling');
    return lines;
  }

  function floorBelow(question, rows) {
    const smallest = Math.min(...rows.map(question.value).filter((v) => v > 0));
    return parts.niceBelow((Number.isFinite(smallest) ? smallest : 1e-3) / 2.5);
  }

  /** The axes that hold all rows: floor and top of the value, first and last time. */
  function rangeOf(question, rows, floor) {
    const shown = drawable(question, rows);
    const times = [...shown.map((row) => row.ns_per_ball_second), exactTime(rows)].filter(isNumber);
    const values = shown.flatMap((row) => [question.value(row), question.range?.(row)?.[1]]).filter(isNumber);
    return {
      floor,
      top: Math.min(parts.niceAbove(1.1 * Math.max(...values, 10 * floor)), question.most ?? Infinity),
      first: parts.niceBelow(Math.min(...times) / 1.25),
      last: parts.niceAbove(Math.max(...times) * 1.25),
    };
  }

  /** Work against precision; null where no setting of the scene has a time and a value. */
  function workConfig(key, allRows) {
    const question = questions[key];
    const rows = drawable(question, allRows);
    if (rows.length === 0) return null;
    const {floor, top, first, last} = rangeOf(question, allRows, floorBelow(question, rows));
    const points = rows.map((row) => toPoint(question, row, floor));
    const engines = [...new Set(rows.map((row) => row.engine))];
    const yLabel = (v) => plain(key === 'tunneled' ? 100 * v : v);
    // Below a hundredth, decades only, as powers: zeros are hard to count.
    const yTick = (v) => (v > 0.0099 || key === 'tunneled'     ? yLabel(v)
                          : Math.abs(Math.log10(v) % 1) < 1e-6 ? power(Math.round(Math.log10(v)))
                                                               : null);
    return {
      type: 'scatter',
      data: {
        datasets: [
          ...engines.map((name) => series(name, points.filter((p) => p.row.engine === name))),
          frontSeries(points)
        ]
      },
      plugins: [parts.floorLine, parts.exactLine, parts.intervals, parts.pointNames],
      options: {
        interaction: {mode: 'nearest', intersect: true},
        plugins: {
          floorLine: {y: floor},
          exactLine: {x: exactTime(allRows), isNamed: true},
          legend: {labels: {usePointStyle: true, boxHeight: 7}},
          tooltip: {
            filter: (item) => Boolean(item.raw.row),
            callbacks: {
              title: ([item]) => (item ? rowName(item.raw.row) : ''),
              label: (item) => tooltip(item.raw.row)
            },
          },
        },
        scales: {
          x: parts.logAxis('Computing time per simulated second and ball', first, last, plainTime,
                           {isAcross: true}),
          y: parts.logAxis(question.title, floor, top, yTick, {floorLabel: key === 'error' ? '0' : 'none'}),
        },
      },
    };
  }

  function describe(question, rows) {
    const front = drawable(question, rows)
                      .filter((row) => row[question.front])
                      .sort((a, b) => a.ns_per_ball_second - b.ns_per_ball_second);
    return `${question.caption}. On the front: ` +
           (front.map((row) => `${rowName(row)} at ${time(row.ns_per_ball_second)}`).join('; ') || 'nothing');
  }

  /** A figure and the function that draws it, which may be called again. */
  function workFigure(key, rows) {
    const question = questions[key];
    const c = parts.canvas(describe(question, rows));
    c.dataset.plot = key;
    const config = () => workConfig(key, rows);
    const caption = el('figcaption', null, question.caption, el('small', null, question.note));
    if (!config())
      return {
        figure: el('figure', null, caption, parts.nothing(`${question.caption}: nothing was measured.`)),
        draw: () => {}
      };
    return {
      figure: el('figure', null, caption, parts.frame(c), el('p', {class: 'note'}, question.remark)),
      draw: () => parts.draw(c, config())
    };
  }

  /** All settings as a table, for those who cannot see the plots or want the figures. */
  function settingsTable(scene) {
    const rows = Data.workOf(scene);
    if (rows.length === 0) return null;
    const heads = [
      ['time', 'per ball and second (95% interval)'], ['direction error', 'rad (degrees), p95'],
      ['tunneled', '% (95% interval)'], ['missed', '%'], ['contacts', ''],
      ['proof', 'lost in further impacts'], ['on the front of', '']
    ];
    const body =
        rows.map((row) => el('tr', null, el('th', {scope: 'row'}, Data.tag(row.engine)),
                             el('th', {scope: 'row'}, isExact(row) ? '' : row.label ?? ''), [
                               withInterval(time(row.ns_per_ball_second),
                                            list(row.ns_per_ball_second_interval).map(time).join(dash)),
                               bothAngles(isExact(row) ? 0 : row.direction_error_p95),
                               rateWithInterval(tunneledOf(row)),
                               rate(row.miss_rate),
                               count(row.contacts),
                               proofText(row),
                               [row.front_by_error ? 'error' : null, row.front_by_misses ? 'tunneling' : null]
                                   .filter(Boolean)
                                   .join(', '),
                             ].map((text) => el('td', null, text))));
    return el(
        'div', null, el('h3', null, 'The same as a table'),
        el('div', {class: 'scroll', tabindex: '0', role: 'region', 'aria-label': 'All settings'},
           el('table', null,
              el('thead', null,
                 el('tr', null,
                    ['engine', 'setting'].map((name) => el('th', {scope: 'col', class: 'name'}, name)),
                    heads.map(([head, unit]) => el('th', {scope: 'col'}, head, el('small', null, unit))))),
              el('tbody', null, body))));
  }

  return {workFigure, settingsTable};
})();
