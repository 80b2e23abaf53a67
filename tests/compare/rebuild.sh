#!/usr/bin/env bash
# What a change of a header in sim/ costs: how many object files of sim, ui and app (not of the
# tests) the build compiles again, by the dependencies that the compiler reported to Ninja. Builds
# what is missing first.
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
  quietly "$folder.configure.log" cmake -S "$tree" -B "$folder" -G Ninja \
    -DCMAKE_BUILD_TYPE=Release -DROTORBENCH_BUILD_TESTS=OFF -DCCACHE_PROGRAM=OFF
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
  echo "  $(objects_of "$folder" | wc -l) object files"
  for program in "${programs[@]}"; do
    bytes=$(stat -c %s "$folder/app/$program")
    echo "  $(basename "$program"): $bytes bytes, of which code and data" \
         "$(size "$folder/app/$program" | awk 'NR == 2 {print $1 + $2}')"
  done
  rm -rf "$folder"
}

# objects_of BUILD: the object files that the build makes today; Ninja's log also remembers removed
# ones.
objects_of() {
  sed -n 's/^ *"command": .* -o \([^ ]*\.o\) -c .*/\1/p' "$1/compile_commands.json" |
    grep -E '^(sim|ui|app)/' | sort -u
}

# counts_of BUILD: a line `number header` for each header of sim/ that an object file depends on.
# What a precompiled header includes is reported for it alone, but compiles again every object of
# its target.
counts_of() {
  awk -v top="$tree/" '
    function target_of(file) {
      sub(/\.dir\/.*/, ".dir", file)
      return file
    }
    function add(object, header) {
      if (!((object, header) in seen)) ++count[header]
      seen[object, header] = 1
    }
    NR == FNR {current[$0] = target_of($0); next}
    /^[^ ]/ {object = $1; sub(/:$/, "", object); next}
    NF {
      header = $1
      if (index(header, top) == 1) header = substr(header, length(top) + 1)
      sub(/^(\.\.\/)+/, "", header)
      if (header !~ /^sim\/.*\.h$/) next
      if (object in current) add(object, header)
      if (object ~ /\/cmake_pch\.hxx\.gch$/) {
        target = target_of(object)
        precompiled[target] = precompiled[target] " " header
      }
    }
    END {
      for (object in current) {
        n = split(precompiled[current[object]], headers, " ")
        for (i = 1; i <= n; ++i) add(object, headers[i])
      }
      for (header in count) print count[header], header
    }' <(objects_of "$1") <(ninja -C "$1" -t deps)
}

if [[ $clean == yes ]]; then
  clean_build
  exit 0
fi

if [[ $tree == "$root" ]]; then
  echo "building ${targets[*]} of the working tree" >&2
  quietly "$root/build/compare/configure.log" configure
  quietly "$root/build/compare/build.log" build_targets "${targets[@]}"
else
  build_tree "$tree" -DROTORBENCH_BUILD_UI=ON -- "${targets[@]}"
  build_folder=$tree/build/release
fi

echo "object files of sim, ui and app that a change of the header compiles again," \
     "of $(objects_of "$build_folder" | wc -l) in $what"
if ((${#headers[@]} == 0)); then
  counts_of "$build_folder" | sort -k1,1nr -k2 | awk 'NR <= 40 {printf "%6d  %s\n", $1, $2}'
else
  counts=$(counts_of "$build_folder")
  for header in "${headers[@]}"; do
    awk -v header="$header" '$2 == header {n = $1} END {printf "%6d  %s\n", n, header}' <<<"$counts"
  done
fi
