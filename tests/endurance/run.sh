#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Plays the games of the endurance tests for as long as you like, in a release build, and prints what came of it.
# tests/endurance/run.sh [STEPS [BUILD_FOLDER]]   10^7 steps by default, which take about ten minutes
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
steps=${1:-10000000}
build=${2:-$root/build/release}
launcher=()
if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi

cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release "${launcher[@]}" >/dev/null
cmake --build "$build" --target shapes-endurance-tests
SHAPES_ENDURANCE_STEPS=$steps nice "$build/tests/shapes-endurance-tests" --gtest_filter='*GoOnForever/*:*GoesOnForever/*'
