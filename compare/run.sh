#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds shapes-compare in release mode and runs it: compare/run.sh [ARGUMENTS OF shapes-compare run]
# Works on a fresh Debian 12: missing packages are installed, as root or with sudo. Only the output of shapes-compare goes
# to the standard output. SHAPES_CMAKE_ARGS may hold further arguments for cmake.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# Answered before anything is built: run_help.txt is what `shapes-compare run --help` prints.
for argument in "$@"; do
  case "$argument" in
    --help | -h)
      cat "$root/compare/run_help.txt"
      exit 0
      ;;
    -*)
      if ! grep -qE -- "^ +(-h,)?${argument%%=*}( |$)" "$root/compare/run_help.txt"; then
        echo "compare/run.sh: there is no option '${argument%%=*}'. Known:" \
             "$(grep -oE -- '--[a-z-]+' "$root/compare/run_help.txt" | sort -u | xargs)" >&2
        exit 2
      fi
      ;;
  esac
done

source "$root/scripts/build.sh"
install_missing_packages "${build_packages[@]}"

# The preset is configured as everybody else has it, tests included; but only the tool is built. In the user's
# folder, so that paths among the arguments mean what they say.
build() { cmake --build "$root/build/release" --target shapes-compare --parallel "$(nproc)"; }
# shellcheck disable=SC2086 # several arguments in one variable
quietly cmake -S "$root" --preset release "${launcher[@]}" ${SHAPES_CMAKE_ARGS:-}
if [[ ! -x "$root/build/release/compare/shapes-compare" ]]; then
  echo "Building shapes-compare: about a minute on two cores, the first time" >&2
fi
# On a terminal Ninja writes one line over and over.
if [[ -t 2 ]]; then build >&2; else quietly build; fi
exec "$root/build/release/compare/shapes-compare" run "$@"
