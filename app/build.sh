# shellcheck shell=bash
# Configures and builds the release preset without repeating work. Sourced by app/run.sh and
# tests/run.sh after `root` is set to the top folder of the sources.

# shellcheck disable=SC2154
build_folder=$root/build/release

# build_jobs: as many compilers as there are cores, but at least 1.5 GB of memory for each.
build_jobs() {
  local cores memory
  cores=$(nproc)
  memory=$(awk '/MemAvailable/ {print int($2 / 1572864)}' /proc/meminfo)
  ((memory < 1)) && memory=1
  echo $((cores < memory ? cores : memory))
}

# cached NAME: a value of the configured build, empty if there is none.
cached() {
  sed -n "s|^$1:[A-Z]*=||p" "$build_folder/CMakeCache.txt" 2>/dev/null || true
}

# configure [-DNAME=VALUE...]: runs CMake if this folder was never configured, was moved, or has
# other options; Ninja itself notices edited CMake files.
configure() {
  local option name current=yes
  local -a fresh=()
  [[ -e $build_folder/build.ninja ]] || current=no
  for option in "$@"; do
    name=${option#-D}
    [[ $(cached "${name%%=*}") == "${option#*=}" ]] || current=no
  done
  if [[ $(cached CMAKE_HOME_DIRECTORY) != "$root" ]]; then
    current=no
    fresh=(--fresh)
  fi
  [[ $current == yes ]] && return 0
  (cd "$root" && cmake "${fresh[@]}" --preset release "$@")
}

# build_targets NAME...: compiles what changed.
build_targets() {
  cmake --build "$build_folder" --parallel "$(build_jobs)" --target "$@"
}
