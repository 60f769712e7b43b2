// SPDX-License-Identifier: MIT
// The exact answers beside those of the engines: closed forms in double, of which no engine knows anything.
const dotOf = (a, b) => a[0] * b[0] + a[1] * b[1];
const scaled = (a, s) => [a[0] * s, a[1] * s];

/** The parts of a shape that a ball of radius r can touch: its centre has to be where `counts` says; `at` is the gap, normal and
    point of impact there, `time` when a ball that flies straight touches it, if ever. */
function exactParts(shape, r) {
  const round = (c, R, sign, counts) => ({
    counts,
    at(p) {
      const d = minus(p, c), length = lengthOf(d), out = length > 0 ? scaled(d, 1 / length) : [0, 1];
      return {gap: sign * (length - R) - r, normal: scaled(out, sign), poi: plus(c, scaled(out, R))};
    },
    time(p, v) { // from outside the earlier root, from inside the later one
      const d = minus(p, c), a = dotOf(v, v), b = dotOf(d, v), reach = R + sign * r, root = Math.sqrt(b * b - a * (dotOf(d, d) - reach * reach));
      return (-b - sign * root) / a;
    },
  });
  const face = (p0, n, counts) => ({
    counts,
    at(p) {
      const s = dotOf(n, minus(p, p0));
      return {gap: s - r, normal: n, poi: minus(p, scaled(n, s))};
    },
    time: (p, v) => (r - dotOf(n, minus(p, p0))) / dotOf(n, v),
  });
  const end = (p, counts) => round(p, 0, 1, counts);
  if (shape.type === 'point') return [end(shape.position, () => true)];
  if (shape.type === 'line_segment') {
    const way = minus(shape.p1, shape.p0), length = lengthOf(way);
    if (length === 0) return [end(shape.p0, () => true)];
    const along = scaled(way, 1 / length), left = [-along[1], along[0]];
    const share = (p) => dotOf(along, minus(p, shape.p0));
    const side = (n) => face(shape.p0, n, (p) => share(p) >= 0 && share(p) <= length && dotOf(n, minus(p, shape.p0)) >= 0);
    return [side(left), side(scaled(left, -1)), end(shape.p0, (p) => share(p) < 0), end(shape.p1, (p) => share(p) > length)];
  }
  const {position: c, radius: R} = shape, angles = shape.type === 'arc' ? shape.angles : [0, 0];
  const turn = 2 * Math.PI, within = (x) => ((x % turn) + turn) % turn, span = within(angles[1] - angles[0]);
  const inSector = (p) => span === 0 || within(Math.atan2(p[1] - c[1], p[0] - c[0]) - angles[0]) <= span;
  const isInside = (p) => r < R && lengthOf(minus(p, c)) < R;
  return [round(c, R, 1, (p) => inSector(p) && !isInside(p) && (span === 0 || lengthOf(minus(p, c)) >= R)),
          round(c, R, -1, (p) => inSector(p) && isInside(p)),
          ...(span === 0 ? [] : angles.map((angle) => end(plus(c, turned(angle, R)), (p) => !inSector(p) || lengthOf(minus(p, c)) < R && r >= R)))];
}

/** As askContact: where the ball is deepest in the shape. */
function exactContact(shape, ball) {
  const spots = exactParts(shape, ball.radius).filter((part) => part.counts(ball.position)).map((part) => part.at(ball.position));
  const {gap, normal, poi} = spots.reduce((a, b) => a.gap < b.gap ? a : b, {gap: Infinity, normal: [0, 1], poi: ball.position});
  return {isMet: gap < 0, poi, normal, setback: -gap, speed: -dotOf(ball.velocity, normal)};
}

/** As askSweep: one step of a second without loss, from impact to impact. */
function exactSweep(shape, ball) {
  const parts = exactParts(shape, ball.radius), answer = {isMet: false};
  let p = ball.position, v = ball.velocity, left = 1;
  for (let bounces = 0; bounces < 1000; ++bounces) {
    let first = {t: left};
    for (const part of parts) {
      const {gap, normal} = part.at(p), isThere = part.counts(p) && gap <= 1e-12;
      const t = isThere && dotOf(v, normal) < 0 ? 0 : part.time(p, v);
      if (!(t >= 0 && t < first.t) || (t > 0 && isThere && gap < -1e-12)) continue;
      const then = plus(p, scaled(v, t)), spot = part.at(then);
      if (part.counts(then) && dotOf(v, spot.normal) < 0) first = {t, spot};
    }
    p = plus(p, scaled(v, first.t));
    left -= first.t;
    if (!first.spot) break;
    const {normal, poi} = first.spot;
    if (!answer.isMet) Object.assign(answer, {isMet: true, poi, normal});
    v = minus(v, scaled(normal, 2 * dotOf(v, normal)));
  }
  return {...answer, end: p};
}
