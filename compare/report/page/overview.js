// SPDX-License-Identifier: MIT
// What is above the single scenes: where the figures come from, verdicts, one table of all scenes.
const Overview = (() => {
  const {
    el,
    num,
    count,
    change,
    rate,
    rateWithInterval,
    summary,
    angles,
    interval,
    withInterval,
    dash,
    isNumber
  } = Format;
  const {list} = Data;

  const link = (scene) =>
      el('a', {href: `#scene=${encodeURIComponent(scene.name)}`, 'data-go': ''}, scene.name);

  function provenance(run) {
    const machine = run.machine ?? {};
    const facts = [
      isNumber(run.contacts_per_scene) ? `${count(run.contacts_per_scene)} contacts a scene` : null,
      isNumber(run.seed) ? `seed ${run.seed}` : null,
      machine.shapes ? `Shapes ${machine.shapes}` : null,
      machine.box2d ? `Box2D ${machine.box2d}` : null,
      machine.compiler,
      machine.cpu && isNumber(machine.cores) ? `${machine.cpu}, ${machine.cores} cores` : machine.cpu,
    ].filter(Boolean);
    return [
      el('p', {class: 'provenance'}, el('code', null, run.command ?? 'command unknown'),
         ` ${dash} ${facts.join('; ')}`),
      run.interrupted ? el('p', {class: 'warning', id: 'interrupted'},
                           'This run was interrupted: only the scenes that were finished are here.')
                      : null,
    ];
  }

  function card(scene) {
    return el('article', {class: 'card'}, el('h3', null, link(scene)),
              el('p', {class: 'description'}, scene.description ?? ''), Format.sentences(scene.verdict));
  }

  const rateRange = (engine, key) => {
    const r = engine[key];
    return r && engine.contacts > 0 && isNumber(r.low) && isNumber(r.high) ? [r.low, r.high] : null;
  };
  /** Better is said only where the intervals leave no doubt. */
  function isBetter(scene, engine, rangeOf) {
    const mine = rangeOf(engine);
    const rest = list(scene.engines).filter((other) => other !== engine).map(rangeOf);
    return Boolean(mine) && rest.length > 0 && rest.every((range) => range && mine[1] < range[0]);
  }

  /** A summary of fewer than all contacts says of how many. */
  const ofSome = (text, n, all) =>
      (n > 0 && n < all ? [text, ' ', el('span', {class: 'interval'}, `of ${count(n)}`)] : text);

  // Every column: head, unit, cell, and the interval by which it is judged.
  const columns = [
    {head: 'contacts', unit: '', cell: (e) => count(e.contacts)},
    {head: 'missed', unit: '%', cell: (e) => rate(e.missed, e.contacts)},
    {
      head: 'tunneled',
      unit: '% (interval)',
      range: (e) => rateRange(e, 'tunneled'),
      cell: (e) => rateWithInterval(e.tunneled, e.contacts)
    },
    {head: 'ghost', unit: '% of quiet steps', cell: (e, scene) => rate(e.ghost, scene.quiet_steps)},
    {
      head: 'setback error',
      unit: 'radii, median / p95',
      cell: (e) => ofSome(summary(e.setback_error), e.setback_error?.count, e.contacts)
    },
    {head: 'direction error', unit: 'rad, median / p95', cell: (e) => angles(e.direction_error)},
    {
      head: 'energy drift',
      unit: '% or factor (bounces)',
      cell: (e) => (isNumber(e.energy_drift) ? `${change(e.energy_drift)} (${count(e.bounces)})` : dash)
    },
    {
      head: 'time',
      unit: 'ns per ball-step (interval)',
      range: (e) => e.ns_per_ball_step_interval ?? null,
      cell: (e) => withInterval(num(e.ns_per_ball_step), interval(e.ns_per_ball_step_interval))
    },
  ];

  function row(scene, engine, i) {
    const name = i === 0 ? el('th', {scope: 'rowgroup', rowspan: scene.engines.length}, link(scene)) : null;
    const cells = columns.map(
        (column) => el('td', {class: column.range && isBetter(scene, engine, column.range) ? 'better' : null},
                       column.cell(engine, scene)));
    return el('tr', {class: i === 0 ? 'first' : null}, name, el('th', {scope: 'row'}, Data.tag(engine.name)),
              cells);
  }

  function table(scenes) {
    const head =
        columns.map((column) => el('th', {scope: 'col'}, column.head, el('small', null, column.unit)));
    const names = ['scene', 'engine'].map((name) => el('th', {scope: 'col', class: 'name'}, name));
    return [
      el('div', {class: 'scroll', tabindex: '0', role: 'region', 'aria-label': 'Table of all scenes'},
         el('table', {class: 'overview'}, el('thead', null, el('tr', null, names, head)),
            el('tbody', null,
               scenes.map((scene) => list(scene.engines).map((engine, i) => row(scene, engine, i)))))),
      el('p', {class: 'note'},
         'Shaded: better than every other engine, and the 95% intervals do not overlap. ' +
             '"<" stands for none seen in n: below 3 in n at 95%. p95 is the 95th percentile. ' +
             'Setback errors are of the pairs that the engine\u2019s CollisionDetected saw ("of" how many, where ' +
             'these are not all contacts), and the same in every profile of Box2D; direction errors are of the ' +
             'balls that were turned back.'),
    ];
  }

  const terms = [
    ['missed', 'The ball met a shape and the engine did nothing.'],
    ['wrong side', 'The engine responded, but pushed the ball through to the far side.'],
    ['tunneled', 'Missed or wrong side: the exact ball was turned back and this one went on.'],
    ['late', 'Responded rightly, one or two steps after the step of the impact.'],
    ['ghost', 'A response although the exact ball touches nothing.'],
    [
      'setback error',
      'How far from its real place the engine puts the ball at the impact, in radii of the ball.'
    ],
    [
      'direction error',
      'Angle between the velocity after the impact and the exact one. 0.01 rad is 0.57 degrees.'
    ],
    [
      'energy drift',
      'Energy gained or lost in a long run that should keep all of it, over its own bounces; \u00d73 where three ' +
          'times as much is left.'
    ],
    [
      'ball-step', 'One step of the world for one ball. 60 steps a second with 100 balls are 6000 ball-steps.'
    ],
  ];
  const glossary = () =>
      el('details', null, el('summary', null, 'What the words mean'),
         el('dl', null, terms.flatMap(([term, meaning]) => [el('dt', null, term), el('dd', null, meaning)])));

  function show() {
    document.getElementById('provenance').replaceChildren(...provenance(Data.run).filter(Boolean));
    const cards = document.getElementById('verdict-cards');
    if (Data.scenes.length === 0)
      cards.append(el('p', null, 'No scene was finished.'));
    else
      cards.append(...Data.scenes.map(card));
    document.getElementById('overview-table').append(...table(Data.scenes), glossary());
  }
  return {show};
})();
