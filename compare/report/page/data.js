// SPDX-License-Identifier: MIT
// The two documents of the page, and what is looked up in them.
const Data = (() => {
  const read = (id) => JSON.parse(document.getElementById(id).textContent);
  const list = (x) => (Array.isArray(x) ? x : []);

  const run = read('run');
  const replay = read('replay');
  const scenes = list(run.scenes);
  const ownColours = ['native', 'native-continuous', 'box2d', 'box2d-tuned', 'exact'];

  const engineNames =
      [...new Set(scenes.flatMap((scene) => list(scene.engines).map((engine) => engine.name)))];
  const others = [...new Set([...engineNames, ...list(run.work_precision).map((row) => row.engine)])].filter(
      (name) => !ownColours.includes(name));

  /** Name of the CSS variable with the colour of an engine: the same everywhere on the page. */
  function colourVariable(name) {
    return ownColours.includes(name) ? `--${name}` : `--extra${(Math.max(0, others.indexOf(name)) % 3) + 1}`;
  }
  const css = (variable) => getComputedStyle(document.documentElement).getPropertyValue(variable).trim();
  const colour = (name) => css(colourVariable(name));
  const tag = (name) =>
      Format.el('span', {class: 'engine', '--engine': `var(${colourVariable(name)})`}, name);

  const workOf = (scene) => list(run.work_precision).filter((row) => row.scene === scene.name);
  const replayOf = (scene) => list(replay.scenes).find((s) => s.name === scene.name);
  const tracks = list(replay.engines).map((engine) => (typeof engine === 'string' ? engine : engine.name));

  return {run, scenes, list, engineNames, colourVariable, colour, css, tag, workOf, replayOf, tracks};
})();
