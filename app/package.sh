#!/usr/bin/env bash
# Makes the Debian package in build/release. Usage: bash app/package.sh
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/app/packages.sh"
source "$root/app/build.sh"

ensure_packages "${build_packages[@]}" "${package_packages[@]}"
configure -DROTORBENCH_BUILD_UI=ON
build_targets rotorbench rotorbench-cli
cd "$build_folder"
cpack -G DEB
