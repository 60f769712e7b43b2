#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# The same bits from g++ and clang++, without and with optimisation: builds the shapes, the native engine and the golden
# tests in each of these four ways and runs them, with traps on for invalid operations, divisions by zero and overflows.
# The control is a fifth way, with -ffast-math, that has to give other bits.
# tests/golden/run.sh [BUILD_FOLDER [WORK_FOLDER]]
#   BUILD_FOLDER  of the whole project, for what reads the scenes: that is built once; build/dev by default
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build=${1:-$root/build/dev}
work=${2:-$root/build/golden}
mkdir -p "$work"
launcher=$(command -v ccache || true)
export CCACHE_NOHASHDIR=1

[ -f "$build/CMakeCache.txt" ] || cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Debug >/dev/null
cmake --build "$build" --target shapes-compare-parts >/dev/null

traps=-DSHAPES_GOLDEN_TRAPS
make_tests() { # COMPILER FLAGS...: prints the program
  local compiler=$1 name
  name=$(echo "$*" | tr -d ' +')
  shift
  cmake -S "$root" -B "$work/$name" -G Ninja ${launcher:+-DCMAKE_CXX_COMPILER_LAUNCHER=$launcher} \
        -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE= -DCMAKE_CXX_FLAGS="$*" -DSHAPES_WITH_BOX2D=OFF \
        -DSHAPES_BUILD_TESTS=OFF -DSHAPES_BUILD_EXAMPLES=OFF >/dev/null
  cmake --build "$work/$name" --target Shapes >/dev/null
  # shellcheck disable=SC2046,SC2086 # several flags, or none
  "$compiler" -std=c++20 "$@" -ffp-contract=off $traps -DSHAPES_SCENES_DIR="\"$root/compare/scenes\"" \
    -I"$root/include" -I"$root/tests" -I"$root/compare" $(pkg-config --cflags eigen3) \
    "$root/tests/golden/GoldenTest.cpp" "$root/tests/Played.cpp" "$build"/compare/libshapes-{compare-parts,scenes}.a \
    "$work/$name/libShapes.a" $(pkg-config --libs fmt gtest_main) -o "$work/$name/golden-tests"
  echo "$work/$name/golden-tests"
}

for compiler in g++ clang++; do
  for flag in -O0 -O3; do
    program=$(make_tests $compiler $flag)
    echo "$compiler $flag: $("$program" --gtest_brief=1 | tail -1)"
  done
done

traps=
program=$(make_tests g++ -O3 -ffast-math)
if "$program" >"$work/control.log" 2>&1; then
  echo "g++ -O3 -ffast-math gives the same bits: the control has failed" >&2
  exit 1
fi
echo "g++ -O3 -ffast-math: $(grep -c 'is what came out' "$work/control.log") scenes with other bits, as it has to be"
