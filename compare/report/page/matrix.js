// SPDX-License-Identifier: MIT
// Scenes by engines: is it good enough?
const Matrix = (() => {
  const {el, count, degrees, lossText, isNumber, dash} = Format;
  const {list} = Data;
  const signs = {good: '\u2713', rough: '~', poor: '\u2717', unknown: dash};
  const hashOf = (name) => `#scene=${encodeURIComponent(name)}`;

  /** A long name breaks after its underlines. */
  const breakable = (name) => name.split(/(?<=_)/).flatMap((part) => [part, el('wbr')]);

  function cell(scene, name) {
    const engine = list(scene.engines).find((e) => e.name === name);
    if (!engine) return el('td', null, dash);
    const lost = lossText(engine.tunneled, engine.contacts);
    const off = engine.direction_error?.count > 0 ? degrees(engine.direction_error.p95) : dash;
    const grade = engine.grade ?? 'unknown';
    return el('td', {
      class: `${grade}${scene.take === name ? ' take' : ''}`,
      title: `${name}: ${grade}; lost ${lost}, off by ${off}`
    },
              el('span', {class: 'sign', 'aria-label': grade}, signs[grade] ?? dash),
              el('span', {class: 'more'}, ' '),
              el('span', null, isNumber(engine.ns_per_ball_step) ? count(engine.ns_per_ball_step) : dash,
                 el('span', {class: 'more'}, ' ns')),
              engine.contacts > 0 ? el('small', {class: 'more'}, `${lost.replace(/ of .*/, '')} lost, ${off}`)
                                  : null);
  }

  function show() {
    const engines = list(Data.run.engines);
    const place = document.getElementById('matrix');
    if (Data.scenes.length === 0) return place.append(el('p', null, 'No scene was finished.'));
    const row = (scene) => el(
        'tr', {
          'data-scene': scene.name,
          onclick: () => {
            location.hash = hashOf(scene.name);
            document.getElementById('scene').scrollIntoView();
          }
        },
        el('th', {scope: 'row'}, el('a', {href: hashOf(scene.name), 'data-go': ''}, breakable(scene.name))),
        engines.map(({name}) => cell(scene, name)));
    place.append(
        el('p', {class: 'legend'}, el('span', {class: 'good'}, '\u2713 good'),
           ': a ball lost in at most 1 of 1,000 impacts, 95% of bounces within 1\u00b0 and 10% of the speed. ',
           el('span', {class: 'rough'}, '~ rough'), ': 1 of 100, 10\u00b0, 30%. ',
           el('span', {class: 'poor'}, '\u2717 poor'),
           ': worse. The number is nanoseconds for one step of one ball; ',
           el('span', {class: 'take'}, 'framed'), ': what to take, the fastest of the best grade',
           engines.some(({name}) => name === 'box2d') ? ' that is no worse than Box2D.' : '.'),
        el('table', {class: 'matrix'},
           el('thead', null,
              el('tr', null, el('th', {scope: 'col'}, 'scene'),
                 engines.map(({name, short}) => el('th', {scope: 'col', title: Data.rowOf(name).meaning},
                                                   Data.tag(name, short))))),
           el('tbody', null, Data.scenes.map(row))));
  }
  return {show, hashOf};
})();
