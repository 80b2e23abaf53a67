# shellcheck shell=bash
# The Debian 12 packages Rotorbench needs, in one place, and how to install those that are missing.
# Sourced by app/run.sh, tests/run.sh, tests/compare and .ci/run.

# shellcheck disable=SC2034  # each script picks the sets it needs
build_packages=(
  cmake ninja-build g++ mold
  qt6-base-dev qt6-charts-dev qt6-3d-dev qt6-svg-dev libqt6opengl6-dev libgl-dev
  libboost-dev libceres-dev libcli11-dev libeigen3-dev nlohmann-json3-dev zlib1g-dev
)
# shellcheck disable=SC2034
run_packages=(
  breeze-icon-theme fonts-dejavu-core libgl1-mesa-dri libqt6svg6 xauth xvfb
)
# shellcheck disable=SC2034
test_packages=(
  desktop-file-utils octave octave-control poppler-utils python3-jsonschema
)
# shellcheck disable=SC2034
check_packages=(
  clang-format clang-tidy shellcheck
)
# What tests/compare uses beside them.
# shellcheck disable=SC2034
compare_packages=(
  python3
)
# shellcheck disable=SC2034
bench_packages=(
  libbenchmark-dev valgrind
)
# shellcheck disable=SC2034
package_packages=(
  dpkg-dev file
)

# missing_packages NAME...: prints those that are not installed, one a line.
missing_packages() {
  local name status
  for name in "$@"; do
    status=$(dpkg-query -W -f='${db:Status-Status}' "$name" 2>/dev/null) || status=absent
    [[ $status == installed ]] || echo "$name"
  done
}

# ensure_packages NAME...: installs what is missing. Does nothing, and needs no rights, if nothing is.
ensure_packages() {
  local -a missing as_root=()
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "rotorbench: this is not a Debian system; make sure that what these Debian 12 packages hold is there: $*" >&2
    return 0
  fi
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]} == 0)) && return 0
  echo "rotorbench: installing Debian packages: ${missing[*]}"
  if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
      echo "rotorbench: installing packages needs root or sudo, and this user has neither." \
           "Ask an administrator to run: apt-get install --no-install-recommends ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  local -a install=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive
                    apt-get install -y -qq -o Dpkg::Use-Pty=0 --no-install-recommends "${missing[@]}")
  # Package lists may be absent or too old for the archive: fetch them only then.
  if apt-get install --simulate -qq --no-install-recommends "${missing[@]}" >/dev/null 2>&1 &&
     "${install[@]}" >/dev/null; then
    return 0
  fi
  "${as_root[@]}" apt-get update -qq
  if ! "${install[@]}" >/dev/null; then
    echo "rotorbench: apt-get could not install ${missing[*]}; its message is above." >&2
    return 1
  fi
}
