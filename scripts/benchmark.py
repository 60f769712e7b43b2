# SPDX-License-Identifier: MIT
"""From the JSON of shapes-benchmark to a CSV file, whose other rows stay, and from that to the tables of a document.

python3 benchmark.py benchmark.json performance.md baseline.csv
"""
import csv
import json
import math
import re
import statistics
import sys
import textwrap
from collections import defaultdict

KEYS = ["field", "player", "balls", "pairs"]
FIGURES = ["median_ns", "least_ns", "most_ns", "lost"]
KINDS = ["point", "segment", "circle", "arc", "ball"]
PLACES = ["far", "meeting"]
# The fields of each table, and how its rows name them.
TABLES = {
    "peg field": {"peg-field": ""},
    "pinball": {"pinball": ""},
    "piles": {"pile-settling": "settling", "pile-resting": "at rest"},
    "single pairs": {f"pair-{place}-{kind}": f"{kind}, {place}" for kind in KINDS for place in PLACES},
}
# Whose time is divided by whose. Of Chipmunk's tree and hash the faster one counts.
RATIOS = [
    ("native-approximate", "box2d-discrete"),
    ("native-continuous", "box2d"),
    ("native-continuous", "chipmunk"),
    ("box2d-through-shapes", "box2d-like-shapes"),
    ("native", "box2d"),
]
MOST_LOST = 0.1  # of the balls, for a time to count in a ratio


def read_json(path):
    """Rows of a CSV file, from nanoseconds of each repetition."""
    runs = defaultdict(list)
    with open(path, encoding="utf-8") as file:
        for run in json.load(file)["benchmarks"]:
            if run["run_type"] == "iteration":
                field, player, balls, pairs = run["name"].split("/")[:4]
                runs[field, player, int(balls), int(pairs == "pairs")].append(run)
    rows = {}
    for key, repetitions in runs.items():
        times = [1e9 * run["seconds"] for run in repetitions]
        lost = statistics.median(run.get("lost", 0) for run in repetitions)
        rows[key] = (statistics.median(times), min(times), max(times), lost)
    return rows


def read_csv(path):
    with open(path, encoding="utf-8", newline="") as file:
        return {
            (row["field"], row["player"], int(row["balls"]), int(row["pairs"])): tuple(
                float(row[figure] or "nan") for figure in FIGURES
            )
            for row in csv.DictReader(file)
        }


def write_csv(path, rows):
    with open(path, "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(KEYS + FIGURES)
        for key, (*times, lost) in sorted(rows.items()):
            times = [f"{time:.1f}" if time >= 10 else f"{time:.3g}" for time in times]
            writer.writerow([*key, *times, "" if math.isnan(lost) else f"{lost:.0f}"])


def number(x):
    """1,234 or 3.4 or .056"""
    return f"{x:,.0f}" if x >= 9.95 else f"{x:.1f}" if x >= 0.995 else f"{x:.2g}".lstrip("0") or "0"


def cell(row):
    """The median, and the least and the most."""
    if row is None:
        return "-"
    median, low, high, lost = row
    return f"{number(median)} ({number(low)} to {number(high)})" + (f", {lost:,.0f} lost" if lost > 0 else "")


def table(rows, names):
    """Markdown of the rows of these fields; nothing if there are none."""
    rows = {key: row for key, row in rows.items() if key[0] in names}
    if not rows:
        return ""
    players = sorted({key[1] for key in rows}, key=lambda player: ("native" not in player, player))
    cases = sorted({(pairs, list(names).index(field), field, balls) for field, _, balls, pairs in rows})
    are_calls = all(field.startswith("pair-") for field in names)
    has_both = len({pairs for pairs, *_ in cases}) > 1
    unit = "ns per call" if are_calls else "balls (ns per ball and step)"
    lines = [f"| {unit} | " + " | ".join(players) + " |", "|---" * (len(players) + 1) + "|"]
    for pairs, _, field, balls in cases:
        words = [names[field], "" if are_calls else f"{balls:,}", "with pairs" if pairs and has_both else ""]
        cells = [cell(rows.get((field, player, balls, pairs))) for player in players]
        lines.append(f"| {', '.join(filter(None, words))} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n" + ratios(rows, names)


def ratios(rows, names):
    """A sentence for each group of fields (far, meeting): the least and the most of each ratio of medians."""
    medians = defaultdict(lambda: defaultdict(lambda: math.inf))
    for (field, player, balls, pairs), (median, _, _, lost) in rows.items():
        if lost <= MOST_LOST * balls:
            group, case = names[field].split(", ")[-1], (field, balls, pairs)
            for name in [player, "chipmunk"] if player.startswith("chipmunk") else [player]:
                medians[group, name][case] = min(medians[group, name][case], median)
    lines = []
    for group in sorted({group for group, _ in medians}):
        parts = []
        for one, other in RATIOS:
            ones, others = medians[group, one], medians[group, other]
            if found := [ones[case] / others[case] for case in ones.keys() & others.keys()]:
                parts.append(f"{one} / {other} {number(min(found))} to {number(max(found))}")
        if parts:
            where = f", {group}" if group else ""
            lines += ["", *textwrap.wrap(f"Ratios of medians{where}: {'; '.join(parts)}.", 120, break_on_hyphens=False)]
    return "".join(f"{line}\n" for line in lines)


def main(json_path, markdown_path, csv_path):
    write_csv(csv_path, read_csv(csv_path) | read_json(json_path))
    rows = read_csv(csv_path)
    with open(markdown_path, encoding="utf-8") as file:
        text = file.read()
    for name, fields in TABLES.items():
        begin, end = f"<!-- {name}: begin -->\n", f"<!-- {name}: end -->\n"
        if begin not in text or end not in text:
            sys.exit(f"{markdown_path}: expected the lines {begin.strip()} and {end.strip()}")
        text = re.sub(f"{begin}.*{end}", lambda _: begin + table(rows, fields) + end, text, flags=re.DOTALL)
    with open(markdown_path, "w", encoding="utf-8") as file:
        file.write(text)
    write_csv(csv_path, rows)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
