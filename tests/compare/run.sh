#!/usr/bin/env bash
# Runs every shipped experiment with the command line of an older commit and with that of the
# working tree, and compares recordings and metrics bit for bit. Channels and metrics that only the
# working tree has are listed and pass. Exit code 0 if nothing differs, 1 if something does, 2 if
# the call was wrong.
# Usage: bash tests/compare/run.sh OLD-COMMIT [--tolerance R] [EXPERIMENT...]
#   --tolerance R  differences up to R, as a share of the channel's range, pass and are printed
#   EXPERIMENT     only these, for example f450-hover-and-steps
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
source "$root/app/packages.sh"
source "$root/app/build.sh"
source "$root/tests/compare/commit_build.sh"

usage="give an older commit, then perhaps --tolerance R and names of experiments"
old_name=
judging=()
wanted=()
while (($# > 0)); do
  case $1 in
    --tolerance)
      [[ ${2:-} =~ ^[0-9]*\.?[0-9]+([eE][-+]?[0-9]+)?$ ]] ||
        complain "--tolerance needs a number, for example 1e-9"
      judging=(--tolerance "$2")
      shift
      ;;
    -*) complain "unknown option $1; $usage" ;;
    *) if [[ -z $old_name ]]; then old_name=$1; else wanted+=("$1"); fi ;;
  esac
  shift
done
[[ -n $old_name ]] || complain "$usage"
commit=$(full_commit "$old_name")

experiments=$root/resources/experiments
all=no
if ((${#wanted[@]} == 0)); then
  all=yes
  for file in "$experiments"/*.json; do wanted+=("$(basename "$file" .json)"); done
fi
for name in "${wanted[@]}"; do
  [[ -e $experiments/$name.json ]] || complain "there is no experiment $experiments/$name.json"
done

ensure_packages "${build_packages[@]}" "${compare_packages[@]}"
old_tree=$(exported_tree "$commit")
build_tree "$old_tree" -- rotorbench-cli
echo "building rotorbench-cli of the working tree" >&2
quietly "$root/build/compare/configure.log" configure
quietly "$root/build/compare/build.log" build_targets rotorbench-cli
old_cli=$old_tree/build/release/app/rotorbench-cli
new_cli=$build_folder/app/rotorbench-cli
results=$root/build/compare/results-${commit:0:12}
rm -rf "$results"
mkdir -p "$results"

# fly PROGRAM FILE FOLDER: runs an experiment; prints the exit code, leaves what was said in
# FOLDER.log.
fly() {
  local code=0
  "$1" run "$2" --format json --output "$3" >"$3.log" 2>&1 || code=$?
  echo "$code"
}

# compare NAME: flies one experiment twice and prints what differs. Fails if something does.
compare() {
  local name=$1 file=$experiments/$1.json old_code new_code text code=0
  local old=$results/$1.old new=$results/$1.new
  echo "$name"
  fly "$new_cli" "$file" "$new" >"$new.code" &
  old_code=$(fly "$old_cli" "$file" "$old")
  wait $!
  new_code=$(<"$new.code")
  if ((old_code == 2)) && [[ -e $old_tree/resources/experiments/$name.json ]]; then
    echo "  the old program refuses this file and flies the old tree's file of the same name:"
    grep -v '^wrote ' "$old.log" | head -n 1 | sed 's/^/    /'
    old_code=$(fly "$old_cli" "$old_tree/resources/experiments/$name.json" "$old")
  fi
  if ((new_code != old_code && old_code != 2)) || ((new_code > 1)); then
    echo "    FAILED exit code $old_code became $new_code; see $new.log"
    return 1
  fi
  if ((old_code == 2)); then
    echo "  the old program refuses this file and has no file of this name: a new experiment"
    judged=$((judged + 1))
    return 0
  fi
  text=$(python3 "$root/tests/compare/compare_runs.py" "$old" "$new" "${judging[@]}") || code=$?
  ((code <= 1)) || return 1
  sed '$d' <<<"$text"
  local -a counts
  read -r -a counts <<<"$(tail -n 1 <<<"$text")"
  add_counts "${counts[@]}"
  judged=$((judged + 1))
  return "$code"
}

# Channels and metrics of all experiments, and how many experiments were judged to the end.
sum_equal=0 sum_new=0 sum_tolerated=0 sum_failed=0 judged=0

# add_counts EQUAL NEW TOLERATED FAILED
add_counts() {
  sum_equal=$((sum_equal + $1)) sum_new=$((sum_new + $2))
  sum_tolerated=$((sum_tolerated + $3)) sum_failed=$((sum_failed + $4))
}

failures=()
printf '%-46s %6s %6s %9s %7s\n' "channels and metrics, old is ${commit:0:7}" \
  equal new tolerated failed
for name in "${wanted[@]}"; do
  compare "$name" || failures+=("$name")
done
for file in "$old_tree"/resources/experiments/*.json; do
  name=$(basename "$file" .json)
  if [[ $all == yes && ! -e $experiments/$name.json ]]; then
    echo "$name"
    echo "    FAILED the working tree has no such experiment"
    failures+=("$name")
  fi
done

sums="$sum_equal equal bit for bit, $sum_new new, $sum_tolerated within the tolerance"
sums="$judged of ${#wanted[@]} experiments judged: $sums, $sum_failed failed"
# Nothing passes unseen: what could not be judged is no success either.
if ((${#failures[@]} > 0 || judged != ${#wanted[@]})); then
  echo "DIFFERENT: $sums; look at ${failures[*]}"
  exit 1
fi
echo "SAME: $sums"
