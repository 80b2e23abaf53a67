#!/usr/bin/env bash
# How fast the working tree is beside an older commit: processor time of the flagship flight and of
# one derivative (tests/bench/flight_bench) in alternating pairs, and the instructions of one
# flagship flight, counted by callgrind. The figures are printed, not judged.
# Usage: bash tests/compare/speed.sh OLD-COMMIT [--pairs N] [--window]
#   --pairs N  how many pairs; 21 if left out
#   --window   the chart panes and the first paint of the window as well, in a quarter as many pairs
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/app/packages.sh"
source "$root/app/build.sh"
source "$root/tests/compare/commit_build.sh"

usage="give an older commit, then perhaps --pairs N and --window"
old_name=
pairs=21
window=no
while (($# > 0)); do
  case $1 in
    --pairs)
      [[ ${2:-} =~ ^[1-9][0-9]*$ ]] || complain "--pairs needs a whole number from 1"
      pairs=$2
      shift
      ;;
    --window) window=yes ;;
    -*) complain "unknown option $1; $usage" ;;
    *) [[ -z $old_name ]] || complain "one commit is enough; $usage"
       old_name=$1 ;;
  esac
  shift
done
[[ -n $old_name ]] || complain "$usage"
commit=$(full_commit "$old_name")

packages=("${build_packages[@]}" "${compare_packages[@]}" "${bench_packages[@]}")
options=(-DROTORBENCH_BUILD_TESTS=ON -DROTORBENCH_BUILD_BENCHMARKS=ON)
targets=(rotorbench-cli flight_bench)
if [[ $window == yes ]]; then
  packages+=("${run_packages[@]}")
  options+=(-DROTORBENCH_BUILD_UI=ON)
  targets+=(chart_bench first_paint)
fi
ensure_packages "${packages[@]}"
old_tree=$(exported_tree "$commit")
# Earlier commits compiled the benchmarks as little optimised as the tests; both sides must be
# compiled alike.
if grep -q '"-O3" "-O1"' "$old_tree/tests/CMakeLists.txt"; then
  sed -i '/"-O3" "-O1"/d' "$old_tree/tests/CMakeLists.txt"
fi
build_tree "$old_tree" "${options[@]}" -- "${targets[@]}"
# The folder of the preset for benchmarks: the one for tests stays as it is.
echo "building ${targets[*]} of the working tree" >&2
(cd "$root" && quietly build/compare/configure.log cmake --preset bench)
build_folder=$root/build/bench quietly "$root/build/compare/build.log" build_targets "${targets[@]}"
old_build=$old_tree/build/release
new_build=$root/build/bench

results=$root/build/compare/speed-${commit:0:12}
rm -rf "$results"

# Each of these prints lines `name unit value` for one build.
bench_times() {
  local program=$1 filter=$2
  "$program" --benchmark_filter="$filter" --benchmark_format=csv --benchmark_min_time=0.2 \
    2>/dev/null |
    awk -F, '/^"/ {gsub(/"/, ""); sub(/\/(min_time|iterations):.*/, "", $1); print $1, $5, $4}'
}
flight_times() {
  bench_times "$1/tests/bench/flight_bench" '^(flyFlagship|derivative)(/|$)'
}
window_times() {
  bench_times "$1/tests/bench/chart_bench" .
  QT_QPA_PLATFORM=xcb xvfb-run --auto-servernum "$1/tests/bench/first_paint" |
    awk '/^first paint/ {print "first_paint", $5, $4}'
}
flight_instructions() {
  local flagship counts=$results/callgrind.out
  flagship=$(flagship_of "$1")
  valgrind --tool=callgrind --callgrind-out-file="$counts" "$1/app/rotorbench-cli" run "$flagship" \
    >"$counts.log" 2>&1
  awk '/^(summary|totals):/ {print "flagship_flight", "instructions", $2; exit}' "$counts"
}

# flagship_of BUILD: the flagship of the tree that a build folder belongs to.
flagship_of() {
  echo "$(dirname "$(dirname "$1")")/resources/experiments/f450-hover-and-steps.json"
}

# measure_pairs NAME COUNT COMMAND: measures both builds in turn, now this one first, now the other.
measure_pairs() {
  local folder=$results/$1 count=$2 command=$3 i
  mkdir -p "$folder"
  for ((i = 1; i <= count; ++i)); do
    echo "$1: pair $i of $count" >&2
    if ((i % 2)); then
      "$command" "$old_build" >"$folder/old.$i"
      "$command" "$new_build" >"$folder/new.$i"
    else
      "$command" "$new_build" >"$folder/new.$i"
      "$command" "$old_build" >"$folder/old.$i"
    fi
  done
}

echo "old is ${commit:0:7}; processor times, medians of the pairs (first_paint: time by the clock)"
cmp -s "$(flagship_of "$old_build")" "$(flagship_of "$new_build")" ||
  echo "Attention: the flagship's file has changed since; each build flies its own."
measure_pairs flight "$pairs" flight_times
python3 "$root/tests/compare/ratio_table.py" "$results/flight"
measure_pairs instructions 1 flight_instructions
python3 "$root/tests/compare/ratio_table.py" "$results/instructions" | tail -n +2
if [[ $window == yes ]]; then
  measure_pairs window $(((pairs + 3) / 4)) window_times
  python3 "$root/tests/compare/ratio_table.py" "$results/window" | tail -n +2
fi
