// SPDX-License-Identifier: MIT
// The last part of the page, in the scope of its own: plays every game, switches engines, replays, and leaves what it saw as
// JSON. Traces are left as a hash of all their lines.
const seen = {errors: window.noted, games: {}, isDone: false};

/** FNV-1a of 32 bits, over the lines as a file of them. */
function hashOf(line, hash) {
  for (let i = 0; i <= line.length; ++i)
    hash = Math.imul(hash ^ (i < line.length ? line.charCodeAt(i) : 10), 16777619) >>> 0;
  return hash;
}

/** Frames of the scripted player, by the page's own way to play one. */
function playTraced(frames) {
  let hash = 2166136261;
  for (let i = 0; i < frames; ++i) {
    playFrame();
    hash = hashOf(textAt(engine._GetTrace()), hash);
  }
  return hash;
}

const placesOf = () => textAt(engine._GetTrace());

/** Pixels by which anything is wider than its place. */
const stickingOut = () =>
    Math.max(...[document.documentElement, ...document.querySelectorAll('aside')].map((part) => part.scrollWidth - part.clientWidth));

/** How many pixels of the canvas differ from those of an empty one. */
function inked() {
  drawGame();
  const data = new Uint32Array(brush.getImageData(0, 0, canvas.width, canvas.height).data.buffer);
  const ground = data[Math.floor(data.length / 2)];
  return data.reduce((sum, pixel) => sum + (pixel !== ground), 0);
}

/** Pictures and frames of the game a second while the page runs by itself. */
async function measureFrames(seconds) {
  const begin = performance.now(), frame = engine._GetFrame();
  let pictures = 0;
  await new Promise((resolve) => {
    const count = () => {
      ++pictures;
      performance.now() - begin > 1000 * seconds ? resolve() : requestAnimationFrame(count);
    };
    requestAnimationFrame(count);
  });
  const passed = (performance.now() - begin) / 1000;
  return {pictures: pictures / passed, frames: (engine._GetFrame() - frame) / passed};
}

/** Presses on the canvas at a place of the game, moves to another, and lets go. */
function dragTo(from, to) {
  const {scale, x, y} = camera(), box = canvas.getBoundingClientRect(), ratio = canvas.width / box.width;
  const event = (kind, p) => new PointerEvent(kind, {
    bubbles: true, pointerId: 1, clientX: box.left + (p[0] * scale + x) / ratio, clientY: box.top + (y - p[1] * scale) / ratio});
  canvas.dispatchEvent(event('pointerdown', from));
  canvas.dispatchEvent(event('pointermove', to));
  canvas.dispatchEvent(event('pointerup', to));
}

/** Whether a scene can be saved with a ball, and after the last one of pinball, which nobody plays but for the plunger. */
function exerciseSceneButton() {
  const pinball = games.indexOf('pinball'), canSave = [];
  start(pinball, 0, 1);
  canSave.push(!$('scene').disabled);
  for (let i = 0; i < 20000 && engine._GetBallCount() > 0; ++i) engine._Frame(i % 120 < 60 ? keyBits.action : 0);
  show();
  canSave.push(!$('scene').disabled);
  return canSave;
}

/** Keys of the next frame of breakout after the mouse has moved: by the player himself, in a new game, in a replay and while he
    watches. */
function exerciseMouse() {
  const move = () => canvas.dispatchEvent(new PointerEvent('pointermove', {clientX: canvas.getBoundingClientRect().right}));
  const breakout = games.indexOf('breakout'), seenKeys = {};
  setWatched(false);
  start(breakout, 0, 1);
  move();
  seenKeys.mine = nextKeys();
  start(breakout, 0, 1);
  seenKeys.started = nextKeys();
  startReplay({...newRecord(breakout, 0, 1), events: [[0, 'k', 1], [9, 'e', 0]]});
  setPaused(true);
  move();
  seenKeys.replayed = nextKeys();
  start(breakout, 0, 1);
  move();
  setWatched(true);
  seenKeys.watched = nextKeys();
  return seenKeys;
}

/** Shapes and balls on which native and the exact answers differ, of many. */
function exactDiffers() {
  let seed = 1;
  const random = (low, high) => low + (high - low) * (seed = seed * 48271 % 0x7FFFFFFF) / 0x7FFFFFFF;
  const place = () => [random(-2, 2), random(-2, 2)].map(Math.fround);
  const differing = [], met = {contact: 0, sweep: 0};
  for (let i = 0; i < 2000; ++i) {
    const shape = {type: toyKinds[i % toyKinds.length], position: place(), p0: place(), p1: place(), radius: Math.fround(random(0.2, 2)),
                   angles: [random(-3, 3), random(-3, 3)].map(Math.fround)};
    for (const field of shape.type === 'line_segment' ? ['position', 'radius', 'angles'] : ['p0', 'p1']) delete shape[field];
    const ball = {position: place(), velocity: place(), radius: Math.fround(random(0.05, 0.5))};
    const [is, should] = [askContact(0, shape, ball), exactContact(shape, ball)];
    const far = (a, b) => Math.max(...a.map((x, k) => Math.abs(x - b[k])));
    met.contact += should.isMet;
    // (What touches the ends of segments and arcs only the sweeps see.)
    if (!['arc', 'line_segment'].includes(shape.type) && (is.isMet !== should.isMet || (is.isMet && far([...is.poi, ...is.normal], [...should.poi, ...should.normal]) > 1e-4)))
      differing.push({shape, ball, is, should});
    if (should.isMet) continue;
    const [swept, exact] = [askSweep(0, shape, ball), exactSweep(shape, ball)];
    met.sweep += exact.isMet;
    if (swept.isMet !== exact.isMet || far(swept.end, exact.end) > 1e-3) differing.push({shape, ball, swept, exact});
  }
  return {differing, met};
}

function exerciseToy() {
  startToy();
  const result = {swept: {}}, ball = chosenBall();
  for (const [mode, name] of modes.entries()) result.swept[name] = askSweep(mode, chosenShape(), ball).isMet;
  dragTo(ball.position, [1, 3]);
  result.dragged = ball.position;
  // A level segment below the ball: the closest point, the setback and the normal are known.
  toy.scene.shapes[0] = {type: 'line_segment', p0: [-1, 2.5], p1: [3, 2.5]};
  ball.position = [1, 3];
  result.contacts = ['native', 'box2d'].map((name) => askContact(modes.indexOf(name), chosenShape(), ball));
  result.tangents = askShape({type: 'circle', position: [-3, 3], radius: ball.radius}, ball).tangents;
  result.isInSector = [[0, 1], [1, 6]].map((angles) => askShape({type: 'arc', position: [0, 2.5], radius: 1, angles}, ball).isInSector);
  result.exact = exactDiffers();
  showToy();
  result.text = $('toy-answers').innerText;
  result.scene = JSON.stringify(readToyScene(JSON.stringify(toy.scene)));
  result.refused = [];
  for (const shape of [{type: 'box'}, {type: 'circle', position: [0, 0], radius: -1}, {type: 'point', position: [0]}])
    try { readToyScene(JSON.stringify({shapes: [shape], balls: toy.scene.balls})); } catch (error) { result.refused.push(error.message); }
  const count = toy.scene.shapes.length;
  $('toy-delete').click();
  result.deleted = count - toy.scene.shapes.length;
  result.width = stickingOut();
  return result;
}

/** Whether replays run after a link was copied, and after one was pasted into the address. */
async function exerciseAddress() {
  const changed = () => new Promise((resolve) => addEventListener('hashchange', resolve, {once: true}));
  start(0, 0, 1);
  $('link').click();
  await changed();
  const copied = state.replay !== null;
  location.hash = '#breakout=1.0.5K1.9E';
  await changed();
  return {copied, pasted: state.replay !== null, game: games[state.game]};
}

async function exercise() {
  setPaused(true);
  setWatched(true);
  for (const [game, name] of games.entries()) {
    const result = seen.games[name] = {modes: {}};
    for (const [mode, modeName] of modes.entries()) {
      start(game, mode, 1);
      const hash = playTraced(window.minute);
      showScore();
      result.modes[modeName] = {hash, score: engine._GetScore(), lost: engine._GetLost(), told: $('lost').textContent};
    }
    // Switching: nothing moves, and the game goes on.
    start(game, 0, 1);
    for (let i = 0; i < 120; ++i) playFrame();
    result.jumps = [];
    for (const mode of [1, 2, 3, 0]) {
      const before = placesOf();
      $('modes').children[mode].click();
      if (placesOf() !== before || state.mode !== mode) result.jumps.push(modes[mode]);
      for (let i = 0; i < 30; ++i) playFrame();
    }
    // A replay of that, engines and all, from its link.
    const end = placesOf(), link = toLink(state.record, engine._GetFrame());
    startReplay(fromLink(link));
    setPaused(true);
    setWatched(false);
    for (const frame = Number(end.split(' ')[0]); engine._GetFrame() < frame;) playFrame();
    result.replay = placesOf() === end ? 'same' : `${placesOf().slice(0, 200)} instead of ${end.slice(0, 200)}`;
    setWatched(true);
    result.ink = inked();
    result.scene = textAt(engine._GetScene(10)).length;
    show();
    result.width = stickingOut();
  }
  seen.canSave = exerciseSceneButton();
  seen.mouse = exerciseMouse();
  seen.toy = exerciseToy();
  // Keys reach the game, a step is one frame, and links that are none are refused in words.
  start(0, 0, 1);
  setWatched(false);
  dispatchEvent(new KeyboardEvent('keydown', {code: 'ArrowLeft'}));
  const frame = engine._GetFrame();
  $('step').click();
  seen.step = engine._GetFrame() - frame;
  seen.keys = state.keys;
  // Two keys by one name: one of them is still held.
  dispatchEvent(new KeyboardEvent('keydown', {code: 'KeyA'}));
  dispatchEvent(new KeyboardEvent('keyup', {code: 'KeyA'}));
  seen.stillHeld = heldKeys();
  dispatchEvent(new KeyboardEvent('keyup', {code: 'ArrowLeft'}));
  seen.refused = [];
  for (const link of ['#chess=1.0.5E', '#pinball=1.9.5E', '#pinball=1.0.5Q'])
    try { fromLink(link); seen.refused.push(`${link} was taken`); } catch (error) { seen.refused.push(error.message); }
  seen.address = await exerciseAddress();
  setWatched(true);
  for (const name of ['pinball', 'pile']) {
    start(games.indexOf(name), 0, 1);
    setPaused(false);
    await measureFrames(1); // until the engine is compiled to the end
    seen.games[name].speed = await measureFrames(5);
  }
}

try {
  await exercise();
  seen.isDone = true;
} catch (error) {
  seen.errors.push(`exercise: ${error.stack}`);
}
seen.resources = performance.getEntriesByType('resource').map((entry) => entry.name).filter((name) => !name.startsWith('data:'));
const result = document.createElement('pre');
result.id = 'test-result';
result.textContent = JSON.stringify(seen).replace(/[<>&]/g, (c) => `\\u00${c.charCodeAt(0).toString(16)}`);
document.body.append(result);
window.holder.contentDocument.close();
