// SPDX-License-Identifier: MIT
// Draws the collision toy: the chosen shape and ball with their boxes, closest point, tangents, sector, and where each engine
// says that the ball goes.
const sweptColours = {native: 'flipper', 'native-approximate': 'kicker', box2d: 'gate'};

function drawToy() {
  fitCanvas();
  const view = camera(), pixel = (devicePixelRatio || 1) / view.scale;
  brush.setTransform(1, 0, 0, 1, 0, 0);
  brush.clearRect(0, 0, canvas.width, canvas.height);
  brush.setTransform(view.scale, 0, 0, -view.scale, view.x, view.y);
  brush.fillStyle = colours.surface;
  brush.fillRect(view.left, view.bottom, view.right - view.left, view.top - view.bottom);
  brush.lineCap = 'round';
  const stroke = (colour, width, path, dash = []) => {
    brush.beginPath();
    path();
    brush.strokeStyle = colours[colour];
    brush.lineWidth = width * pixel;
    brush.setLineDash(dash.map((x) => x * pixel));
    brush.stroke();
    brush.setLineDash([]);
  };
  const dot = (p, colour, size) => {
    brush.beginPath();
    brush.arc(...p, size * pixel, 0, 2 * Math.PI);
    brush.fillStyle = colours[colour];
    brush.fill();
  };
  const line = (a, b) => () => { brush.moveTo(...a); brush.lineTo(...b); };
  const circle = (p, r) => () => brush.arc(...p, r, 0, 2 * Math.PI);
  const rectangle = ({left, bottom, right, top}) => () => brush.rect(left, bottom, right - left, top - bottom);

  const shape = chosenShape(), ball = chosenBall();
  if (shape) {
    const {closest, box, tangents} = askShape(shape, ball);
    const [x, y] = ball.position, r = ball.radius;
    for (const each of [box, {left: x - r, bottom: y - r, right: x + r, top: y + r}]) stroke('sensor', 1, rectangle(each), [4, 4]);
    if (shape.type === 'arc')
      for (const angle of shape.angles) stroke('sensor', 1, line(shape.position, plus(shape.position, turned(angle, 30))), [2, 5]);
    for (const [x0, y0, x1, y1] of tangents) stroke('lit', 1.5, line([x0, y0], [x1, y1]));
    stroke('wall', 1.5, line(ball.position, closest), [2, 4]);
    dot(closest, 'kicker', 5);
  }
  toy.scene.shapes.forEach((each, i) => {
    const colour = i === toy.shape ? 'kicker' : 'wall';
    if (each.type === 'point') dot(each.position, colour, 5);
    else if (each.p0) stroke(colour, 3, line(each.p0, each.p1));
    else if (each.angles && each.angles[0] !== each.angles[1]) stroke(colour, 3, () => brush.arc(...each.position, each.radius, ...each.angles));
    else stroke(colour, 3, circle(each.position, each.radius));
  });
  toy.scene.balls.forEach((each, i) => stroke('ball', i === toy.ball ? 3 : 1.5, circle(each.position, each.radius)));
  if (shape)
    for (const [name, colour] of Object.entries(sweptColours)) {
      const {isMet, poi, end} = askSweep(modes.indexOf(name), shape, ball);
      stroke(colour, 2, circle(end, ball.radius), name === 'native' ? [] : [5, 4]);
      if (isMet) dot(poi, colour, 4);
    }
  stroke('ball', 2, line(ball.position, plus(ball.position, ball.velocity)));
  for (const {at} of toyHandles()) stroke('ball', 1, circle(at, 5 * pixel));
}
