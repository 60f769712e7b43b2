#!/bin/sh
# SPDX-License-Identifier: MIT
# The cost of an effect where it does not run: instructions of a step in the library as it is against one into which
# the effect is not compiled (SHAPES_WITHOUT_EFFECTS), counted by callgrind. Takes some minutes.
# Usage: tests/effects/measure.sh [BUILD_FOLDER]
set -eu
root=$(cd "$(dirname "$0")/../.." && pwd)
build=${1:-$(mktemp -d)}
effects="Gravity Kinematics BallPairs Sensors Events Continuous"
command -v valgrind > /dev/null || { echo "valgrind is not installed" >&2; exit 1; }

# $1 names the folder, $2 is what is not compiled in
make_build() {
  launcher=$(command -v ccache || true)
  cmake ${launcher:+-DCMAKE_CXX_COMPILER_LAUNCHER=$launcher} -S "$root" -B "$build/$1" -G Ninja -DCMAKE_BUILD_TYPE=Release -DSHAPES_WITH_BOX2D=OFF -DSHAPES_BUILD_TESTS=OFF \
        -DSHAPES_BUILD_EXAMPLES=OFF -DSHAPES_WITHOUT_EFFECTS="$2" > /dev/null
  ninja -C "$build/$1" Shapes > /dev/null
  c++ -std=c++20 -O2 -I"$root/include" -I"$root/tests" $(pkg-config --cflags eigen3) "$root/tests/effects/StepCost.cpp" \
      "$build/$1/libShapes.a" -o "$build/$1/step-cost"
}

# Instructions of a run.
count() {
  valgrind --tool=callgrind --callgrind-out-file=/dev/null "$@" 2>&1 > /dev/null | sed -n 's/.*Collected : //p'
}

# Instructions per step of $2 balls in build $1, where the effects that follow are called for. Both runs make the world.
per_step() {
  program=$build/$1/step-cost; balls=$2; shift 2
  few=$(count "$program" "$balls" 100 "$@"); many=$(count "$program" "$balls" 300 "$@")
  echo $(( (many - few) / 200 ))
}

make_build all ""
for effect in $effects; do make_build "no$effect" "$effect"; done
make_build none "$(echo $effects | tr ' ' ';')"

echo "100 balls, instructions per ball-step where an effect is not called for and all others are (but for Continuous):"
for effect in $effects; do
  others=$(for e in $effects; do [ "$e" = "$effect" ] || [ "$e" = Continuous ] || echo "$e"; done)
  with=$(per_step all 100 $others); without=$(per_step "no$effect" 100 $others)
  echo "$effect $with $without" | awk '{printf "  %-11s %8.1f as it is, %8.1f without it: %+.2f (%+.2f%%)\n", $1, $2/100, $3/100, ($2-$3)/100, 100*($2-$3)/$3}'
done
echo "one ball in a box, nothing called for, instructions per step:"
with=$(per_step all 1); without=$(per_step none 1)
echo "  $with as it is, $without without any effect: +$((with - without))"
echo "one ball in a box, Events called for:"
with=$(per_step all 1 Events); without=$(per_step none 1)
echo "  $with as it is, $without without any effect: +$((with - without))"
