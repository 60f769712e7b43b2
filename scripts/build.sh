# SPDX-License-Identifier: MIT
# Sourced by the scripts that build: the Debian packages that they need, how those that are missing get there, and how
# a command is run whose output matters only if it fails.

# The library, its tests and the tool: docs/packages.md says what each is for and what it weighs.
build_packages=(cmake ninja-build g++ libeigen3-dev libbox2d-dev libgtest-dev librapidcheck-dev libcli11-dev
                nlohmann-json3-dev libfmt-dev libboost-dev libjs-chart.js)
# The tests that need more than a compiler: report.html is tested in a browser, JSON schemas by a validator.
test_packages=(chromium-headless-shell python3-jsonschema)
# The rest of what .ci/run does. With ccache, configurations that differ in a few files share the others.
ci_packages=(git ccache clang clang-tidy clang-format libclang-rt-14-dev libc++-dev libc++abi-dev help2man jq
             libtbb-dev)

# Arguments for cmake: a compiler cache where there is one. Precompiled headers need to be told to it.
export CCACHE_SLOPPINESS=pch_defines,time_macros
# Found by the text of what it includes, never by what the preprocessor makes of it: that has no comments, and a
# precompiled header of a file whose comment has changed is not taken for that file, which is then included twice.
export CCACHE_DEPEND=1
launcher=()
if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi

# Runs a command and shows its output only if it fails.
quietly() { # COMMAND...
  local log status=0
  log=$(mktemp)
  "$@" >"$log" 2>&1 || status=$?
  if ((status != 0)); then cat "$log" >&2; fi
  rm -f "$log"
  return "$status"
}

# Installs those of the packages named that are missing. Where all are there, apt is not called.
install_missing_packages() { # PACKAGE...
  local missing=() package
  for package in "$@"; do
    [[ "$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null)" == installed ]] ||
      missing+=("$package")
  done
  ((${#missing[@]})) || return 0
  echo "Installing: ${missing[*]}" >&2
  local as_root=()
  if (($(id -u) != 0)); then
    command -v sudo >/dev/null || { echo "Neither root nor sudo: please install ${missing[*]}" >&2; return 1; }
    as_root=(sudo)
  fi
  quietly "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update &&
    quietly "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
}
