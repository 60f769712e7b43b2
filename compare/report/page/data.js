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
  /** The places of a track, x and y of each ball, frame by frame. They are packed as second differences. */
  function unpack(packed, balls, unit) {
    const places = Array(2 * balls).fill(0), steps = [...places];
    return packed.map((turn, i) => {
      if (turn === null) return null; // nowhere
      const k = i % places.length;
      steps[k] += turn;
      places[k] += steps[k];
      return places[k] * unit;
    });
  }
  /** The clips of a scene of the replay with their tracks. */
  function clipsOf(scene) {
    const tracks = list(scene.tracks).map((track) => unpack(track, scene.radii.length, scene.unit));
    return list(scene.clips).map((clip) => ({...clip, tracks: clip.tracks.map((i) => tracks[i])}));
  }
  const replayOf = (scene) => list(replay.scenes).find((s) => s.name === scene.name);
  const tracks = list(replay.engines);

  return {run, charts, scenes, list, rowOf, colour, css, tag, workOf, replayOf, clipsOf, tracks};
})();
