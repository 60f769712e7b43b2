// SPDX-License-Identifier: MIT
// The collision toy: shapes and balls to drag, and what each engine says of the chosen ones, side by side.
const toy = {scene: newToyScene(), shape: 0, ball: 0, dragged: null};
const chosenShape = () => toy.scene.shapes[toy.shape];
const chosenBall = () => toy.scene.balls[toy.ball];
const turned = (angle, length) => [length * Math.cos(angle), length * Math.sin(angle)];
const plus = (a, b) => [a[0] + b[0], a[1] + b[1]];
const minus = (a, b) => [a[0] - b[0], a[1] - b[1]];
const lengthOf = (a) => Math.hypot(a[0], a[1]);

/** The handles: each has a place, and a function for a drag to another. Those of the chosen ones first. */
function toyHandles() {
  const handles = [];
  const ball = chosenBall();
  handles.push({at: plus(ball.position, ball.velocity), drag: (p) => ball.velocity = minus(p, ball.position)});
  const shape = chosenShape();
  if (shape?.radius !== undefined) {
    const angles = shape.angles ?? [0];
    angles.forEach((angle, i) => handles.push({
      at: plus(shape.position, turned(angle, shape.radius)),
      drag: (p) => {
        const d = minus(p, shape.position);
        shape.radius = Math.max(0.1, lengthOf(d));
        if (shape.angles) shape.angles[i] = Math.atan2(d[1], d[0]);
      },
    }));
  }
  toy.scene.balls.forEach((other, i) => handles.push({
    at: other.position, reach: other.radius, choose: () => toy.ball = i, drag: (p) => other.position = p}));
  toy.scene.shapes.forEach((other, i) => {
    const choose = () => toy.shape = i;
    if (other.p0) {
      handles.push({at: other.p0, choose, drag: (p) => other.p0 = p}, {at: other.p1, choose, drag: (p) => other.p1 = p});
      const middle = plus(other.p0, minus(other.p1, other.p0).map((x) => x / 2));
      handles.push({at: middle, choose, drag: (p) => {
        const d = minus(p, plus(other.p0, minus(other.p1, other.p0).map((x) => x / 2)));
        [other.p0, other.p1] = [plus(other.p0, d), plus(other.p1, d)];
      }});
    } else {
      handles.push({at: other.position, reach: 0.6 * (other.radius ?? 0), choose, drag: (p) => other.position = p});
    }
  });
  return handles;
}

/** The first handle within reach of a place: half a unit, or the inside of a ball. */
const toyHandleAt = (p) => toyHandles().find(({at, reach = 0}) => lengthOf(minus(p, at)) < Math.max(reach, 0.45));

function toyPointer(event) {
  const {scale, x, y} = camera(), box = canvas.getBoundingClientRect(), ratio = canvas.width / box.width;
  const keep = (value, low, high) => Math.min(Math.max(value, low), high);
  return [keep(((event.clientX - box.left) * ratio - x) / scale, toyBounds.left, toyBounds.right),
          keep((y - (event.clientY - box.top) * ratio) / scale, toyBounds.bottom, toyBounds.top)];
}
canvas.addEventListener('pointerdown', (event) => {
  if (!state.isToy) return;
  const p = toyPointer(event), handle = toyHandleAt(p);
  if (!handle) return;
  handle.choose?.();
  toy.dragged = {drag: handle.drag, off: minus(handle.at, p)};
  showToy();
});
canvas.addEventListener('pointermove', (event) => {
  if (!state.isToy || !toy.dragged) return;
  toy.dragged.drag(plus(toyPointer(event), toy.dragged.off));
  showToy();
});
addEventListener('pointerup', () => toy.dragged = null);

const shortNumber = (x, digits = 3) => (Math.abs(x) < 0.5 * 10 ** -digits ? 0 : x).toFixed(digits);
const shortPair = (p, digits) => `(${p.map((x) => shortNumber(x, digits)).join(', ')})`;
/** A table of what each engine says: rows of a title and a text for each. */
function toyTable(heads, rows) {
  const row = (cells, tag) => {
    const line = document.createElement('tr');
    cells.forEach((text, i) => {
      const cell = document.createElement(i === 0 ? 'th' : tag);
      cell.textContent = text;
      line.append(cell);
    });
    return line;
  };
  const table = document.createElement('table');
  table.append(row(['', ...heads], 'th'), ...rows.map((cells) => row(cells, 'td')));
  return table;
}

function showToy() {
  drawToy();
  const shape = chosenShape(), ball = chosenBall();
  $('toy-delete').disabled = !shape;
  if (!shape) return $('toy-answers').replaceChildren('Add a shape.');
  const still = [...['native', 'box2d'].map((name) => askContact(modes.indexOf(name), shape, ball)), exactContact(shape, ball)];
  const says = (answers, f) => answers.map((answer) => answer.isMet ? f(answer) : '-');
  const swept = [...modes.map((_, mode) => askSweep(mode, shape, ball)), exactSweep(shape, ball)], geometry = askShape(shape, ball);
  const text = document.createElement('p');
  text.className = 'note';
  text.textContent = `Closest point ${shortPair(geometry.closest)}, at ${shortNumber(lengthOf(minus(geometry.closest, ball.position)))}` +
      ` from the centre.${shape.type === 'arc' ? ` The centre is ${geometry.isInSector ? '' : 'not '}in the sector.` : ''}`;
  const titles = [document.createElement('h2'), document.createElement('h2')];
  titles[0].textContent = 'As they are';
  titles[1].textContent = 'Along the arrow, in one step';
  const flights = toyTable(['hits at', 'ends at'], [...modes, 'exact'].map((name, i) => [
    name, swept[i].isMet ? shortPair(swept[i].poi, 2) : '-', shortPair(swept[i].end, 2)]));
  $('toy-answers').replaceChildren(text, titles[0], toyTable(['native', 'box2d', 'exact'], [
    ['meets', ...still.map(({isMet}) => isMet ? 'yes' : 'no')],
    ['point of impact', ...says(still, ({poi}) => shortPair(poi))],
    ['normal', ...says(still, ({normal}) => shortPair(normal))],
    ['setback', ...says(still, ({setback}) => shortNumber(setback))],
    ['speed', ...says(still, ({speed}) => shortNumber(speed))],
  ]), titles[1], flights);
}

function startToy() {
  state.isToy = true;
  document.body.dataset.toy = '';
  [...$('games').children].forEach((button, i) => button.setAttribute('aria-current', i === games.length));
  $('hint').textContent = 'Drag shapes, the ball, and the tip of its arrow.';
  showToy();
}

toyKinds.forEach((kind) => {
  const button = document.createElement('button');
  button.textContent = `+ ${kind.replace('line_', '')}`;
  button.addEventListener('click', () => {
    toy.shape = toy.scene.shapes.push(newToyShapes[kind]()) - 1;
    showToy();
  });
  $('toy-delete').before(button);
});
$('toy-delete').addEventListener('click', () => {
  toy.scene.shapes.splice(toy.shape, 1);
  toy.shape = Math.max(0, toy.shape - 1);
  showToy();
});
$('toy-save').addEventListener('click', () => saveFile('toy.json', `${JSON.stringify(toy.scene, null, 2)}\n`));
$('toy-load').addEventListener('click', () => $('toy-file').click());
$('toy-file').addEventListener('change', async () => {
  try {
    Object.assign(toy, {scene: readToyScene(await $('toy-file').files[0].text()), shape: 0, ball: 0});
    $('toy-note').textContent = '';
    showToy();
  } catch (error) { $('toy-note').textContent = `This scene cannot be shown. ${error.message}`; }
  $('toy-file').value = '';
});
