#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# Builds an example and says where it is, or runs it, on a fresh Debian 12 too. What is missing is installed, as root or
# with sudo.
# examples/run.sh playground [--open]   one HTML file with games on both engines; --open shows it in the browser
# examples/run.sh pinball [ARGUMENTS]   the games in the terminal, played by a script; --help says more
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
usage() { sed -n 's/^# \(examples\/run.sh\)/\1/p' "${BASH_SOURCE[0]}"; }
source "$root/scripts/build.sh"

# The sources of the Box2D that libbox2d-dev is made from: apt looks them up in lists of its own, so that those of the
# machine stay as they are.
fetch_box2d() { # FOLDER
  local folder=$1
  [[ -f "$folder/source/CMakeLists.txt" ]] && return
  mkdir -p "$folder/lists/partial" "$folder/cache/archives/partial" "$folder/source"
  echo 'deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] http://deb.debian.org/debian bookworm main' \
    >"$folder/sources.list"
  local apt=(apt-get -o "Dir::Etc::SourceList=$folder/sources.list" -o Dir::Etc::SourceParts=/dev/null
             -o "Dir::State::Lists=$folder/lists" -o "Dir::Cache=$folder/cache" -o APT::Sandbox::User=)
  quietly "${apt[@]}" update
  (cd "$folder" && quietly "${apt[@]}" source --download-only box2d=2.4.1-3)
  tar -xzf "$folder/box2d_2.4.1.orig.tar.gz" -C "$folder/source" --strip-components=1
  rm -r "$folder/lists" "$folder/cache"
}

build_playground() {
  local build=$root/build/playground
  install_missing_packages cmake ninja-build libeigen3-dev emscripten
  fetch_box2d "$root/build/box2d"
  # Debian's emscripten looks for its JavaScript packages where only Debian's node finds them by itself.
  export NODE_PATH=/usr/share/nodejs
  quietly emcmake cmake -S "$root/examples/playground" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release "${launcher[@]}" \
    -DBOX2D_SOURCE="$root/build/box2d/source" -DEigen3_DIR=/usr/share/eigen3/cmake
  [[ -f "$build/playground.html" ]] || echo "Building the playground: two minutes on two cores, the first time" >&2
  quietly cmake --build "$build" --parallel "$(nproc)"
  echo "$build/playground.html"
}

case "${1:-}" in
  playground)
    if [[ $# -gt 2 || ($# -eq 2 && $2 != --open) ]]; then usage >&2; exit 2; fi
    build_playground
    if [[ "${2:-}" == --open ]]; then
      command -v xdg-open >/dev/null || { echo "There is no xdg-open here: please open the file yourself" >&2; exit 1; }
      xdg-open "$root/build/playground/playground.html"
    fi
    ;;
  pinball)
    shift
    install_missing_packages "${build_packages[@]}"
    quietly cmake -S "$root" --preset release "${launcher[@]}"
    quietly cmake --build "$root/build/release" --target shapes-pinball --parallel "$(nproc)"
    exec "$root/build/release/examples/shapes-pinball" "$@"
    ;;
  --help | -h) usage ;;
  *) usage >&2; exit 2 ;;
esac
