// SPDX-License-Identifier: MIT
// The keys that are held down on the keyboard, under the mouse, by fingers and on the pads, as the bits of a frame.
const held = new Set(); // a name with where it comes from: "left KeyA", "action 3"
const keyNames = {ArrowLeft: 'left', KeyA: 'left', ArrowRight: 'right', KeyD: 'right', Space: 'action', ArrowDown: 'action',
                  ArrowUp: 'nudge', KeyW: 'nudge'};
const bitsOf = (names) => names.reduce((bits, name) => bits | keyBits[name], 0);

addEventListener('keydown', (event) => {
  const name = keyNames[event.code];
  if (!name || event.ctrlKey || event.altKey || event.metaKey) return;
  if (event.code === 'Space' && event.target instanceof HTMLButtonElement) return; // presses the button
  event.preventDefault();
  held.add(`${name} ${event.code}`);
});
addEventListener('keyup', (event) => held.delete(`${keyNames[event.code]} ${event.code}`));
addEventListener('blur', () => held.clear());

// On the table: the left half is the left key, the right half the right one, the rightmost tenth the plunger. In
// breakout the paddle follows.
let wish = null; // the place in the game that the paddle is to go to
function pointed(event) {
  const box = canvas.getBoundingClientRect(), view = camera(), ratio = canvas.width / box.width;
  const x = ((event.clientX - box.left) * ratio - view.x) / view.scale;
  return {x, share: (x - view.left) / (view.right - view.left)};
}
canvas.addEventListener('pointerdown', (event) => {
  if (state.isToy) return;
  canvas.setPointerCapture(event.pointerId);
  const {x, share} = pointed(event), game = games[state.game];
  if (game === 'breakout') wish = x;
  const name = game === 'breakout' || game === 'billiard' || share > 0.88 ? 'action' : share < 0.46 ? 'left' : 'right';
  held.add(`${name} ${event.pointerId}`);
});
canvas.addEventListener('pointermove', (event) => {
  if (games[state.game] === 'breakout') wish = pointed(event).x;
});
for (const end of ['pointerup', 'pointercancel'])
  addEventListener(end, (event) => Object.keys(keyBits).forEach((name) => held.delete(`${name} ${event.pointerId}`)));

function makePads() {
  const pads = Object.entries(padNames[games[state.game]]).map(([name, label]) => {
    const pad = document.createElement('button');
    pad.textContent = label;
    pad.addEventListener('pointerdown', (event) => held.add(`${name} ${event.pointerId}`));
    return pad;
  });
  document.getElementById('pads').replaceChildren(...pads);
}

/** The place of the paddle: the one flipper of breakout, an arc. */
function paddleX() {
  const pointer = engine._Draw(), count = engine._GetRowCount();
  const rows = new Float32Array(engine.HEAPF32.buffer, pointer, count * rowLength);
  for (let i = 0; i < rows.length; i += rowLength)
    if (roles[rows[i + 1]] === 'flipper') return rows[i + 2];
  return 0;
}

function heldKeys() {
  let bits = bitsOf([...held].map((name) => name.split(' ')[0]));
  // A mouse that moves but presses nothing takes over neither from a replay nor from the scripted player.
  if (bits & (keyBits.left | keyBits.right) || state.isWatched || (state.replay && bits === 0)) wish = null;
  if (wish !== null && games[state.game] === 'breakout') {
    const way = wish - paddleX();
    if (Math.abs(way) > 0.2) bits |= way < 0 ? keyBits.left : keyBits.right;
  }
  return bits;
}
