#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes the result tables of a page from a run: scripts/results.py RUN_JSON PAGE

What is between `<!-- results: NAME -->` and `<!-- end -->` in the page is replaced."""
import json
import math
import pathlib
import re
import sys

VERSION = 4


def refuse(text):
    sys.exit(f"scripts/results.py: {text}")


def lost(rate, n):
    if n == 0:
        return "-"
    if rate["count"] == 0:
        return "0"
    share = 100 * rate["rate"]
    return f"{share:.2g}%" if share < 1 else f"{share:.1f}%"


def two(x):
    """Two digits that matter, without an exponent."""
    return f"{x:.0f}" if x >= 9.95 else f"{x:.2g}"


def degrees(radians):
    if radians is None:
        return "-"
    angle = math.degrees(radians)
    return "<.001" if angle < 0.001 else f"{angle:.2g}" if angle < 9.95 else f"{angle:.0f}"


def p95(summary):
    return degrees(summary["p95"])


def table(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines)


def columns(run):
    return [row["short"] for row in run["engines"]]


def overall(run):
    rows = [[f"`{e['name']}`", lost(e["tunneled"], run["overall"]["impacts"]), degrees(e["direction_error_p95"]),
             f"{e['ns_per_ball_step']:.0f}",
             "-" if e["ns_box2d_ratio"] is None else
             f"{two(e['ns_box2d_ratio'])} ({two(e['ns_box2d_ratio_scenes'][0])} to {two(e['ns_box2d_ratio_scenes'][1])})"]
            for e in run["overall"]["engines"]]
    return f"{run['overall']['result']}\n\n" + table(
        ["engine", "lost", "degrees, 95%", "ns per ball-step", "times as fast as Box2D"], rows)


def scenes(run):
    names = columns(run)
    head = ["scene", "take"]
    for title in ("lost", "degrees", "ns"):
        head += [f"{title} {name}" if i == 0 else name for i, name in enumerate(names)]
    rows = []
    for scene in run["scenes"]:
        engines = scene["engines"]
        rows.append([scene["name"], scene["take"] or "-"] + [lost(e["tunneled"], e["contacts"]) for e in engines] +
                    [p95(e["direction_error"]) for e in engines] +
                    [f"{e['ns_per_ball_step']:.0f}" for e in engines])
    return table(head, rows)


def answers(run):
    rows = []
    for scene in run["scenes"]:
        exact = [row["ns_per_ball_second"] for row in run["work_precision"]
                 if row["scene"] == scene["name"] and row["engine"] == "exact"]
        for demand, answer in zip(("1%", ".1%", "none lost"), scene["answers"]):
            first = demand == "1%"
            cells = []
            for engine in run["engines"]:
                choice = next((c for c in answer["choices"] if c["engine"] == engine["name"]), None)
                if choice is None:
                    cells.append("-")
                    continue
                label = "" if choice["label"] == "as it comes" else f" ({choice['label']})"
                cells.append(f"{two(choice['ns_per_ball_second'] / 1000)}{label}".replace("substeps", "sub")
                             .replace("iterations", "it."))
            rows.append([scene["name"] if first else "", demand, *cells,
                         two(exact[0] / 1000) if first and exact else ""])
    return table(["scene", "demand", *columns(run), "exact"], rows)


def main():
    if len(sys.argv) != 3:
        refuse("expected RUN_JSON PAGE")
    run = json.loads(pathlib.Path(sys.argv[1]).read_text())
    if run.get("version") != VERSION:
        refuse(f"{sys.argv[1]} is of version {run.get('version')}, expected {VERSION}: run shapes-compare again")
    page = pathlib.Path(sys.argv[2])
    text, n = re.subn(r"(<!-- results: (\w+) -->\n).*?(<!-- end -->)",
                      lambda m: m[1] + globals()[m[2]](run) + "\n" + m[3], page.read_text(), flags=re.S)
    if n == 0:
        refuse(f"{page} has no place for results")
    page.write_text(text)


if __name__ == "__main__":
    main()
