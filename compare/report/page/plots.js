// SPDX-License-Identifier: MIT
// Work against precision: what each setting of each engine costs, and how exact it is.
const Plots = (() => {
  const {
    el,
    num,
    plain,
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

  /** What zero means: how many impacts the settings without a loss have met. */
  function noneIn(rows) {
    const counts =
        rows.filter((row) => !isExact(row) && row.tunneled_rate.count === 0).map((row) => row.contacts);
    if (counts.length === 0) return '0';
    const least = Math.min(...counts);
    return `none in ${Math.max(...counts) > least ? '\u2265\u00a0' : ''}${Format.count(least)}`;
  }

  // The two questions that are put to every setting.
  const questions = {
    error: {
      title: 'Direction error after an impact (rad, p95)',
      caption: 'Error against time',
      note: 'how far off the ball flies, 95th percentile; down and left is better',
      value: (row) => row.direction_error_p95,
      front: 'front_by_error',
      floorName: () => '0',
    },
    tunneled: {
      title: 'Impacts that tunnel (%)',
      caption: 'Tunneling against time',
      note: 'share of impacts at which the ball passes; bars are 95% intervals',
      value: (row) => (row.tunneled_rate && isNumber(row.tunneled_rate.count) && row.contacts > 0
                           ? row.tunneled_rate.rate ?? row.tunneled_rate.count / row.contacts
                           : null),
      range: (row) => [row.tunneled_rate.low, row.tunneled_rate.high],
      front: 'front_by_misses',
      floorName: noneIn,
    },
  };

  const valueOf = (question, row) => (isExact(row) ? 0 : question.value(row));
  const drawable = (question, rows) =>
      rows.filter((row) => row.ns_per_ball_second > 0 && isNumber(row.ns_per_ball_second) &&
                           isNumber(valueOf(question, row)));

  function shortName(row) {
    if (isExact(row)) return 'exact';
    const steps = row.settings?.substeps;
    return row.engine === 'native' && isNumber(steps) ? `\u00d7${steps}` : row.label;
  }

  function toPoint(question, row, floor) {
    const value = valueOf(question, row);
    const times = row.ns_per_ball_second_interval;
    const range = question.range && !isExact(row) ? question.range(row) : null;
    const isFront = Boolean(row[question.front]);
    return {
      x: row.ns_per_ball_second,
      y: value > floor ? value : floor,
      row,
      isFront,
      xs: Array.isArray(times) && isNumber(times[0]) && isNumber(times[1]) ? times : null,
      ys: range && range.every(isNumber) ? range : null,
      name: isFront || row.engine === 'native' || isExact(row) ? shortName(row) : null,
    };
  }

  const pointStyles = {native: 'circle', box2d: 'rect', exact: 'star'};

  function series(engine, points, isSmall) {
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
      pointBorderWidth: engine === 'exact' ? 2.5 : 1.8,
      pointStyle: pointStyles[engine] ?? 'triangle',
      pointRadius: (isSmall ? 2.5 : 4.5) + (engine === 'exact' ? 2 : 0),
      pointHoverRadius: 8,
      showLine: engine === 'native',
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

  const rowName = (row) => (isExact(row) || !row.label ? row.engine : `${row.engine}: ${row.label}`);
  function tooltip(row) {
    const n = row.contacts;
    const lines =
        [`time ${time(row.ns_per_ball_second)}` +
         (row.ns_per_ball_second_interval ? ` (${row.ns_per_ball_second_interval.map(time).join(' to ')})`
                                          : '')];
    if (!isExact(row)) {
      lines.push(`direction error, p95: ${num(row.direction_error_p95)} rad`);
      for (const [name, r] of [['tunneled', row.tunneled_rate], ['missed', row.miss_rate]]) {
        if (!r || !(n > 0)) continue;
        const range = rateInterval(r, n);
        lines.push(`${name}: ${rate(r, n)} %${range ? ` (${range})` : ''}, ${r.count} of ${n}`);
      }
    }
    if (row.front_by_error) lines.push('on the front of error');
    if (row.front_by_misses) lines.push('on the front of tunneling');
    return lines;
  }

  function floorBelow(question, rows) {
    const positive = rows.map((row) => valueOf(question, row)).filter((v) => v > 0);
    const lows = question.range ? rows.filter((r) => !isExact(r)).map((r) => 1 / r.contacts) : [];
    const smallest = Math.min(...positive, ...lows);
    return parts.niceBelow((Number.isFinite(smallest) ? smallest : 1e-3) / 2.5);
  }

  /** Work against precision; null where no setting of the scene has a time and a value. */
  function workConfig(key, allRows, isSmall) {
    const question = questions[key];
    const rows = drawable(question, allRows);
    if (rows.length === 0) return null;
    const floor = floorBelow(question, rows);
    const points = rows.map((row) => toPoint(question, row, floor));
    const engines = [...new Set(rows.map((row) => row.engine))];
    const xs = points.map((p) => p.x);
    const highest = Math.max(...points.map((p) => Math.max(p.y, p.ys?.[1] ?? 0)), floor * 10);
    const yLabel = (v) => plain(key === 'tunneled' ? 100 * v : v);
    // Below a hundredth, decades only, as powers: zeros are hard to count.
    const yTick = (v) => (v > 0.0099 || key === 'tunneled'     ? yLabel(v)
                          : Math.abs(Math.log10(v) % 1) < 1e-6 ? power(Math.round(Math.log10(v)))
                                                               : null);
    return {
      type: 'scatter',
      data: {
        datasets: [
          ...engines.map((name) => series(name, points.filter((p) => p.row.engine === name), isSmall)),
          frontSeries(points)
        ]
      },
      plugins: isSmall ? [parts.floorLine] : [parts.floorLine, parts.intervals, parts.pointNames],
      options: {
        interaction: {mode: 'nearest', intersect: true},
        events: isSmall ? [] : undefined,
        plugins: {
          floorLine: {y: floor},
          legend: {display: !isSmall, labels: {usePointStyle: true, boxHeight: 7}},
          tooltip: {
            filter: (item) => Boolean(item.raw.row),
            callbacks: {
              title: ([item]) => (item ? rowName(item.raw.row) : ''),
              label: (item) => tooltip(item.raw.row)
            },
          },
        },
        scales: {
          x: parts.logAxis(isSmall ? '' : 'Computing time per simulated second and ball',
                           parts.niceBelow(Math.min(...xs) / 1.25), parts.niceAbove(Math.max(...xs) * 1.25),
                           plainTime, {isSmall}),
          y: parts.logAxis(isSmall ? '' : question.title, floor,
                           Math.max(parts.niceAbove(highest * 1.1), floor * 10), yTick,
                           {floorLabel: isSmall ? '0' : question.floorName(rows), isSmall}),
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
    const config = () => workConfig(key, rows, false);
    const caption = el('figcaption', null, question.caption, el('small', null, question.note));
    if (!config())
      return {
        figure: el('figure', null, caption, parts.nothing('No settings were measured for this scene.')),
        draw: () => {}
      };
    return {figure: el('figure', null, caption, parts.frame(c)), draw: () => parts.draw(c, config())};
  }

  function smallWorkFigure(scene) {
    const rows = Data.workOf(scene);
    if (!workConfig('error', rows, true)) return null;
    const c = parts.canvas(describe(questions.error, rows));
    c.dataset.plot = 'small';
    const link = el('a', {href: `#scene=${encodeURIComponent(scene.name)}`, 'data-go': ''}, scene.name);
    return {
      figure: el('figure', null, el('figcaption', null, link), parts.frame(c)),
      draw: () => parts.draw(c, workConfig('error', rows, true)),
    };
  }

  /** All settings as a table, for those who cannot see the plots or want the figures. */
  function settingsTable(scene) {
    const rows = Data.workOf(scene);
    if (rows.length === 0) return null;
    const heads = [
      ['time', 'per ball and second (95% interval)'], ['direction error', 'rad, p95'],
      ['tunneled', '% (95% interval)'], ['missed', '%'], ['contacts', ''], ['on the front of', '']
    ];
    const body =
        rows.map((row) => el('tr', null, el('th', {scope: 'row'}, Data.tag(row.engine)),
                             el('th', {scope: 'row'}, isExact(row) ? '' : row.label ?? ''), [
                               withInterval(time(row.ns_per_ball_second),
                                            list(row.ns_per_ball_second_interval).map(time).join(dash)),
                               num(isExact(row) ? 0 : row.direction_error_p95),
                               rateWithInterval(row.tunneled_rate, row.contacts),
                               rate(row.miss_rate, row.contacts),
                               Format.count(row.contacts),
                               [row.front_by_error ? 'error' : null, row.front_by_misses ? 'tunneling' : null]
                                   .filter(Boolean)
                                   .join(', '),
                             ].map((text) => el('td', null, text))));
    return el(
        'details', null, el('summary', null, 'All settings as a table'),
        el('div', {class: 'scroll'},
           el('table', null,
              el('thead', null,
                 el('tr', null,
                    ['engine', 'setting'].map((name) => el('th', {scope: 'col', class: 'name'}, name)),
                    heads.map(([head, unit]) => el('th', {scope: 'col'}, head, el('small', null, unit))))),
              el('tbody', null, body))));
  }

  return {workFigure, smallWorkFigure, settingsTable};
})();
