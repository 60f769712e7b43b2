#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Makes the picture of the README and the figures in README.md and docs/accuracy.md anew: scripts/results.sh
# [ARGUMENTS OF shapes-compare run], by default the full run. Needs python3.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
if (($# == 0)); then set -- --full; fi
"$root/compare/run.sh" --out "$root/build/report" --svg "$root/docs/overall.svg" "$@" | tee "$root/build/printed.txt"
cd "$root"
python3 scripts/results.py --keep build/report/run.json docs/results.json build/printed.txt
python3 scripts/results.py docs/results.json README.md docs/accuracy.md
