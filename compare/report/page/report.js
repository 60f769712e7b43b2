// SPDX-License-Identifier: MIT
// Puts the page together, and shows the scene that the address names.
const Report = (() => {
  const {el, plain, degrees, plainTime} = Format;
  const {list} = Data;
  let redraws = []; // of what is unfolded of the selected scene
  let select = null;

  function sceneOfHash() {
    const name = /^#scene=(.*)$/.exec(location.hash)?.[1];
    return Data.scenes.find((scene) => encodeURIComponent(scene.name) === name) ?? Data.scenes[0];
  }

  /**
   * A section that is made and drawn when it is first unfolded. `make` returns its elements and the function
   * that draws them.
   */
  function fold(title, make) {
    const holder = el('div');
    const details = el('details', {
      ontoggle: () => {
        if (!details.open || holder.childElementCount > 0) return;
        const {parts, draws = []} = make();
        holder.append(...parts.flat().filter(Boolean));
        redraws.push(...draws);
        redraw(draws);
      }
    },
                       el('summary', null, title), holder);
    return details;
  }

  function work(scene) {
    const rows = Data.workOf(scene);
    const plots = ['error', 'tunneled'].map((key) => Plots.workFigure(key, rows));
    return {
      parts: [
        el('div', {class: 'pair'}, plots.map((plot) => plot.figure)),
        el('p', {class: 'note'},
           'Filled marks are on the Pareto line, the broken one: nothing that was tried is both cheaper and ' +
               'better. The marks of each engine but Box2D are joined in the order of their substeps. The exact ' +
               'reference is timed too; it has no broad phase, so it is no engine for a game with many balls.'),
        Plots.settingsTable(scene),
      ],
      draws: plots.map((plot) => plot.draw)
    };
  }

  function distributions(scene) {
    const figures = [
      Histograms.figure('setback_error_histogram', scene, 'Setback error',
                        'how far off the ball is put at the impact'),
      Histograms.figure('penetration_histogram', scene, 'Penetration',
                        'how deep the ball is in the shape after the step')
    ];
    return {
      parts: [el('div', {class: 'pair'}, figures.map((f) => f.figure))],
      draws: figures.map((f) => f.draw)
    };
  }

  /** The folded sections of a scene. A new one is a row; one without content is left out. */
  const sections = [
    ['All settings: time against error', work, (scene) => Data.workOf(scene).length > 0],
    ['What became of the impacts', (scene) => ({parts: [Tables.outcomeFigure(scene), Tables.bins(scene)]})],
    [
      'Lost by speed and size of the ball', (scene) => ({parts: [Tables.heatMaps(scene)]}),
      (scene) => list(scene.heat_map?.cells).length > 0
    ],
    ['How large the errors are', distributions],
    [
      'What each effect costs', (scene) => ({parts: [Effects.table(scene)]}),
      (scene) => list(Data.run.effects).some((row) => row.scene === scene.name)
    ],
    ['All figures and settings', (scene) => ({parts: [Metrics.table(scene)]})],
  ];

  /** The engine whose worst contact says most: the one that loses most, then the one that is farthest off. */
  function worstEngine(scene) {
    const badness = (e) => [e.tunneled?.count ?? 0, e.direction_error?.p95 ?? 0];
    return [...list(scene.engines)]
        .sort((a, b) => badness(b)[0] - badness(a)[0] || badness(b)[1] - badness(a)[1])[0]
        ?.name;
  }

  function replay(scene) {
    const player = Replay.make(Data.replayOf(scene), worstEngine(scene));
    if (!player) return el('p', {class: 'note'}, 'No trajectory was recorded for this scene.');
    redraws.push(() => player.draw());
    return player.element;
  }

  /** The three demands, what meets them for the least time, and what the other engines need. */
  function answers(scene) {
    const rows = list(scene.answers);
    if (rows.length === 0) return el('p', {class: 'note'}, 'No setting was tried.');
    const setting = (choice) => [Data.tag(choice.engine), ` ${choice.label}`];
    const others =
        (row) => [row.choices.slice(1).map(
                      (c) => el('li', null, setting(c),
                                c.ns_ratio < 1.05
                                    ? ', as fast'
                                    : `, ${plain(Number(c.ns_ratio.toPrecision(2)))}\u00d7 the time`)),
                  list(row.without).map((name) => el('li', null, Data.tag(name), ': none that was tried')),
                  row.closest ? el('li', null, 'closest: ', setting(row.closest),
                                   `, ${degrees(row.closest.direction_error_p95)}`)
                              : null];
    return el('div', {class: 'scroll', tabindex: '0', role: 'region', 'aria-label': 'What to take'},
              el('table', {class: 'answers'},
                 el('thead', null,
                    el('tr', null,
                       ['if you need', 'take', 'ball-second', 'else'].map(
                           (head) => el('th', {scope: 'col'}, head)))),
                 el('tbody', null, rows.map((row) => {
                   const first = list(row.choices)[0];
                   return el('tr', null, el('th', {scope: 'row'}, Format.spoken(row.demand)),
                             el('td', null, first ? setting(first) : 'nothing that was tried'),
                             el('td', null, first ? plainTime(first.ns_per_ball_second) : Format.dash),
                             el('td', null, el('ul', null, others(row))));
                 }))));
  }

  function show(scene) {
    redraws = [];
    const chart = Data.charts.scenes?.[scene.name];
    const [use, figures] = list(scene.verdict);
    const parts = [
      el('p', {class: 'verdict'}, Format.spoken(use), figures ? [' ', Format.spoken(figures)] : ''),
      el('p', {class: 'facts'}, scene.description ?? '', ' ', Tables.facts(scene)),
      el('div', {class: 'stage-row'}, replay(scene),
         chart ? el('figure', {id: 'scene-chart'}, Summary.svg([chart])) : null),
      el('h3', null, 'What to take'),
      answers(scene),
      list(scene.remarks).length ? Format.sentences(scene.remarks) : null,
      sections.filter(([, , isThere]) => isThere?.(scene) ?? true)
          .map(([title, make]) => fold(title, () => make(scene))),
    ];
    const body = document.getElementById('scene-body');
    body.replaceChildren(...parts.flat().filter(Boolean));
    body.dataset.scene = scene.name;
    select.value = scene.name;
    for (const row of document.querySelectorAll('#matrix tr[data-scene]'))
      row.toggleAttribute('data-shown', row.dataset.scene === scene.name);
    redraw(redraws);
  }
  function redraw(list) {
    PlotParts.applyTheme();
    for (const draw of list)
      draw();
  }

  function bar() {
    const neighbour = (step) => {
      const n = Data.scenes.length, i = Data.scenes.indexOf(sceneOfHash());
      location.hash = Matrix.hashOf(Data.scenes[(i + step + n) % n].name);
    };
    select = el('select', {
      id: 'scene-select',
      'aria-label': 'Scene',
      onchange: () => { location.hash = Matrix.hashOf(select.value); }
    },
                Data.scenes.map((scene) => el('option', {value: scene.name}, scene.name)));
    document.getElementById('scene-bar')
        .append(
            el('h2', {id: 'scene-title'}, 'One scene'), select,
            el('button', {type: 'button', 'aria-label': 'Scene before', onclick: () => neighbour(-1)},
               '\u2190'),
            el('button', {type: 'button', 'aria-label': 'Next scene', onclick: () => neighbour(1)}, '\u2192'),
            el('a', {href: '#first'}, 'to the top'));
  }

  function listen() {
    window.addEventListener('hashchange', () => {
      if (location.hash === '#first')
        history.replaceState(null, '', Matrix.hashOf(select.value));
      else if (document.getElementById('scene-body').dataset.scene !== sceneOfHash().name)
        show(sceneOfHash());
    });
    document.addEventListener('click', (event) => {
      if (event.target.closest('a[data-go]')) document.getElementById('scene').scrollIntoView();
    });
    const redrawAll = () => redraw(redraws);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', redrawAll);
    // Paper is white.
    const setPrint = (on) => {
      document.documentElement.toggleAttribute('data-print', on);
      redrawAll();
    };
    window.addEventListener('beforeprint', () => setPrint(true));
    window.addEventListener('afterprint', () => setPrint(false));
  }

  function start() {
    Summary.show();
    Matrix.show();
    if (Data.scenes.length > 0) {
      bar();
      show(sceneOfHash());
      listen();
    } else {
      document.getElementById('scene').remove();
    }
    document.documentElement.dataset.ready = '';
  }
  return {start};
})();
Report.start();
