# SPDX-License-Identifier: MIT
# Sourced by the scripts that build: the Debian packages that they need, and how those that are missing get there.

# The library, its tests and the tool. GoogleTest and RapidCheck are for the tests; CLI11, nlohmann-json, valijson and fmt are for
# shapes-compare, Chart.js for its report and Boost for its exact reference.
build_packages=(cmake ninja-build g++ libeigen3-dev libbox2d-dev libgtest-dev libcli11-dev nlohmann-json3-dev
                libvalijson-dev libfmt-dev libboost-dev librapidcheck-dev libjs-chart.js)
# The tests that need more than a compiler: report.html is tested in a browser.
test_packages=(chromium)
# The rest of what .ci/run does. With ccache, configurations that differ in a few files share the others.
ci_packages=(git ccache clang clang-tidy clang-format libclang-rt-14-dev)

# Installs those of the packages named that are missing. Where all are there, apt is not called.
install_missing_packages() {
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
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get update >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}" >&2
}
