#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# completion_test.sh COMPLETION PROGRAM: what bash offers for some beginnings of commands.
set -euo pipefail
# shellcheck source=/dev/null
source "$1"
program=$2
failed=0

expect() { # EXPECTED WORDS...: the last word is the one to be completed
  local expected=$1
  shift
  COMP_WORDS=("$program" "$@")
  COMP_CWORD=$#
  COMPREPLY=()
  _shapes_compare
  if [[ "${COMPREPLY[*]}" != "$expected" ]]; then
    echo "FAILED: '$*' is completed to '${COMPREPLY[*]}', expected '$expected'"
    failed=1
  fi
}

expect "run" r
expect "scene" sc
expect "--contacts" run --con
expect "--folder --full --fail-above" run --f # in the order of the help
expect "--full --fail-above" scene mine.json --f
expect "paddle pile_of_50 pinball point_off_centre" run --scenes p
expect "bowl,pinball" run --scenes bowl,pin
expect "box2d box2d-tuned" run --engines b
expect "" run --zzz
exit "$failed"
