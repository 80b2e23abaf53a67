#!/usr/bin/env bash
# What a change of a header in sim/ costs: how many sources of sim, ui and app (not of the tests) are
# compiled again for it. A unity build compiles whole batches; these are the sources that ask for it.
# Usage: bash tests/compare/rebuild.sh [--commit COMMIT] [HEADER...]
#        bash tests/compare/rebuild.sh [--commit COMMIT] --clean
#   HEADER    only these, for example sim/control/pid.h; the forty most expensive ones if left out
#   --commit  of that commit, not of the working tree
#   --clean   instead the processor time of a build of sim, ui and app from nothing, without
#             compiler cache, and the size of the programs; takes many minutes
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/app/packages.sh"
source "$root/app/build.sh"
source "$root/tests/compare/commit_build.sh"

# Libraries and programs of sim, ui and app.
targets=(rotorbench_sim rotorbench_ui rotorbench rotorbench-cli rotorbench-report)
programs=(rotorbench-cli rotorbench/rotorbench)

old_name=
clean=no
headers=()
while (($# > 0)); do
  case $1 in
    --commit)
      [[ -n ${2:-} ]] || complain "--commit needs a commit"
      old_name=$2
      shift
      ;;
    --clean) clean=yes ;;
    -*) complain "unknown option $1; give --commit COMMIT, --clean or headers" ;;
    *) headers+=("$1") ;;
  esac
  shift
done
[[ $clean == no || ${#headers[@]} -eq 0 ]] || complain "--clean takes no headers"

tree=$root
what="the working tree"
if [[ -n $old_name ]]; then
  commit=$(full_commit "$old_name")
  tree=$(exported_tree "$commit")
  what=${commit:0:7}
fi
for header in "${headers[@]}"; do
  [[ -e $tree/$header ]] ||
    complain "there is no $header in $what; name it from the top, as sim/control/pid.h"
done
ensure_packages "${build_packages[@]}"

# clean_build: compiles everything once more in a folder of its own and prints what that took.
clean_build() {
  local folder=$root/build/compare/clean program bytes
  local -a took
  rm -rf "$folder"
  (cd "$tree" && quietly "$folder.configure.log" cmake --preset release -B "$folder" \
    -DROTORBENCH_BUILD_TESTS=OFF -DCCACHE_PROGRAM=OFF)
  local TIMEFORMAT='%U %S %R'
  # Seconds of every compiler and linker, which Ninja waits for.
  {
    time CCACHE_DISABLE=1 build_folder=$folder \
      quietly "$folder.build.log" build_targets "${targets[@]}" 2>&3
  } 3>&2 2>"$folder.time"
  read -r -a took <"$folder.time"
  echo "clean build of sim, ui and app of $what, without compiler cache:"
  awk -v user="${took[0]}" -v kernel="${took[1]}" -v clock="${took[2]}" 'BEGIN {
    printf "  processor time %.0f s (user %.0f, system %.0f), %.0f s by the clock\n",
           user + kernel, user, kernel, clock}'
  for program in "${programs[@]}"; do
    bytes=$(stat -c %s "$folder/app/$program")
    echo "  $(basename "$program"): $bytes bytes, of which code and data" \
         "$(size "$folder/app/$program" | awk 'NR == 2 {print $1 + $2}')"
  done
  rm -rf "$folder"
}

if [[ $clean == yes ]]; then
  clean_build
  exit 0
fi

counts=$(python3 "$root/tests/compare/include_counts.py" "$tree" "${headers[@]}")
echo "sources of sim, ui and app that a change of the header compiles again," \
     "of $(head -n 1 <<<"$counts") in $what"
tail -n +2 <<<"$counts" | awk 'NR <= 40 {printf "%6d  %s\n", $1, $2}'
