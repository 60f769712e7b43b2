// SPDX-License-Identifier: MIT
// Draws the rows of the game that runs: what each number means is said in Drawing.h.
const roles = ['wall', 'kicker', 'flipper', 'sensor', 'lit', 'gate', 'ball'];
const rowLength = 9;
const canvas = document.getElementById('canvas');
const brush = canvas.getContext('2d');

let colours = {};
const stamps = new Map(); // pictures of balls, by their diameter in half pixels: half the time of circles, where they are many
function readColours() {
  stamps.clear();
  const style = getComputedStyle(document.documentElement);
  colours = Object.fromEntries([...roles, 'surface', 'bg'].map((role) => [role, style.getPropertyValue(`--${role}`).trim()]));
}
readColours();
matchMedia('(prefers-color-scheme: dark)').addEventListener('change', readColours);

function stampOf(radius) {
  const size = Math.round(4 * radius);
  if (!stamps.has(size)) {
    const stamp = document.createElement('canvas');
    stamp.width = stamp.height = Math.ceil(size / 2) + 2;
    const ink = stamp.getContext('2d'), centre = stamp.width / 2;
    ink.fillStyle = colours.ball;
    ink.arc(centre, centre, size / 4, 0, 2 * Math.PI);
    ink.fill();
    stamps.set(size, stamp);
  }
  return stamps.get(size);
}

/** From places of the game to those of the canvas: the whole table, as large as it can be. */
function camera() {
  const [left, bottom, right, top] =
      state.isToy ? Object.values(toyBounds) : new Float32Array(engine.HEAPF32.buffer, engine._GetBounds(), 4);
  const {width, height} = canvas;
  const scale = Math.min(width / (right - left), height / (top - bottom));
  const x = (width - scale * (right - left)) / 2 - scale * left, y = (height + scale * (top - bottom)) / 2 + scale * bottom;
  return {scale, x, y, left, bottom, right, top};
}

/** Gives the canvas as many pixels as it covers. @return whether that changed */
function fitCanvas() {
  const ratio = devicePixelRatio || 1, box = canvas.getBoundingClientRect();
  const width = Math.round(box.width * ratio), height = Math.round(box.height * ratio);
  if (canvas.width === width && canvas.height === height) return false;
  canvas.width = width;
  canvas.height = height;
  return true;
}

function drawGame() {
  fitCanvas();
  const view = camera();
  brush.setTransform(1, 0, 0, 1, 0, 0);
  brush.clearRect(0, 0, canvas.width, canvas.height);
  // One unit is one unit of the game, y is up.
  brush.setTransform(view.scale, 0, 0, -view.scale, view.x, view.y);
  brush.fillStyle = colours.surface;
  brush.save();
  brush.beginPath();
  brush.rect(view.left, view.bottom, view.right - view.left, view.top - view.bottom);
  brush.fill();
  brush.clip();
  brush.lineCap = brush.lineJoin = 'round';
  const pointer = engine._Draw(), count = engine._GetRowCount();
  const rows = new Float32Array(engine.HEAPF32.buffer, pointer, count * rowLength);
  const pixel = (devicePixelRatio || 1) / view.scale;
  const thick = Math.min(3, 0.12 / pixel);
  for (let i = 0; i < rows.length; i += rowLength) {
    const kind = rows[i], name = roles[rows[i + 1]], x = rows[i + 2], y = rows[i + 3], r = rows[i + 6];
    if (name === 'ball') { // the last rows
      const stamp = stampOf(r * view.scale);
      brush.setTransform(1, 0, 0, 1, view.x + x * view.scale - stamp.width / 2, view.y - y * view.scale - stamp.width / 2);
      brush.drawImage(stamp, 0, 0);
      continue;
    }
    if (kind === 0 && name === 'kicker') continue; // the corners of a brick
    brush.beginPath();
    brush.strokeStyle = brush.fillStyle = colours[name];
    brush.lineWidth = (name === 'sensor' ? 1.5 : thick) * pixel;
    if (kind === 0) brush.arc(x, y, 1.5 * pixel, 0, 2 * Math.PI);
    else if (kind === 1) brush.moveTo(x, y), brush.lineTo(rows[i + 4], rows[i + 5]);
    else if (kind === 2) brush.arc(x, y, r, 0, 2 * Math.PI);
    else brush.arc(x, y, r, rows[i + 7], rows[i + 8]);
    if (kind === 2) {
      brush.globalAlpha = 0.18;
      brush.fill();
      brush.globalAlpha = 1;
    }
    brush.stroke();
  }
  brush.restore();
}
