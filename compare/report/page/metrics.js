// SPDX-License-Identifier: MIT
// Every figure of one scene in one table, engines side by side.
const Metrics = (() => {
  const {
    el,
    num,
    plain,
    signed,
    angle,
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
  const asRate = (key) => (e) => [`${count(e[key]?.count)}: `, rateWithInterval(e[key], e.contacts)];
  const asSummary = (key) => (e) => summaryText(e[key], num);
  const asAngles = (key) => (e) => summaryText(e[key], angle);
  const asSigned = (key) => (e) => summaryText(e[key], num, signed);
  const asChange = (key) => (e) => change(e[key]);

  // Group, then name, unit and cell of each row.
  const metrics = [
    [
      'Outcomes',
      [
        ['contacts', '', asCount('contacts')],
        ['correct', '', asCount('correct')],
        ['late', '', asCount('late')],
        ['missed', 'count: % (95% interval)', asRate('missed')],
        ['wrong side', 'count: % (95% interval)', asRate('wrong_side')],
        ['tunneled', 'count: % (95% interval)', asRate('tunneled')],
        ['overlapped', 'count: % (95% interval)', asRate('overlapped')],
        [
          'ghost', 'count: % of quiet steps',
          (e, scene) => [`${count(e.ghost?.count)}: `, rateWithInterval(e.ghost, scene.quiet_steps)]
        ],
      ]
    ],
    [
      'What CollisionDetected claims (the same in every profile of Box2D): median / p95 / max',
      [
        ['setback', 'radii', asSummary('setback')],
        ['setback error', 'radii', asSummary('setback_error')],
        ['along the normal, out is +', 'radii', asSigned('setback_error_normal')],
        ['in time, late is +', 'steps', asSigned('time_error')],
      ]
    ],
    [
      'Correct responses against the exact ones: median / p95 / max',
      [
        ['place of the impact', 'radii', asSummary('poi_error')],
        ['normal', 'rad', asAngles('normal_error')],
        ['direction', 'rad', asAngles('direction_error')],
        ['speed', 'relative', asSigned('speed_error')],
        ['energy', 'relative', asSigned('energy_error')],
        ['position', 'radii', asSummary('position_error')],
        ['penetration (all that did not tunnel)', 'radii', asSummary('penetration')],
      ]
    ],
    [
      'Long run',
      [
        ['bounces', '', asCount('bounces')],
        ['energy drift', '% or factor over these bounces', asChange('energy_drift')],
        ['free path error', '%', asChange('free_path_error')],
        ['angular momentum drift', '% over these bounces', asChange('angular_momentum_drift')],
      ]
    ],
    [
      'Cost',
      [
        [
          'time', 'ns per ball-step (95% interval)',
          (e) => withInterval(num(e.ns_per_ball_step), interval(e.ns_per_ball_step_interval))
        ],
        ['time', 'ns per contact', (e) => num(e.ns_per_contact)],
        ['simulated', 's', (e) => num(e.simulated_seconds)],
        ['escaped', 'balls', asCount('escaped')],
        ['not finite', 'balls', asCount('not_finite')],
      ]
    ],
  ];

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
    return el('div', null, el('h3', null, 'All figures'),
              el('div', {class: 'scroll'},
                 el('table', {'data-metrics': ''},
                    el('thead', null,
                       el('tr', null, el('th'), el('th'),
                          engines.map((e) => el('th', {scope: 'col'}, Data.tag(e.name))))),
                    el('tbody', null, [...metrics, ...settingRows(engines)].flatMap(group)))),
              setAside(scene));
  }

  function setAside(scene) {
    const s = scene.set_aside ?? {};
    const parts = ['resting', 'ambiguous', 'simultaneous', 'approximate', 'undecided']
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
