#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the fuzzers and runs each for some time, all at once, beginning with the corpus in a scratch copy. Fails with
# the command that repeats what was found. What is missing is installed, as root or with sudo.
# tests/fuzz/run.sh [SECONDS]             for each target; 60 by default
# tests/fuzz/run.sh --control [SECONDS]   the opposite: fuzzers with a fault planted in them have to find it in this time
# SHAPES_CMAKE_ARGS may hold further arguments for cmake, SHAPES_FUZZ_TARGETS some of "scene pairs world".
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/scripts/build.sh"
install_missing_packages "${build_packages[@]}" clang libclang-rt-14-dev jq

control=
if [[ "${1:-}" == --control ]]; then control=-control; shift; fi
seconds=${1:-60}
if [[ ! "$seconds" =~ ^[1-9][0-9]*$ ]]; then
  echo "SECONDS is '$seconds': expected a whole number above 0" >&2
  exit 2
fi
targets=${SHAPES_FUZZ_TARGETS:-scene pairs world}

cd "$root"
# shellcheck disable=SC2086 # several arguments in one variable
cmake --fresh --preset fuzz "${launcher[@]}" ${SHAPES_CMAKE_ARGS:-} >/dev/null
cmake --build --preset fuzz --target "shapes-fuzzers$control" --parallel "$(nproc)"

build=$root/build/fuzz/tests/fuzz
scratch=$root/build/fuzz/scratch
rm -rf "$scratch"
mkdir -p "$scratch"
# Each name that a scene file may have, as the schema lists them, in quotation marks.
jq -r '[.. | objects | ((.properties // {}) | keys[]), ((.enum // [])[], .const // empty | strings)] | unique[]
  | tojson | tojson' compare/scene.schema.json | cat - tests/fuzz/json.dict >"$scratch/json.dict"

fuzz() { # TARGET
  local target=$1 folder=$scratch/$1
  local program=$build/fuzz-$target$control
  mkdir -p "$folder/corpus" "$folder/found"
  cp tests/fuzz/corpus/"$target"/* "$folder/corpus"
  local args=(-max_total_time="$seconds" -rss_limit_mb=2048 -timeout=60 -print_final_stats=1)
  if [[ "$target" == scene ]]; then args+=(-max_len=6000 -dict=$scratch/json.dict); else args+=(-max_len=512 -len_control=0); fi
  local start=$SECONDS status=0
  # In found/ is what was found, with its kind before its name: crash, timeout, oom.
  "$program" "${args[@]}" -artifact_prefix="$folder/found/" "$folder/corpus" >"$folder/log" 2>&1 || status=$?
  local runs
  runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$folder/log")
  if ((status == 0)); then
    echo "$target: nothing found in $((SECONDS - start)) s, ${runs:-?} runs"
    if [[ -n "$control" ]]; then return 1; fi
    return 0
  fi
  if [[ -n "$control" ]]; then
    # Told by the invariant, after more than the corpus was tried.
    if grep -q '^Broken: ' "$folder/log" && grep -q '\sINITED ' "$folder/log"; then
      echo "$target: the planted fault was found in $((SECONDS - start)) s, ${runs:-?} runs: $(grep '^Broken: ' "$folder/log")"
      return 0
    fi
    echo "$target: ended without having found the planted fault: $folder/log"
    return 1
  fi
  echo "$target: FAILED after $((SECONDS - start)) s"
  grep -m 3 -E '^Broken: |ERROR: |runtime error|Assertion' "$folder/log" || tail -20 "$folder/log"
  echo "  the whole log: $folder/log"
  local found
  for found in "$folder"/found/*; do
    echo "  repeat it:     $program $found"
    echo "  keep it:       cp $found $root/tests/fuzz/corpus/$target/found-<what>"
  done
  return 1
}

failed=0
running=()
for target in $targets; do
  fuzz "$target" &
  running+=($!)
done
for process in "${running[@]}"; do wait "$process" || failed=1; done
exit "$failed"
