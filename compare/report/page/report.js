// SPDX-License-Identifier: MIT
// Puts the page together, and shows the scene that the address names.
const Report = (() => {
  const {el} = Format;
  let redraws = []; // of the selected scene
  const smallRedraws = [];
  let select = null;

  const hashOf = (name) => `#scene=${encodeURIComponent(name)}`;
  function sceneOfHash() {
    const name = /^#scene=(.*)$/.exec(location.hash)?.[1];
    return Data.scenes.find((scene) => encodeURIComponent(scene.name) === name) ?? Data.scenes[0];
  }

  function work(scene) {
    const rows = Data.workOf(scene);
    const plots = ['error', 'tunneled'].map((key) => Plots.workFigure(key, rows));
    redraws.push(...plots.map((plot) => plot.draw));
    const answers = Data.list(scene.answers);
    return [
      el('h3', null, 'Work against precision'),
      el('div', {class: 'trio'}, plots.map((plot) => plot.figure),
         el('aside', {class: 'answers'}, el('h3', null, 'What to take'),
            answers.length ? Format.sentences(answers) : el('p', null, 'No setting was tried.'),
            el('p', {class: 'note'},
               'Filled points are on the Pareto front, the broken line: nothing that was tried is both cheaper ' +
                   'and better. ' +
                   'The points of native, and of native-continuous, are joined in the order of their substeps.'),
            el('p', {class: 'note'},
               'The exact reference is timed too; it has no broad phase, so it is no engine for a game with many ' +
                   'balls.'))),
      Plots.settingsTable(scene),
    ];
  }

  function distributions(scene) {
    const setback = Histograms.figure('setback_error_histogram', scene, 'Setback error',
                                      'how far off the ball is put at the impact');
    const penetration = Histograms.figure('penetration_histogram', scene, 'Penetration',
                                          'how deep the ball is in the shape after the step');
    redraws.push(setback.draw, penetration.draw);
    return el('div', {class: 'pair'}, setback.figure, penetration.figure);
  }

  function replay(scene) {
    const player = Replay.make(Data.replayOf(scene));
    const title = el('h3', null, 'Replay');
    if (!player) return [title, el('p', {class: 'note'}, 'No trajectory was recorded for this scene.')];
    redraws.push(() => player.draw());
    return [title, player.element];
  }

  function show(scene) {
    redraws = [];
    const parts = [
      el('p', null, scene.description ?? ''),
      Tables.facts(scene),
      Format.sentences(scene.verdict),
      work(scene),
      Effects.table(scene),
      replay(scene),
      el('h3', null, 'Contacts'),
      Tables.outcomeFigure(scene),
      Tables.heatMaps(scene),
      el('h3', null, 'Distributions'),
      distributions(scene),
      Tables.bins(scene),
      Metrics.table(scene),
    ];
    const body = document.getElementById('scene-body');
    body.replaceChildren(...parts.flat().filter(Boolean));
    body.dataset.scene = scene.name;
    select.value = scene.name;
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
      location.hash = hashOf(Data.scenes[(i + step + n) % n].name);
    };
    select = el('select', {
      id: 'scene-select',
      'aria-label': 'Scene',
      onchange: () => { location.hash = hashOf(select.value); }
    },
                Data.scenes.map((scene) => el('option', {value: scene.name}, scene.name)));
    document.getElementById('scene-bar')
        .append(
            el('h2', {id: 'scene-title'}, 'Scene'), select,
            el('button', {type: 'button', 'aria-label': 'Scene before', onclick: () => neighbour(-1)},
               '\u2190'),
            el('button', {type: 'button', 'aria-label': 'Next scene', onclick: () => neighbour(1)}, '\u2192'),
            el('a', {href: '#top'}, 'to the top'));
  }

  function multiples() {
    const grid = document.getElementById('multiples-grid');
    const figures = Data.scenes.map(Plots.smallWorkFigure).filter(Boolean);
    if (figures.length === 0) return document.getElementById('multiples').remove();
    const names = [...new Set(Data.list(Data.run.work_precision).map((row) => row.engine))];
    grid.before(el('ul', {class: 'legend'}, names.map((name) => el('li', null, Data.tag(name)))));
    grid.append(...figures.map((f) => f.figure));
    smallRedraws.push(...figures.map((f) => f.draw));
    redraw(smallRedraws);
  }

  function listen() {
    window.addEventListener('hashchange', () => {
      if (location.hash === '#top')
        history.replaceState(null, '', hashOf(select.value));
      else if (document.getElementById('scene-body').dataset.scene !== sceneOfHash().name)
        show(sceneOfHash());
    });
    document.addEventListener('click', (event) => {
      if (event.target.closest('a[data-go]')) document.getElementById('scene').scrollIntoView();
    });
    const redrawAll = () => redraw([...smallRedraws, ...redraws]);
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
    Overview.show();
    multiples();
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
