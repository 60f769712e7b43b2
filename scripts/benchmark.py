# SPDX-License-Identifier: MIT
"""From the JSON of shapes-benchmark to the table of docs/performance.md and a CSV file.

python3 benchmark.py benchmark.json performance.md baseline.csv
"""
import json
import re
import statistics
import sys
from collections import defaultdict

BEGIN, END = "<!-- peg field: begin -->\n", "<!-- peg field: end -->\n"


def read(path):
    """Nanoseconds of each repetition, by player, number of balls, and whether they meet each other."""
    times = defaultdict(list)
    with open(path, encoding="utf-8") as file:
        for run in json.load(file)["benchmarks"]:
            if run["run_type"] != "iteration":
                continue
            player, balls, pairs = run["name"].split("/")[:3]
            times[player, int(balls), pairs == "pairs"].append(1e9 * run["ball_step"])
    return times


def cell(times):
    """The median, and the least and the most."""
    if not times:
        return "-"
    low, median, high = min(times), statistics.median(times), max(times)
    return f"{median:,.0f} ({low:,.0f} to {high:,.0f})"


def table(times):
    players = sorted({player for player, _, _ in times}, key=lambda player: ("native" not in player, player))
    rows = sorted({(pairs, balls) for _, balls, pairs in times})
    lines = ["| balls | " + " | ".join(players) + " |", "|---" * (len(players) + 1) + "|"]
    for pairs, balls in rows:
        cells = [cell(times[player, balls, pairs]) for player in players]
        lines.append(f"| {balls:,}{', with pairs' if pairs else ''} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def main(json_path, markdown_path, csv_path):
    times = read(json_path)
    with open(markdown_path, encoding="utf-8") as file:
        text = file.read()
    if BEGIN not in text or END not in text:
        sys.exit(f"{markdown_path}: expected the lines {BEGIN.strip()} and {END.strip()}")
    text = re.sub(f"{BEGIN}.*{END}", lambda _: BEGIN + table(times) + END, text, flags=re.DOTALL)
    with open(markdown_path, "w", encoding="utf-8") as file:
        file.write(text)
    with open(csv_path, "w", encoding="utf-8") as file:
        file.write("player,balls,pairs,median_ns,least_ns,most_ns\n")
        for (player, balls, pairs), t in sorted(times.items()):
            if t:
                file.write(f"{player},{balls},{int(pairs)},{statistics.median(t):.1f},{min(t):.1f},{max(t):.1f}\n")


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(*sys.argv[1:])
