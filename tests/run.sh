#!/usr/bin/env bash
# Installs what is missing, builds the Release configuration and runs every test.
# Usage: bash tests/run.sh [arguments for ctest], for example -R recording or -L ui
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
source "$root/app/packages.sh"
source "$root/app/build.sh"

ensure_packages "${build_packages[@]}" "${run_packages[@]}" "${test_packages[@]}"
configure -DROTORBENCH_BUILD_TESTS=ON
build_targets all
# Two at a time at most: some tests watch the clock.
ctest --test-dir "$build_folder" --output-on-failure --no-tests=error --parallel 2 "$@"
