// SPDX-License-Identifier: MIT
// Draws shapes, balls and their paths.
const Drawing = (() => {
  // Paths that coincide stay visible: the exact one is broad and below, the others are dashed with the same
  // period, each in the gaps of the others.
  const dash = 4.5, slot = 6;
  function lineOf(name) {
    const engines = Data.tracks.filter((track) => track !== 'exact'), i = engines.indexOf(name);
    if (i < 0) return {dash: [], offset: 0, width: 6};
    return {dash: [dash, Math.max(1, engines.length) * slot - dash], offset: -slot * i, width: 3};
  }

  /** The same line for a legend, as a background of CSS. */
  function dashesOf(name) {
    const {dash: [on, off]} = lineOf(name);
    return on ? `repeating-linear-gradient(90deg, var(--engine) 0 ${on}px, transparent ${on}px ${
                    Math.min(on + off, 3 * on)}px)`
              : 'var(--engine)';
  }

  const isPlace = (p) => Format.isNumber(p[0]) && Format.isNumber(p[1]);
  const lerp = (a, b, t) => a + (b - a) * t;

  /** Where ball `ball` of a flat track of `balls` is; between frames on the straight line. */
  function placeAt(track, balls, ball, frame) {
    const last = track.length / (2 * balls) - 1;
    const f = Math.max(0, Math.min(frame, last)), i = Math.floor(f), j = Math.min(i + 1, last);
    const at = (k) => [track[2 * (k * balls + ball)], track[2 * (k * balls + ball) + 1]];
    const a = at(i), b = at(j);
    if (f === i || !isPlace(b)) return a;
    return [lerp(a[0], b[0], f - i), lerp(a[1], b[1], f - i)];
  }

  function angleAt(angles, frame) {
    if (!Array.isArray(angles) || angles.length === 0) return 0;
    const f = Math.max(0, Math.min(frame, angles.length - 1)), i = Math.floor(f);
    return lerp(angles[i], angles[Math.min(i + 1, angles.length - 1)], f - i) || 0;
  }

  /** The pose of a shape that has turned by `angle` about its centre. */
  function turned(shape, angle) {
    if (!angle || !shape.center) return shape;
    const [cx, cy] = shape.center, c = Math.cos(angle), s = Math.sin(angle);
    const points =
        shape.points.map(([x, y]) => [cx + c * (x - cx) - s * (y - cy), cy + s * (x - cx) + c * (y - cy)]);
    return {...shape, points, angles: shape.angles?.map((a) => a + angle)};
  }

  function sweepOf(angles) {
    if (!Array.isArray(angles)) return null;
    const turn = 2 * Math.PI, sweep = ((angles[1] - angles[0]) % turn + turn) % turn;
    return sweep < 1e-6 || Math.abs(angles[1] - angles[0]) > turn - 1e-6 ? null : sweep;
  }

  function tracePath(ctx, camera, shape) {
    const [px, py] = camera.toPicture(shape.points[0]);
    ctx.beginPath();
    if (shape.type === 'segment') {
      ctx.moveTo(px, py);
      ctx.lineTo(...camera.toPicture(shape.points[1]));
    } else if (shape.type === 'point') {
      ctx.arc(px, py, 3, 0, 2 * Math.PI);
    } else {
      const sweep = shape.type === 'arc' ? sweepOf(shape.angles) : null;
      const from = sweep === null ? 0 : shape.angles[0];
      ctx.arc(px, py, Math.max(0, shape.radius * camera.scale), -from, -(from + (sweep ?? 2 * Math.PI)),
              true);
    }
  }

  function drawShape(ctx, camera, shape, inks) {
    tracePath(ctx, camera, shape);
    ctx.setLineDash(shape.sensor ? [4, 4] : []);
    ctx.lineWidth = shape.sensor ? 1 : 2;
    ctx.strokeStyle = shape.sensor ? inks.muted : inks.ink;
    if (shape.type === 'point' && !shape.sensor) {
      ctx.fillStyle = inks.ink;
      ctx.fill();
    } else if (shape.type === 'circle' && !shape.sensor) {
      ctx.fillStyle = inks.line;
      ctx.fill();
    }
    ctx.stroke();
  }

  /** The place of a shape that has moved by [x0, y0, x1, y1, ...] in the frames. */
  function moved(shape, offsets, frame) {
    if (!offsets?.length) return shape;
    const f = Math.max(0, Math.min(frame, offsets.length / 2 - 1)), i = 2 * Math.floor(f);
    const j = Math.min(i + 2, offsets.length - 2);
    const [dx, dy] = [0, 1].map((k) => lerp(offsets[i + k], offsets[j + k], f - i / 2));
    return {...shape, points: shape.points.map(([x, y]) => [x + dx, y + dy])};
  }

  /** All shapes at a frame; angles and offsets are listed for those that turn or move, in their order. */
  function drawShapes(ctx, camera, shapes, orientations, offsets, frame) {
    const inks = {ink: Data.css('--ink'), muted: Data.css('--muted'), line: Data.css('--line')};
    let turning = 0, moving = 0;
    for (const shape of shapes) {
      const angle = shape.turns ? angleAt(orientations?.[turning++], frame) : 0;
      const ways = shape.moves ? offsets?.[moving++] : undefined;
      drawShape(ctx, camera, moved(turned(shape, angle), ways, frame), inks);
    }
    ctx.setLineDash([]);
  }

  /** The way of a ball up to `frame`. A jump to a new start is no way. */
  function drawWay(ctx, camera, track, balls, ball, frame, longest) {
    ctx.beginPath();
    let before = null;
    for (let f = 0;; f = Math.min(f + 1, frame)) {
      const p = placeAt(track, balls, ball, f);
      const joins = before && isPlace(p) && Math.hypot(p[0] - before[0], p[1] - before[1]) <= longest;
      if (isPlace(p)) ctx[joins ? 'lineTo' : 'moveTo'](...camera.toPicture(p));
      before = isPlace(p) ? p : null;
      if (f >= frame) break;
    }
    ctx.stroke();
  }

  function drawBall(ctx, camera, place, radius, mark, isInQuestion) {
    if (!isPlace(place)) return;
    const [x, y] = camera.toPicture(place), r = Math.max(radius * camera.scale, 2);
    ctx.beginPath();
    ctx.arc(x, y, r, 0, 2 * Math.PI);
    const alpha = ctx.globalAlpha;
    ctx.globalAlpha = alpha * (isInQuestion ? 0.3 : 0.12);
    ctx.fill();
    ctx.globalAlpha = alpha;
    ctx.stroke();
    drawMark(ctx, mark, x, y, 4);
  }

  /** The mark of an engine; a dot for others. */
  function drawMark(ctx, mark, x, y, r) {
    const corners = {
      triangle: [[0, -1], [1, 1], [-1, 1]],
      rect: [[-1, -1], [1, -1], [1, 1], [-1, 1]],
      rectRot: [[0, -1.2], [1.2, 0], [0, 1.2], [-1.2, 0]],
      rectRounded: [[-1, -.5], [-.5, -1], [.5, -1], [1, -.5], [1, .5], [.5, 1], [-.5, 1], [-1, .5]],
    }[mark];
    ctx.beginPath();
    if (corners)
      corners.forEach(([dx, dy], i) => ctx[i ? 'lineTo' : 'moveTo'](x + r * dx, y + r * dy));
    else
      ctx.arc(x, y, mark === 'circle' ? r : r / 2, 0, 2 * Math.PI);
    ctx.fill();
  }

  /** A ring around a ball, to show where to look. */
  function drawRing(ctx, camera, place, radius) {
    if (!isPlace(place)) return;
    ctx.beginPath();
    ctx.arc(...camera.toPicture(place), Math.max(radius * camera.scale, 2) + 9, 0, 2 * Math.PI);
    ctx.strokeStyle = Data.css('--heat');
    ctx.lineWidth = 3;
    ctx.stroke();
  }

  /** Ways and balls of one engine. */
  function drawTrack(ctx, camera, name, track, radii, frame, ballInQuestion, longest) {
    const line = lineOf(name), colour = Data.colour(name);
    ctx.strokeStyle = ctx.fillStyle = colour;
    ctx.lineCap = 'butt';
    for (let ball = 0; ball < radii.length; ++ball) {
      const isInQuestion = ball === ballInQuestion || radii.length === 1;
      ctx.setLineDash(line.dash);
      ctx.lineDashOffset = line.offset;
      ctx.lineWidth = isInQuestion ? line.width : line.width / 2;
      drawWay(ctx, camera, track, radii.length, ball, frame, longest);
      drawBall(ctx, camera, placeAt(track, radii.length, ball, frame), radii[ball], Data.rowOf(name).mark,
               isInQuestion);
    }
    ctx.setLineDash([]);
    ctx.lineDashOffset = 0;
  }

  /** The box of the picture: shapes and paths, as far as they are in the bounds. */
  function boxOf(scene, clip) {
    const xs = [], ys = [];
    const add = (x, y, r) => {
      if (isPlace([x, y])) {
        xs.push(x - r, x + r);
        ys.push(y - r, y + r);
      }
    };
    for (const shape of scene.shapes ?? [])
      for (const [x, y] of shape.points)
        add(x, y, shape.radius || 0);
    for (const track of clip?.tracks ?? []) {
      for (let i = 0; i + 1 < track.length; i += 2)
        add(track[i], track[i + 1], scene.radii?.[(i / 2) % scene.radii.length] ?? 0);
    }
    const b = scene.bounds, least = (v, bound) => Math.max(Math.min(...v), bound),
          most = (v, bound) => Math.min(Math.max(...v), bound);
    if (xs.length === 0) return b;
    const r = Math.max(0, ...(scene.radii ?? []));
    return {
      left: least(xs, b.left - r),
      right: most(xs, b.right + r),
      bottom: least(ys, b.bottom - r),
      top: most(ys, b.top + r)
    };
  }

  return {dashesOf, placeAt, drawShapes, drawTrack, drawRing, boxOf};
})();
