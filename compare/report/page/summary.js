// SPDX-License-Identifier: MIT
// The first screen: the result in a sentence, a tile for each engine, one chart.
const Summary = (() => {
  const {el, num, plain, count, degrees, lossText, isNumber, dash} = Format;
  const {list, run} = Data;
  const overall = run.overall ?? {};

  /** The charts come as SVG, drawn by the program. */
  function svg(texts) {
    const holder = document.createElement('template');
    holder.innerHTML = texts.join('');
    return holder.content;
  }

  function times(engine) {
    if (!isNumber(engine.ns_box2d_ratio)) return dash;
    return `${plain(Number(engine.ns_box2d_ratio.toPrecision(2)))}\u00d7`;
  }
  const range = (pair, format) => (list(pair).length === 2 ? pair.map(format).join(` to `) : null);

  function tile(engine) {
    const n = overall.impacts;
    const part = (title, value, hint) =>
        el('div', {title: hint || null}, el('dt', null, title), el('dd', null, value));
    const interval = range(engine.ns_per_ball_step_interval, num);
    const isTaken = overall.take === engine.name;
    return el(
        'li', {class: `tile ${engine.grade}${isTaken ? ' take' : ''}`, 'data-engine': engine.name},
        el('h3', null,
           Data.tag(engine.name,
                    [
                      el('span', {class: 'full'}, engine.name),
                      el('span', {class: 'brief'}, Data.rowOf(engine.name).short)
                    ]),
           el('small', null, Data.rowOf(engine.name).meaning),
           isTaken ? el('span', {class: 'chosen'}, 'take this')
                   : el('span', {class: 'grade'}, engine.grade)),
        el('dl', null,
           part('impacts lost', lossText(engine.tunneled, n).replace(/ of .*/, ''),
                `${count(engine.tunneled?.count)} of ${count(n)} impacts`),
           part('off by', degrees(engine.direction_error_p95), '95% of the bounces are no farther off'),
           part('per ball', `${num(engine.ns_per_ball_step)} ns`,
                interval && `one step, geometric mean of the scenes, 95% interval ${interval} ns`),
           part('vs Box2D', times(engine),
                range(engine.ns_box2d_ratio_scenes, num) &&
                    `times as fast as Box2D; ${range(engine.ns_box2d_ratio_scenes, num)} in single scenes`)));
  }

  function provenance() {
    const machine = run.machine ?? {};
    const facts = [
      isNumber(run.contacts_per_scene) ? `${count(run.contacts_per_scene)} contacts a scene` : null,
      run.seed ? `seed ${run.seed}` : null,
      machine.shapes ? `Shapes ${machine.shapes}` : null,
      machine.box2d ? `Box2D ${machine.box2d}` : null,
      machine.compiler,
      machine.cpu && isNumber(machine.cores) ? `${machine.cpu}, ${machine.cores} cores` : machine.cpu,
    ].filter(Boolean);
    return el('p', {class: 'provenance'}, el('code', null, run.command ?? 'command unknown'),
              ` ${dash} ${facts.join('; ')}`);
  }

  function show() {
    const [, headline, lead] = /^(.*?)(?:\. (.*))?$/s.exec(Format.spoken(overall.result ?? 'Nothing was judged.'));
    document.getElementById('result').textContent = headline;
    document.getElementById('lead').textContent = lead ?? '';
    document.getElementById('tiles').append(...list(overall.engines).map(tile));
    const chart = document.getElementById('overall-chart');
    if (list(overall.engines).length > 0)
      chart.append(svg(list(Data.charts.overall)));
    else
      chart.remove();
    document.getElementById('provenance').append(provenance());
    if (run.interrupted)
      document.getElementById('notices').append(
          el('p', {class: 'warning', id: 'interrupted'},
             'This run was interrupted: only the scenes that were finished are here.'));
  }
  return {show, svg};
})();
