#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Times the peg field, a pinball table, piles and single pairs on each engine and on its peers, in one program and in
# turns, and writes the tables of docs/performance.md and compare/benchmark/baseline.csv: scripts/benchmark.sh
# [ARGUMENTS OF Google Benchmark]. With --benchmark_filter=REGEX the other rows stay as they are. Installs what it needs;
# takes some eight minutes.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/scripts/build.sh"
install_missing_packages "${build_packages[@]}" libbenchmark-dev chipmunk-dev
build=$root/build/benchmark
quietly cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DSHAPES_BUILD_BENCHMARK=ON \
  -DSHAPES_BUILD_TESTS=OFF -DSHAPES_BUILD_EXAMPLES=OFF "${launcher[@]}"
quietly cmake --build "$build" --target shapes-benchmark
"$build/compare/benchmark/shapes-benchmark" --benchmark_repetitions=3 --benchmark_enable_random_interleaving=true \
  --benchmark_out="$build/benchmark.json" --benchmark_out_format=json "$@"
python3 "$root/scripts/benchmark.py" "$build/benchmark.json" "$root/docs/performance.md" "$root/compare/benchmark/baseline.csv"
