#!/usr/bin/env bash
# Installs what is missing, builds Rotorbench and does its main job: with a display it opens the window;
# without one, or with --headless, it flies the flagship experiment and leaves the recording, the metrics, the
# charts and the 3D view in rotorbench-output/.
# Usage: bash app/run.sh [--headless] [arguments for the program]
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/app/packages.sh"
source "$root/app/build.sh"

headless=no
arguments=()
for argument in "$@"; do
  if [[ $argument == --headless ]]; then
    headless=yes
  else
    arguments+=("$argument")
  fi
done
[[ -n ${DISPLAY:-}${WAYLAND_DISPLAY:-} ]] || headless=yes

packages=("${build_packages[@]}" "${run_packages[@]}")
if [[ $headless == no && -z ${DISPLAY:-} ]]; then
  packages+=(qt6-wayland)
fi
ensure_packages "${packages[@]}"
# The tests need more packages; if they were configured once, they stay so.
if [[ $(cached ROTORBENCH_BUILD_TESTS) == ON ]]; then
  configure -DROTORBENCH_BUILD_TESTS=ON
else
  configure -DROTORBENCH_BUILD_TESTS=OFF
fi

if [[ $headless == no ]]; then
  build_targets rotorbench rotorbench-cli
  exec "$build_folder/app/rotorbench/rotorbench" "${arguments[@]}"
fi

build_targets rotorbench-report rotorbench-cli
report=("$build_folder/app/rotorbench-report/rotorbench-report" "${arguments[@]}")
# The 3D view needs an X server to draw with OpenGL; without one the program draws a plain view itself.
if command -v xvfb-run >/dev/null; then
  exec env -u WAYLAND_DISPLAY QT_QPA_PLATFORM=xcb \
    xvfb-run --auto-servernum --server-args="-screen 0 1280x1024x24" "${report[@]}"
fi
QT_QPA_PLATFORM=offscreen exec "${report[@]}"
