// SPDX-License-Identifier: MIT
// The scene of the collision toy: a scene file of shapes-compare, of which it edits places, radii and angles and keeps the rest.
const toyKinds = ['point', 'line_segment', 'circle', 'arc'];
const toyBounds = {left: -8, bottom: -6, right: 8, top: 6};
const newToyScene = () => ({
  name: 'toy', duration: 5, gravity: [0, 0], bounds: {left: -16, bottom: -12, right: 16, top: 12},
  shapes: [
    {type: 'line_segment', p0: [-6, -3.5], p1: [-0.5, -2]},
    {type: 'circle', position: [3.5, 2.5], radius: 1.5},
    {type: 'arc', position: [2.5, -2.5], radius: 2, angles: [0.3, 2.6]},
    {type: 'point', position: [-5, 3]},
  ],
  balls: [{position: [-4.2, 0.5], velocity: [1.6, -5.5], radius: 0.8}],
});

const newToyShapes = {
  point: () => ({type: 'point', position: [0, 0]}),
  line_segment: () => ({type: 'line_segment', p0: [-1, 0], p1: [1, 0]}),
  circle: () => ({type: 'circle', position: [0, 0], radius: 1}),
  arc: () => ({type: 'arc', position: [0, 0], radius: 1.5, angles: [0, 2]}),
};

/** The scene that a text holds. @throws Error that says what is wrong */
function readToyScene(text) {
  const scene = JSON.parse(text);
  const expect = (holds, where, what) => {
    if (!holds) throw new Error(`${where}: expected ${what}.`);
  };
  const isPair = (value) => Array.isArray(value) && value.length === 2 && value.every((x) => Number.isFinite(x) && Math.abs(x) < 1e6);
  const isLength = (value) => Number.isFinite(value) && value >= 0 && value < 1e6;
  expect(Array.isArray(scene.shapes), 'shapes', 'a list of shapes');
  scene.shapes.forEach((shape, i) => {
    const where = (field) => `shapes[${i}].${field}`;
    expect(toyKinds.includes(shape.type), where('type'), toyKinds.join(', '));
    for (const field of shape.type === 'line_segment' ? ['p0', 'p1'] : ['position'])
      expect(isPair(shape[field]), where(field), 'two numbers');
    if (shape.type === 'circle' || shape.type === 'arc') expect(isLength(shape.radius), where('radius'), 'a number, at least 0');
    if (shape.type === 'arc') {
      shape.angles ??= [0, 0];
      expect(isPair(shape.angles), where('angles'), 'two numbers');
    }
  });
  expect(Array.isArray(scene.balls) && scene.balls.length > 0, 'balls', 'a list of one ball or more');
  scene.balls.forEach((ball, i) => {
    ball.velocity ??= [0, 0];
    expect(isPair(ball.position), `balls[${i}].position`, 'two numbers');
    expect(isPair(ball.velocity), `balls[${i}].velocity`, 'two numbers');
    expect(isLength(ball.radius) && ball.radius > 0, `balls[${i}].radius`, 'a number above 0');
  });
  return scene;
}

/** A shape as the eight numbers of Toy.cpp. */
function numbersOf(shape) {
  const [x, y] = shape.position ?? shape.p0, [x1, y1] = shape.p1 ?? [0, 0], [a0, a1] = shape.angles ?? [0, 0];
  return [toyKinds.indexOf(shape.type), x, y, x1, y1, shape.radius ?? 0, a0, a1];
}
const numbersOfBall = (ball) => [...ball.position, ball.radius, ...ball.velocity];
const floatsAt = (pointer, count) => [...new Float32Array(engine.HEAPF32.buffer, pointer, count)];

function askContact(mode, shape, ball) {
  const [met, x, y, nx, ny, setback, speed] = floatsAt(engine._AskContact(mode, ...numbersOf(shape), ...numbersOfBall(ball)), 7);
  return {isMet: met === 1, poi: [x, y], normal: [nx, ny], setback, speed};
}
function askSweep(mode, shape, ball) {
  const [met, x, y, nx, ny, endX, endY] = floatsAt(engine._AskSweep(mode, ...numbersOf(shape), ...numbersOfBall(ball)), 7);
  return {isMet: met === 1, poi: [x, y], normal: [nx, ny], end: [endX, endY]};
}
function askShape(shape, ball) {
  const [x, y, left, bottom, right, top, sector, tangents, ...ends] =
      floatsAt(engine._AskShape(...numbersOf(shape), ...numbersOfBall(ball).slice(0, 3)), 16);
  return {closest: [x, y], box: {left, bottom, right, top}, isInSector: sector === 1,
          tangents: tangents === 1 ? [ends.slice(0, 4), ends.slice(4, 8)] : []};
}
