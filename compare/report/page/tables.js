// SPDX-License-Identifier: MIT
// Tables of one scene: outcomes, heat maps, and bins.
const Tables = (() => {
  const {el, num, plain, count, summary, angles, rate, rateWithInterval, dash, isNumber} = Format;
  const {list} = Data;

  const outcomes = [
    {key: 'correct', name: 'correct', style: 'outcome-correct', of: (e) => e.correct},
    {key: 'late', name: 'late', style: 'outcome-late', of: (e) => e.late?.count},
    {key: 'wrong', name: 'wrong side', style: 'outcome-wrong', of: (e) => e.wrong_side?.count},
    {key: 'missed', name: 'missed', style: 'outcome-missed', of: (e) => e.missed?.count},
  ];

  const share = (n, total) => (total > 0 && isNumber(n) ? `${rate({count: n, of: total})}%` : dash);

  function outcomeRow(engine, scene) {
    const shown = outcomes.filter((o) => o.of(engine) > 0);
    const bar = el('div', {
      class: 'stack',
      role: 'img',
      'aria-label': shown.map((o) => `${o.name} ${count(o.of(engine))}`).join(', ')
    },
                   shown.map((o) => {
                     const part = el('span', {class: o.style, title: `${o.name}: ${count(o.of(engine))}`});
                     part.style.flexGrow = o.of(engine);
                     return part;
                   }));
    const item = (o, n, total, unit) => el('li', null, el('span', {class: `swatch ${o.style}`}),
                                           `${o.name} ${count(n)} (${share(n, total)}${unit})`);
    return el('div', {'data-outcomes': engine.name}, Data.tag(engine.name), bar,
              el('ul', {class: 'counts'}, outcomes.map((o) => item(o, o.of(engine), engine.contacts, '')),
                 item({name: 'ghost', style: 'outcome-ghost'}, engine.ghost?.count, scene.quiet_steps,
                      ' of quiet steps')));
  }

  function outcomeFigure(scene) {
    const engines = list(scene.engines).filter((e) => e.contacts > 0);
    return el(
        'figure', null,
        el('figcaption', null, 'What happened at the impacts',
           el('small', null, 'the bar is all contacts; parts too small to be seen are drawn 3 pixels wide')),
        engines.length ? el('div', {class: 'outcomes'}, engines.map((e) => outcomeRow(e, scene)))
                       : el('p', {class: 'note'}, 'There was no contact in this scene.'));
  }

  /** None seen in n is below 3 in n at 95%. */
  const noneIn = (n) => (n > 3 ? `< ${Number((300 / n).toPrecision(2))}%` : `0 of ${n}`);

  function heatCell(cell, e, travel, isFirstFar) {
    const n = cell?.contacts ?? 0;
    const k = list(cell?.tunneled)[e];
    const classes = [isFirstFar ? 'far' : null];
    if (!(n > 0) || !isNumber(k))
      return el('td', {class: [...classes, 'empty'].filter(Boolean).join(' '), title: 'no contacts'}, dash);
    const percentage = 100 * k / n;
    // Colour by the root: the step from none to few matters more than that from many to most. Middle tones,
    // on which neither ink is easy to read, are left out.
    const root = 10 * Math.sqrt(percentage), isStrong = root > 50;
    if (isStrong) classes.push('strong');
    const where = isNumber(travel) ? `, ${num(travel)} radii per step` : '';
    return el('td', {
      class: classes.filter(Boolean).join(' ') || null,
      '--share': (isStrong ? 70 + 0.6 * (root - 50) : 0.9 * root).toFixed(1),
      title: `${count(k)} of ${count(n)} tunneled${where}`
    },
              k > 0 ? percentage >= 99.95 ? '100' : percentage.toPrecision(2) : noneIn(n));
  }

  function heatMap(map, engine, e) {
    const speeds = list(map.speeds), sizes = list(map.sizes);
    const travelAt = (size, speed) => (isNumber(map.travel) ? map.travel * speed / size : null);
    const row = (size, i) => {
      const far = speeds.findIndex((speed) => travelAt(size, speed) > 1);
      return el('tr', null, el('th', {scope: 'row'}, `\u00d7${plain(size)}`),
                speeds.map((speed, j) => heatCell(list(map.cells)[i * speeds.length + j], e,
                                                  travelAt(size, speed), j === far && j > 0)));
    };
    return el('figure', {class: 'heatmap'}, el('figcaption', null, Data.tag(engine.name)),
              el('div',
                 {class: 'scroll', tabindex: '0', role: 'region', 'aria-label': `Lost on ${engine.name}`},
                 el('table', {'data-heat': engine.name},
                    el('thead', null,
                       el('tr', null, el('th', null, 'size \\ speed'),
                          speeds.map((s) => el('th', {scope: 'col'}, `\u00d7${plain(s)}`)))),
                    el('tbody', null, sizes.map(row)))));
  }

  function heatMaps(scene) {
    if (list(scene.heat_map?.cells).length === 0) return null;
    // Where shapes move too, the way of the ball is not what counts.
    const map =
        list(scene.features).includes('kinematics') ? {...scene.heat_map, travel: null} : scene.heat_map;
    const travel = isNumber(map.travel)
                       ? ` At \u00d71 the fastest ball moves ${
                             num(map.travel)} radii per step; right of the double line it is more than one.`
                       : '';
    return el(
        'div', null,
        el('p', {class: 'note'},
           `In % of the impacts; factors on what the scene says.${
               travel} "<": none lost, below 3 in n at 95%. ` +
               'A dash: no contacts there.'),
        el('div', {class: 'heatmaps'}, list(scene.engines).map((engine, e) => heatMap(map, engine, e))));
  }

  const binTitles = {
    travel: 'by way per step',
    incidence: 'by angle of incidence',
    pair: 'by what was met',
    elasticity: 'by elasticity'
  };

  function bins(scene) {
    const engines = list(scene.engines).filter((e) => list(e.bins).length > 0);
    if (engines.length === 0) return null;
    const keys = new Map();
    for (const bin of engines.flatMap((e) => e.bins))
      keys.set(`${bin.by}\n${bin.label}`, bin);
    const find = (engine, {by, label}) =>
        engine.bins.find((bin) => bin.by === by && bin.label === label) ?? {};
    const columns = [
      ['tunneled', '%', (bin) => rateWithInterval(bin.tunneled)],
      ['setback error', 'radii, median / p95', (bin) => summary(bin.setback_error)],
      ['direction error', 'rad (degrees), median / p95', (bin) => angles(bin.direction_error)],
    ];
    const row = (bin, engine, i) => {
      const rowspan = engines.length;
      const head = [
        el('th', {rowspan, scope: 'rowgroup'}, bin.label),
        el('td', {rowspan}, count(bin.contacts)),
      ];
      const cells = columns.map(([, , cell]) => el('td', null, cell(find(engine, bin))));
      return el('tr', {class: i === 0 ? 'first' : null}, i === 0 ? head : null,
                el('th', {scope: 'row', class: 'second'}, Data.tag(engine.name)), cells);
    };
    let group = null;
    const rows = [...keys.values()].flatMap((bin) => {
      const title = el('th', {colspan: 3 + columns.length, scope: 'rowgroup'}, binTitles[bin.by] ?? bin.by);
      const isFirst = bin.by !== group;
      group = bin.by;
      const own = engines.map((engine, i) => row(bin, engine, i));
      return isFirst ? [el('tr', {class: 'group'}, title), ...own] : own;
    });
    const heads = columns.map(([head, unit]) => el('th', {scope: 'col'}, head, el('small', null, unit)));
    return el('div', null, el('h3', null, 'Where it goes wrong'),
              el('div', {class: 'scroll', tabindex: '0', role: 'region', 'aria-label': 'Impacts by kind'},
                 el('table', {'data-bins': ''},
                    el('thead', null,
                       el('tr', null, el('th'), el('th', {scope: 'col'}, 'contacts'),
                          el('th', {scope: 'col', class: 'name'}, 'engine'), heads)),
                    el('tbody', null, rows))));
  }

  const some = (n, name) => (isNumber(n) ? `${count(n)} ${name}${n === 1 ? '' : 's'}` : null);
  function facts(scene) {
    const gravity =
        list(scene.gravity).every(isNumber) && list(scene.gravity).length === 2 ? scene.gravity : null;
    return [
      isNumber(scene.time_step) ? `step ${num(1000 * scene.time_step)} ms` : null,
      gravity ? `gravity (${gravity.map(num).join(', ')})` : null,
      some(scene.shapes, 'shape'),
      some(scene.balls, 'ball'),
      some(scene.trials, 'random trial'),
      list(scene.features).length ? `with ${scene.features.join(', ').replaceAll('_', ' ')}` : null,
    ].filter(Boolean)
        .join(' \u00b7 ');
  }

  return {outcomeFigure, heatMaps, bins, facts};
})();
