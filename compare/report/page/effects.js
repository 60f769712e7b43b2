// SPDX-License-Identifier: MIT
// The cost of each effect in a scene, and the changes where it is forced or forbidden.
const Effects = (() => {
  const {el, num, bothAngles, rate, percent, dash, isNumber} = Format;
  const {list} = Data;

  const nameOf = (effect) => String(effect ?? dash).replaceAll('_', ' ');
  const isCalledFor = (row) => row.runs > 0;

  function runs(row) {
    if (!isNumber(row.runs)) return dash;
    if (!isCalledFor(row)) return 'no';
    return row.runs > 0.9995 ? 'always' : `in ${percent(row.runs)}% of the substeps`;
  }

  /** "+12%", "-3%": by how much more there is with it than without it. */
  const more = (ratio) =>
      (isNumber(ratio) ? `${ratio < 1 ? '\u2212' : '+'}${num(100 * Math.abs(ratio - 1))}%` : dash);
  function time(row) {
    const [low, high] = list(row.ns_ratio_interval);
    if (!isNumber(low) || !isNumber(high)) return more(row.ns_ratio);
    const isTold = low > 1 || high < 1;
    return [
      isTold ? more(row.ns_ratio) : 'none', ' ',
      el('span', {class: 'interval'}, `(${more(low)} to ${more(high)})`)
    ];
  }
  function instructions(row) {
    const a = row.with?.instructions_per_ball_step, b = row.without?.instructions_per_ball_step;
    if (!isNumber(a) || !isNumber(b)) return dash;
    return [a === b ? 'none' : more(a / b), ' ', el('span', {class: 'interval'}, `(${num(a)} / ${num(b)})`)];
  }

  /** The text of a world's figures; one value where both have the same. */
  function figure(row, scene, of) {
    const [a, b] = [row.with, row.without].map((world) => (world ? of(world, scene) : dash));
    return el('td', {class: a === b ? null : 'differs'}, a === b ? a : `${a} / ${b}`);
  }

  const isCounted = (row) => isNumber(row.with?.instructions_per_ball_step);
  // Head, unit, cell, and where there is anything to be shown.
  const columns = [
    {head: 'time', unit: 'more with it (interval)', cell: (row) => el('td', null, time(row))},
    {
      head: 'instructions',
      unit: 'more with it (per ball-step)',
      cell: (row) => el('td', null, instructions(row)),
      isThere: (rows) => rows.some(isCounted)
    },
    {
      head: 'lost',
      unit: '%',
      cell: (row, scene) => figure(row, scene, (world) => rate(world.tunneled))
    },
    {
      head: 'flight error',
      unit: 'radii, p95',
      cell: (row, scene) => figure(row, scene, (world) => num(world.flight_error?.p95))
    },
    {
      head: 'direction error',
      unit: 'rad (degrees), p95',
      cell: (row, scene) => figure(row, scene, (world) => bothAngles(world.direction_error?.p95))
    },
    {
      head: 'speed error',
      unit: '%, p95',
      cell: (row, scene) => figure(row, scene, (world) => percent(world.speed_error?.p95))
    },
    {
      head: 'touches missed',
      unit: '%',
      cell: (row, scene) => figure(row, scene, (world) => rate(world.touches_missed)),
      isThere: (rows, scene) => scene.sensor_touches > 0
    },
  ];

  const tableRow = (row, scene, shown) =>
      el('tr', {class: isCalledFor(row) ? null : 'uncalled', 'data-effect': row.effect},
         el('th', {scope: 'row'}, nameOf(row.effect)),
         el('td', {class: 'why'}, runs(row), el('small', null, row.why ?? '')),
         shown.map((column) => column.cell(row, scene)));

  function table(scene) {
    const rows = list(Data.run.effects).filter((row) => row.scene === scene.name);
    if (rows.length === 0) return null;
    const shown = columns.filter((column) => column.isThere?.(rows, scene) ?? true);
    const engines = [...new Set(rows.map((row) => row.engine))];
    const group = (engine) => [el('tr', {class: 'group'},
                                  el('th', {colspan: 2 + shown.length, scope: 'rowgroup'}, Data.tag(engine))),
                               ...rows.filter((row) => row.engine === engine)
                                   .map((row) => tableRow(row, scene, shown))];
    return el(
        'div', null,
        el('div', {class: 'scroll', tabindex: '0', role: 'region', 'aria-label': 'Cost of effects'},
           el('table', {class: 'overview', 'data-effects': ''},
              el('thead', null,
                 el('tr', null,
                    ['effect', 'runs'].map((name) => el('th', {scope: 'col', class: 'name'}, name)),
                    shown.map(({head, unit}) => el('th', {scope: 'col'}, head, el('small', null, unit))))),
              el('tbody', null, engines.map(group)))),
        el('p', {class: 'note'},
           'A world runs only the effects that its content calls for. Those in grey it does not run: what they ' +
               'cost, they cost only if they are forced. The others can be forbidden, which saves their time; what ' +
               'the balls do then is on the right, with the effect / without it where that differs: impacts ' +
               'lost, how far off they fly until their first impact, direction and speed after an impact. ' +
               '"none": cannot be told from nothing. Without events nobody tells of impacts to judge; the balls ' +
               'fly the same ways.',
           scene.not_counted ? ` Instructions were not counted: ${scene.not_counted}.` : ''));
  }

  return {table};
})();
