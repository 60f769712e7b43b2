#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds shapes-compare in release mode and runs it: compare/run.sh [ARGUMENTS OF shapes-compare run]
# Works on a fresh Debian 12: what is missing is installed, as root or with sudo. Only what shapes-compare prints goes
# to the standard output. SHAPES_CMAKE_ARGS may hold further arguments for cmake.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/scripts/debian_packages.sh"
install_missing_packages "${build_packages[@]}"

launcher=()
if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi

# The preset is configured as everybody else has it, tests included; but only the tool is built. In the user's
# folder, so that paths among the arguments mean what they say.
{
  # shellcheck disable=SC2086 # several arguments in one variable
  cmake -S "$root" --preset release "${launcher[@]}" ${SHAPES_CMAKE_ARGS:-}
  cmake --build "$root/build/release" --target shapes-compare --parallel "$(nproc)"
} >&2
exec "$root/build/release/compare/shapes-compare" run "$@"
