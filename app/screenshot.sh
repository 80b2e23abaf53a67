#!/usr/bin/env bash
# Makes the README's picture anew: the real window on a virtual display flies the flagship experiment.
# Usage: bash app/screenshot.sh
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/app/packages.sh"
source "$root/app/build.sh"

ensure_packages "${build_packages[@]}" "${run_packages[@]}"
configure -DROTORBENCH_BUILD_UI=ON
build_targets rotorbench-report
mkdir -p "$root/resources/screenshots"
env -u WAYLAND_DISPLAY QT_QPA_PLATFORM=xcb \
  xvfb-run --auto-servernum --server-args="-screen 0 1920x1200x24" \
  "$build_folder/app/rotorbench-report/rotorbench-report" \
  --window "$root/resources/screenshots/window.png"
