#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds everything in debug mode and runs all tests, on a fresh Debian 12 too. Missing packages are installed, as root
# or with sudo. SHAPES_CMAKE_ARGS may hold further arguments for cmake, such as -DSHAPES_BACKEND=box2d.
# tests/run.sh [PRESET]   a preset of CMakePresets.json; dev by default
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
preset=${1:-dev}
source "$root/scripts/build.sh"
install_missing_packages "${build_packages[@]}" "${test_packages[@]}"

cd "$root"
# The cache of an earlier run with other arguments goes; cmake --fresh would delete compiled objects, too.
rm -f "build/$preset/CMakeCache.txt"
# shellcheck disable=SC2086 # several arguments in one variable
quietly cmake --preset "$preset" "${launcher[@]}" ${SHAPES_CMAKE_ARGS:-}
cmake --build --preset "$preset" --parallel "$(nproc)"
# Two more than there are cores: browsers wait most of the time.
ctest --preset "$preset" --output-on-failure --parallel "$(($(nproc) + 2))"
# CTest counts runs of programs; their tests are many more.
sed -n 's/^\[  PASSED  \] \([0-9]*\) tests*\.$/\1/p' "build/$preset/Testing/Temporary/LastTest.log" |
  awk '{sum += $1} END {print sum " tests passed in these runs"}'
