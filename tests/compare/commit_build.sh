# shellcheck shell=bash
# Builds an older commit beside the working tree, in a folder below build/ that is kept, so that a
# second call builds nothing. Sourced by the scripts of this folder after `root` is set to the top
# folder of the sources and app/build.sh is sourced. An error in a command substitution ends the
# script as one elsewhere does.
shopt -s inherit_errexit

# complain TEXT...: one sentence to stderr and exit code 2: the call was wrong.
complain() {
  echo "$(basename "$0"): $*" >&2
  exit 2
}

# repository ARGUMENT...: git in this repository, whoever owns it.
repository() {
  git -C "$root" -c safe.directory="$root" "$@"
}

# full_commit NAME: the commit's full hash.
full_commit() {
  repository rev-parse --verify --quiet "$1^{commit}" ||
    complain "'$1' is no commit of this repository; give a hash, a tag or a form like HEAD~3"
}

# exported_tree HASH: the folder with the sources of a commit, made if it is not there yet. As deep
# below its build folder as the working tree is below its own, so a compiler cache that knows
# relative paths serves both.
exported_tree() {
  local folder=$root/build/compare/${1:0:12}
  if [[ ! -e $folder/CMakeLists.txt ]]; then
    local part
    mkdir -p "$root/build/compare"
    part=$(mktemp -d "$root/build/compare/export.XXXXXX")
    repository archive "$1" | tar -x -C "$part"
    # An earlier call that was stopped may have left a folder without sources.
    rm -rf "$folder"
    mv "$part" "$folder"
  fi
  echo "$folder"
}

# quietly LOG COMMAND...: what CMake and the compiler say is shown only if they fail.
quietly() {
  local log=$1
  shift
  mkdir -p "$(dirname "$log")"
  if ! "$@" >"$log" 2>&1; then
    tail -n 40 "$log" >&2
    echo "$(basename "$0"): the build failed; all that was said is in $log" >&2
    exit 1
  fi
}

# build_tree FOLDER OPTION... -- TARGET...: builds targets of an exported tree in its build/release.
# The options stay, so that one folder serves every script: the window and the tests are left out
# until one asks for them.
build_tree() {
  local folder=$1
  local -a options=()
  # The functions of app/build.sh look at these two.
  local root=$1 build_folder=$1/build/release
  shift
  if [[ ! -e $build_folder/build.ninja ]]; then
    options=(-DROTORBENCH_BUILD_UI=OFF -DROTORBENCH_BUILD_TESTS=OFF)
  fi
  while [[ $1 != -- ]]; do
    options+=("$1")
    shift
  done
  shift
  echo "building $* of $(basename "$folder")" >&2
  ((${#options[@]} == 0)) || quietly "$folder/build/configure.log" configure "${options[@]}"
  quietly "$folder/build/build.log" build_targets "$@"
}
