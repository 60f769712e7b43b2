// SPDX-License-Identifier: MIT
// The page runs: which game, which engine, the clock, and the buttons.
const state = {isToy: false, game: 0, mode: 0, seed: 1, keys: 0, best: null, isPaused: false, isSlow: false, isWatched: false, record: null, replay: null};

function start(game, mode, seed) {
  Object.assign(state, {game, mode, seed, keys: 0, best: null, replay: null, record: newRecord(game, mode, seed)});
  state.isToy = false;
  wish = null;
  delete document.body.dataset.toy;
  engine._Start(game, mode, seed);
  costs.fill(null);
  explained = '';
  $('hint').textContent = help[games[game]];
  [...$('games').children].forEach((button, i) => button.setAttribute('aria-current', i === game));
  canvas.setAttribute('aria-label', `${games[game]}. ${help[games[game]]}`);
  $('replay').textContent = '';
  makePads();
  show();
}

function show() {
  drawGame();
  showScore();
  showEffects();
  showCosts();
}

function setMode(mode) {
  if (mode === state.mode) return;
  engine._SetMode(mode);
  state.mode = mode;
  note(state.record, engine._GetFrame(), 'm', mode);
  show();
}

function startReplay(record) {
  start(games.indexOf(record.game), modes.indexOf(record.mode), record.seed);
  state.replay = {events: record.events, next: 0, keys: 0};
  $('replay').textContent = 'A replay plays. The first key takes over.';
  setPaused(false);
}

/** The keys of the replay for this frame; it switches the engine where it was switched. */
function replayKeys() {
  const {replay} = state, frame = engine._GetFrame();
  for (; replay.next < replay.events.length && replay.events[replay.next][0] <= frame; ++replay.next) {
    const [, kind, value] = replay.events[replay.next];
    if (kind === 'k') replay.keys = value;
    if (kind === 'm') setMode(value);
    if (kind === 'e') {
      state.replay = null;
      $('replay').textContent = 'The replay is over: it is your turn.';
      return 0;
    }
  }
  return replay.keys;
}

function nextKeys() {
  const mine = heldKeys();
  if (mine !== 0 && state.replay) {
    state.replay = null;
    $('replay').textContent = '';
  }
  if (state.replay) return replayKeys();
  return state.isWatched ? engine._Play() | mine : mine;
}

function playFrame() {
  const keys = nextKeys();
  if (keys !== state.keys) note(state.record, engine._GetFrame(), 'k', keys);
  state.keys = keys;
  engine._Frame(keys);
}

function setPaused(isPaused) {
  state.isPaused = isPaused;
  $('pause').textContent = isPaused ? 'Go on' : 'Pause';
}
function setWatched(isWatched) {
  state.isWatched = isWatched;
  $('watch').setAttribute('aria-pressed', isWatched);
}

// Frames of the game are of 1/60 s, whatever the screen does; a page that was hidden does not catch up.
let clock = 0, due = 0, shown = 0;
function tick(now) {
  const passed = Math.min((now - clock) / 1000, 3 / framesPerSecond) * (state.isSlow ? 0.2 : 1);
  clock = now;
  requestAnimationFrame(tick);
  if (state.isToy) return fitCanvas() && drawToy();
  if (!state.isPaused) due += passed * framesPerSecond;
  for (; due >= 0.75; --due) // a screen of 60 Hz is not always on time
    playFrame();
  drawGame();
  showScore();
  if (now - shown > 100) {
    shown = now;
    showEffects();
  }
  measureNext(now);
}

const newSeed = () => Math.floor(Math.random() * 0xffffffff);
games.forEach((name, i) => {
  const button = document.createElement('button');
  button.textContent = name;
  button.addEventListener('click', () => start(i, state.mode, newSeed()));
  $('games').append(button);
});
const toyButton = document.createElement('button');
toyButton.textContent = 'Toy';
toyButton.addEventListener('click', startToy);
$('games').append(toyButton);
modes.forEach((name, i) => {
  const button = document.createElement('button');
  button.setAttribute('role', 'radio');
  button.append(document.createElement('b'), document.createElement('span'));
  button.firstChild.textContent = name;
  button.addEventListener('click', () => setMode(i));
  $('modes').append(button);
});
$('pause').addEventListener('click', () => setPaused(!state.isPaused));
$('step').addEventListener('click', () => { setPaused(true); playFrame(); show(); });
$('slow').addEventListener('click', () => {
  state.isSlow = !state.isSlow;
  $('slow').setAttribute('aria-pressed', state.isSlow);
});
$('watch').addEventListener('click', () => setWatched(!state.isWatched));
$('again').addEventListener('click', () => start(state.game, state.mode, newSeed()));

// After a click the keys belong to the game again; who comes to a button by the keyboard stays there.
addEventListener('click', (event) => {
  if (event.detail > 0 && event.target.closest('button')) canvas.focus({preventScroll: true});
});

function saveFile(name, text) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([text], {type: 'application/json'}));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
let ownHash = ''; // what the page itself has just written into the address
$('link').addEventListener('click', async () => {
  location.hash = ownHash = toLink(state.record, engine._GetFrame());
  try {
    await navigator.clipboard.writeText(location.href);
    $('replay').textContent = 'The link is in the clipboard.';
  } catch { $('replay').textContent = 'The link is in the address bar.'; }
});
$('save').addEventListener('click', () => {
  const events = [...state.record.events, [engine._GetFrame(), 'e', 0]];
  saveFile(`${games[state.game]}.replay.json`, JSON.stringify({...state.record, events}));
});
$('scene').addEventListener('click', () => saveFile(`${games[state.game]}.json`, textAt(engine._GetScene(10))));
$('load').addEventListener('click', () => $('file').click());
$('file').addEventListener('change', async () => {
  try {
    startReplay(checked(JSON.parse(await $('file').files[0].text())));
  } catch (error) { $('replay').textContent = `This file cannot be replayed. ${error.message}`; }
  $('file').value = '';
});

/** Plays the replay, or shows the toy, that the address asks for, if any: the game that runs goes on otherwise. */
function openAddress() {
  try {
    if (location.hash.includes('=')) startReplay(fromLink(location.hash));
    else if (location.hash === '#toy') startToy();
  } catch (error) { $('replay').textContent = error.message; }
}
addEventListener('hashchange', () => {
  if (location.hash !== ownHash) openAddress();
  ownHash = '';
});
start(0, 0, newSeed());
openAddress();
requestAnimationFrame(tick);
