#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes seeds into corpus/, in the format of Bytes.h: of fuzz-pairs one pair of each kind, of fuzz-world a short game on
each engine, of fuzz-scene numbers for the scene that is in its source. Other seeds of fuzz-scene are scene files. What
was found (found-*) is left alone."""
import pathlib
import struct

corpus = pathlib.Path(__file__).parent / "corpus"


def num(value):
    """A number, as a multiple of 1/128."""
    return b"\0" + struct.pack("<h", round(value * 128))


def raw(value):
    return b"\xff" + struct.pack("<f", value)


def vec(x, y):
    return num(x) + num(y)


for name, numbers in (("nothing", ""), ("some", ((0, 1), (1, 0), (2, -10), (4, 2), (20, 3))),
                      ("all", [(i, 0.5 * i) for i in range(60)])):
    (corpus / "scene" / f"numbers-{name}").write_bytes(b"\1" + b"".join(bytes([i]) + num(f) for i, f in numbers))

BOTH, FRONT, BACK = range(3)
POINT, SEGMENT, CIRCLE, ARC, BALL = range(5)
STATIC = b"\0"


def turning(speed, center=(0, 0), angle=0.0):
    return b"\1" + num(speed) + vec(*center) + num(angle)


def pair(name, ball, shape, moved=False, dt=0, is_ball=False):
    text = bytes([4 if is_ball else 0, dt]) + ball + shape + bytes([moved])
    (corpus / "pairs" / name).write_bytes(text)


def ball(p, v, r):
    return vec(*p) + vec(*v) + num(r)


def shape(kind, sides, *numbers, motion=STATIC):
    return bytes([sides, kind]) + b"".join(numbers) + motion


falling = ball((0, 0.75), (0, -60), 0.5)
overlapping = ball((0.25, 0.25), (1, -2), 0.5)
for motion, suffix in ((STATIC, ""), (turning(1.5, (1, 0), 0.5), "-turning")):
    pair("point" + suffix, falling, shape(POINT, BOTH, vec(0, 0), motion=motion))
    pair("circle" + suffix, falling, shape(CIRCLE, BOTH, vec(0, -1), num(1), motion=motion), moved=True)
    pair("ring" + suffix, ball((0, 0), (90, 30), 0.5), shape(CIRCLE, BOTH, vec(0, 0), num(2), motion=motion))
    for sides, name in ((BOTH, "both"), (FRONT, "front"), (BACK, "back")):
        pair(f"segment-{name}{suffix}", overlapping, shape(SEGMENT, sides, vec(-1, 0), vec(1, 0), motion=motion))
        pair(f"arc-{name}{suffix}", ball((0.75, 0.25), (9, -3), 0.25),
             shape(ARC, sides, vec(0, 0), num(1), num(5.5), num(1.5), motion=motion), moved=True)
pair("segment-end", ball((1.25, 1), (0, -90), 0.5), shape(SEGMENT, BOTH, vec(-1, 0), vec(1, 0)))
pair("segment-without-length", falling, shape(SEGMENT, BOTH, vec(0, 0), vec(0, 0)))
pair("arc-full", ball((0, 0), (99, 1), 0.25), shape(ARC, BOTH, vec(0, 0), num(1), num(1), num(1)))
pair("far", vec(0, 0) + raw(1e17) + raw(-1e17) + num(1), shape(POINT, BOTH, raw(1e15) + raw(-1e15)), dt=2)
pair("balls", falling, ball((0, -0.75), (0, 60), 0.5), is_ball=True)
pair("balls-overlapping", overlapping, ball((0, 0), (0, 3), 0.25), is_ball=True, moved=True)

STEP, SAVE, LOAD, GRAVITY = 6, 10, 11, 12
REMOVE, SET_POS, SET_VEL, ORIENT, ROT_SPEED, ROT_CENTER, ELASTICITY, SENSOR, COLLIDE, RESET = range(13, 23)
COMPOUND, PLAIN, IS_SENSOR, KINEMATIC = 5, 0, 7, 8


def add(kind, *numbers, sides=None, flags=PLAIN, turn=b""):
    return bytes([kind]) + b"".join(numbers) + (b"" if sides is None else bytes([sides])) + bytes([flags]) + turn


def add_ball(p, v, r=0.25, flags=PLAIN, more=b""):
    return bytes([BALL]) + vec(*p) + vec(*v) + num(r) + bytes([flags]) + more


steps = bytes([STEP]) * 3
box = b"".join(add(SEGMENT, vec(*p), vec(*q), sides=BOTH)
               for p, q in (((-2, -2), (2, -2)), ((2, -2), (2, 2)), ((2, 2), (-2, 2)), ((-2, 2), (-2, -2))))
table = box + add(ARC, vec(0, 0), num(1), num(0.5), num(4), sides=FRONT) + add(POINT, vec(-1, 1)) + \
    add(CIRCLE, vec(1.25, 1.25), num(0.5), flags=KINEMATIC, turn=num(2) + vec(1, 1))
balls = add_ball((-1.5, 0), (30, 5)) + add_ball((1.5, -1.5), (-9, 20)) + add_ball((0, -1.5), (0, 0), 0.125)
games = {
    "bounces": balls[:0] + table + balls + steps * 3,
    "gravity": bytes([GRAVITY]) + vec(0, -10) + box + balls + steps * 3,
    "saves": table + balls + steps + bytes([SAVE, 1, 3]) + steps + bytes([REMOVE, 8, LOAD]) + steps,
    "sensors": box + add(CIRCLE, vec(0, 0), num(1), flags=IS_SENSOR) + balls + steps + bytes([REMOVE, 4]) + steps +
    bytes([SENSOR, 1, 1]) + steps,
    "changes": table + balls + steps + bytes([SET_POS, 7]) + vec(0, 1) + bytes([SET_VEL, 7]) + vec(200, 9) +
    bytes([ORIENT, 6]) + num(1) + bytes([ROT_SPEED, 6]) + num(-3) + bytes([ROT_CENTER, 6]) + vec(1, 2) +
    bytes([ELASTICITY, 0]) + num(2) + bytes([COLLIDE, 1, 0]) + steps + bytes([RESET, 6]) + steps,
    "compound": balls + bytes([COMPOUND, 1, SEGMENT]) + vec(-1, -1) + vec(1, -1) + bytes([BOTH, PLAIN, POINT]) +
    vec(1, -1) + bytes([PLAIN]) + vec(0, -1) + num(4) + steps * 2,
    "crowd": b"".join(add_ball((0.5 * x - 1, 0.5 * y - 1), (8 * y, -5 * x), 0.3) for x in range(3) for y in range(3)) +
    box + steps * 2,
}
for kind, engine in enumerate(("automatic", "approximate", "continuous", "shipped", "tuned")):
    for name, game in games.items():
        if kind in (0, 3) and name in ("gravity", "compound"):
            continue
        substeps, forced, forbidden, unusual = 0, 0, 0, 0
        (corpus / "world" / f"{engine}-{name}").write_bytes(
            bytes([kind, substeps, forced, forbidden, unusual]) + game)
