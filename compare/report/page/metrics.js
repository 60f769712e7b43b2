// SPDX-License-Identifier: MIT
// Every figure of one scene in one table, engines side by side.
const Metrics = (() => {
  const {
    el,
    num,
    plain,
    signed,
    bothAngles,
    change,
    count,
    summary,
    rateWithInterval,
    interval,
    withInterval,
    dash
  } = Format;
  const {list} = Data;

  const summaryText = (s, format, medianFormat = format) => {
    if (!s || !(s.count > 0)) return dash;
    return `${medianFormat(s.median)} / ${format(s.p95)} / ${format(s.max)}`;
  };
  const asCount = (key) => (e) => count(e[key]);

  // How a figure is drawn follows from its kind and its unit; run.json lists them.
  function figureCell({key, kind, unit, signed: isSigned}) {
    if (kind === 'rate')
      return (e) => [`${count(e[key]?.count)}: `, rateWithInterval(e[key])];
    if (kind === 'impact')
      return (e) => summaryText(e[key], unit === 'rad' ? bothAngles : num, isSigned ? signed : undefined);
    if (unit === 'change') return (e) => change(e[key]);
    if (kind === 'count') return asCount(key);
    if (key === 'ns_per_ball_step')
      return (e) => withInterval(num(e.ns_per_ball_step), interval(e.ns_per_ball_step_interval));
    return (e) => num(e[key]);
  }
  const unitText = {rate: 'count: % (95% interval)', change: '% or factor', rad: 'rad (degrees)'};
  // Rows that are no figures of their own.
  const others = {
    Outcomes: [['contacts', '', asCount('contacts')], ['correct', '', asCount('correct')]],
    'Long run': [['bounces', '', asCount('bounces')]],
    Cost: [['simulated', 's', (e) => num(e.simulated_seconds)]]
  };
  function metrics() {
    const groups = new Map();
    for (const figure of list(Data.run.figures)) {
      if (!groups.has(figure.group)) groups.set(figure.group, [...(others[figure.group] ?? [])]);
      groups.get(figure.group).push([figure.label, unitText[figure.unit] ?? figure.unit, figureCell(figure)]);
    }
    return [...groups];
  }

  function settingRows(engines) {
    const names = [...new Set(engines.flatMap((e) => Object.keys(e.settings ?? {})))];
    const words = (value) => value.join(', ').replaceAll('_', ' ') || 'none';
    const text = (value) => (Array.isArray(value)        ? words(value)
                             : typeof value === 'string' ? value
                                                         : plain(value));
    const rows = names.map((name) => [name.replaceAll('_', ' '), '', (e) => text(e.settings?.[name])]);
    return [
      ['Settings', [...rows, ['runs', '', (e) => list(e.features).join(', ').replaceAll('_', ' ') || dash]]]
    ];
  }

  function table(scene) {
    const engines = list(scene.engines);
    const group = ([
      title, rows
    ]) => [el('tr', {class: 'group'}, el('th', {colspan: 2 + engines.length, scope: 'rowgroup'}, title)),
           ...rows.map(([name, unit, cell]) => el(
                           'tr', null, el('th', {scope: 'row'}, name), el('th', {class: 'unit-cell'}, unit),
                           engines.map((engine) => el('td', null, cell(engine, scene))))),
    ];
    return el('div', null,
              el('div', {class: 'scroll', tabindex: '0', role: 'region', 'aria-label': 'All figures'},
                 el('table', {'data-metrics': ''},
                    el('thead', null,
                       el('tr', null, el('th'), el('th'),
                          engines.map((e) => el('th', {scope: 'col'}, Data.tag(e.name))))),
                    el('tbody', null, [...metrics(), ...settingRows(engines)].flatMap(group)))),
              setAside(scene));
  }

  function setAside(scene) {
    const s = scene.set_aside ?? {};
    const parts = ['resting', 'ambiguous', 'simultaneous', 'undecided']
                      .filter((k) => s[k] > 0)
                      .map((k) => `${count(s[k])} ${k}`);
    return el('p', {class: 'note'},
              parts.length ? `Seen and not judged: ${parts.join(', ')}.` : 'Every impact was judged.',
              s.first_undecided ? ` The first undecided: ${s.first_undecided}.` : '',
              scene.apart?.count > 0 ? ` What CollisionDetected claims natively and on Box2D is ${
                                           summary(scene.apart)} radii apart (median / p95).`
                                     : '');
  }

  return {table};
})();
