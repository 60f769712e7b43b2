// SPDX-License-Identifier: MIT
// The documents of the page, and what is looked up in them.
const Data = (() => {
  const read = (id) => JSON.parse(document.getElementById(id).textContent);
  const list = (x) => (Array.isArray(x) ? x : []);

  const run = read('run');
  const replay = read('replay');
  const charts = read('charts');
  const scenes = list(run.scenes);
  const exact = {name: 'exact', short: 'exact', meaning: 'the exact reference', mark: 'bar'};
  const rows = new Map([...list(run.engines), exact].map((row) => [row.name, row]));

  /** The row of an engine in the table of engines. */
  const rowOf = (name) => rows.get(name) ?? {...exact, name, short: name, meaning: ''};
  const css = (variable) => getComputedStyle(document.documentElement).getPropertyValue(variable).trim();
  const colour = (name) => css(`--${name}`);
  /** The name of an engine with its mark. */
  const tag = (name, text = name) =>
      Format.el('span', {class: 'engine', '--engine': `var(--${name})`},
                Format.el('span', {class: `mark ${rowOf(name).mark}`, 'aria-hidden': 'true'}), text);

  const workOf = (scene) => list(run.work_precision).filter((row) => row.scene === scene.name);
  const replayOf = (scene) => list(replay.scenes).find((s) => s.name === scene.name);
  const tracks = list(replay.engines);

  return {run, charts, scenes, list, rowOf, colour, css, tag, workOf, replayOf, tracks};
})();
