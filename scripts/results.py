#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Puts the figures of a run into documents.

scripts/results.py RUN_JSON PAGE...                  fills the pages
scripts/results.py --check RUN_JSON PAGE...          says what in them is not of this run, and fails then
scripts/results.py --keep RUN_JSON FILE [PRINTED]    writes what the pages need of the run, which is another RUN_JSON,
                                                     and of what shapes-compare printed

What is between `<!-- results: NAME ARGUMENT... -->` and `<!-- end -->` in a page is what the function NAME of this file
returns for the run and the arguments."""
import json
import math
import pathlib
import re
import sys

VERSION = 5
PLACE = re.compile(r"(<!-- results: (\w+)((?: [\w-]+)*) -->(\n?))(.*?)(<!-- end -->)", re.S)


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


def engine_of(rows, name):
    return next(row for row in rows if row["name"] == name)


def scene_of(run, name):
    return next(scene for scene in run["scenes"] if scene["name"] == name)


def terminal(run, *names):
    """The rows that shapes-compare has printed for some scenes, and for all together."""
    head, *rows = run["terminal"]
    of_all = rows.index("")
    some = [row for row in rows[:of_all] if row.split()[0] in names]
    return "\n".join(["```text", head, *some, "...", *rows[of_all:], "```"])


# Figures within a sentence: of an engine in a scene, or over all of them.


def result(run):
    return run["overall"]["result"]


def loss(run, scene, engine):
    row = engine_of(scene_of(run, scene)["engines"], engine)
    return lost(row["tunneled"], row["contacts"])


def angle(run, scene, engine):
    return p95(engine_of(scene_of(run, scene)["engines"], engine)["direction_error"])


def angles(run, engine):
    return degrees(engine_of(run["overall"]["engines"], engine)["direction_error_p95"])


def nanoseconds(run, engine):
    return f"{engine_of(run['overall']['engines'], engine)['ns_per_ball_step']:,.0f}"


def range_of_times(run, engine):
    low, high = engine_of(run["overall"]["engines"], engine)["ns_box2d_ratio_scenes"]
    return f"{two(low)} to {two(high)}"


def price(run, engine):
    """In times of Box2D as it ships."""
    return two(1 / engine_of(run["overall"]["engines"], engine)["ns_box2d_ratio"])


def not_good(run, engine):
    names = [f"`{scene['name']}`" for scene in run["scenes"]
             if engine_of(scene["engines"], engine)["grade"] != "good"]
    return ", ".join(names) or "none"


def ladder(run, scene, substeps, figure):
    """Of native-approximate with so many substeps: `lost`, or `angle` in radians."""
    row = next(row for row in run["work_precision"]
               if row["scene"] == scene and row["engine"] == "native-approximate"
               and row["label"] == ("as it comes" if substeps == "1" else f"{substeps} substeps"))
    return lost(row["tunneled_rate"], row["contacts"]) if figure == "lost" else f"{row['direction_error_p95']:.1g}"


def printed(text):
    """The rows of the scenes and of all engines, without what stands above and below them."""
    lines = text.splitlines()
    first = next(i for i, line in enumerate(lines) if line.startswith("scene "))
    last = next(i for i, line in enumerate(lines) if line.startswith("Result: "))
    return lines[first:last - 1]


def kept(run):
    """The parts of a run that the functions above read."""
    def some(row, *keys):
        return {key: short(row[key]) for key in keys}

    def short(x):
        if isinstance(x, float):
            return float(f"{x:.7g}")
        if isinstance(x, list):
            return [short(y) for y in x]
        return {key: short(y) for key, y in x.items() if key not in ("low", "high", "median", "max")} \
            if isinstance(x, dict) else x

    scenes = []
    for scene in run["scenes"]:
        row = some(scene, "name", "take")
        row["answers"] = [{"choices": [some(choice, "engine", "label", "ns_per_ball_second")
                                       for choice in answer["choices"]]} for answer in scene["answers"]]
        row["engines"] = [some(engine, "name", "grade", "contacts", "tunneled", "direction_error", "ns_per_ball_step")
                          for engine in scene["engines"]]
        scenes.append(row)
    ladders = [some(row, "scene", "engine", "label", "ns_per_ball_second", "direction_error_p95", "contacts",
                    "tunneled_rate")
               for row in run["work_precision"] if row["engine"] in ("native-approximate", "exact")]
    overall = some(run["overall"], "impacts", "result")
    overall["engines"] = [some(row, "name", "tunneled", "direction_error_p95", "ns_per_ball_step",
                               "ns_per_ball_step_scenes", "ns_box2d_ratio", "ns_box2d_ratio_scenes")
                          for row in run["overall"]["engines"]]
    return {"version": run["version"], "engines": [some(row, "name", "short") for row in run["engines"]],
            "overall": overall, "scenes": scenes, "work_precision": ladders}


def write_kept(run, path, printed_path=None):
    """A row of a list in a line, so that a change can be read."""
    parts = kept(run)
    if printed_path is not None:
        parts["terminal"] = printed(printed_path.read_text())
    text = ",\n".join(f'"{key}": ' + ("[\n" + ",\n".join(map(json.dumps, part)) + "]" if isinstance(part, list)
                                     else json.dumps(part)) for key, part in parts.items())
    path.write_text("{" + text + "}\n")


def fill(run, path, is_check):
    """Whether everything in the page was of this run already."""
    page = path.read_text()
    if not PLACE.search(page):
        refuse(f"{path} has no place for results")
    is_same = True

    def text_of(match):
        nonlocal is_same
        opening, name, arguments, line, old, end = match.groups()
        new = globals()[name](run, *arguments.split()) + line
        if new != old:
            is_same = False
            if is_check:
                print(f"{path}: results: {name}{arguments}: {old.strip()!r}, expected {new.strip()!r}")
        return opening + new + end

    filled = PLACE.sub(text_of, page)
    if not is_check:
        path.write_text(filled)
    return is_same


def main():
    words = sys.argv[1:]
    option = words.pop(0) if words and words[0].startswith("--") else None
    if option not in (None, "--check", "--keep") or len(words) < 2:
        sys.exit(__doc__)
    run = json.loads(pathlib.Path(words[0]).read_text())
    if run.get("version") != VERSION:
        refuse(f"{words[0]} is of version {run.get('version')}, expected {VERSION}: run shapes-compare again")
    pages = [pathlib.Path(word) for word in words[1:]]
    if option == "--keep":
        write_kept(run, *pages)
    elif not all([fill(run, page, option == "--check") for page in pages]) and option == "--check":
        sys.exit(1)


if __name__ == "__main__":
    main()
