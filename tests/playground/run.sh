#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds the playground and the games for the terminal, and holds the one against the other in a browser.
# tests/playground/run.sh [--control]   with faults planted in the page, which have to be found
# Not part of .ci/run: the compiler for WebAssembly alone takes longer to install and to run than all that it would find.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/scripts/build.sh"
install_missing_packages chromium-headless-shell
"$root/examples/run.sh" playground
"$root/examples/run.sh" pinball --frames 1 >/dev/null
"$root/tests/playground/run.py" "$root/build/playground/playground.html" "$@" "$root/build/release/examples/shapes-pinball"
