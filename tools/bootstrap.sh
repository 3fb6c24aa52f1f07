# POTDEM: potential-based discrete elements for LAMMPS
# Distributed under the GNU General Public License, version 2

# Sourced by examples/run, unittest/run, bench/run, tools/report, tools/manual and tools/python: says where Python finds this
# project's package, installs what is missing and builds.
# The Debian packages are named here and nowhere else.
# shellcheck shell=bash

POTDEM_ROOT=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
export POTDEM_BUILD=$POTDEM_ROOT/build
export POTDEM_PYTHON=/usr/bin/python3
# the Python package that examples, tests, benchmarks and tools share: tools/potdem
export PYTHONPATH=$POTDEM_ROOT/tools${PYTHONPATH:+:$PYTHONPATH}
POTDEM_PACKAGES=(g++ cmake ninja-build openmpi-bin libopenmpi-dev libgtest-dev libgmock-dev libyaml-dev
                 libpng-dev libjpeg-dev voro++-dev ffmpeg curl ca-certificates python3 python3-numpy
                 python3-scipy python3-matplotlib python3-yaml python3-pytest python3-pytest-xdist)
# for tools/manual alone, the second for its --pdf
POTDEM_MANUAL_PACKAGES=(python3-sphinx python3-myst-parser furo python3-sphinx-copybutton libjs-mathjax)
POTDEM_PDF_PACKAGES=(chromium)
# for unittest/run --full alone
POTDEM_TRUST_PACKAGES=(clang clang-tidy libomp-dev python3-clang gcovr valgrind git)

die() {
  printf '%s\n' "$*" >&2
  exit 1
}

missing_packages() {
  local package
  for package in "${POTDEM_PACKAGES[@]}"; do
    if [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" != installed ]; then
      printf '%s\n' "$package"
    fi
  done
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  else
    sudo "$@"
  fi
}

install_packages() {
  local sudo=''
  [ "$(id -u)" -eq 0 ] || sudo='sudo '
  if [ "$1" = no ]; then
    printf 'Packages are missing. Run this line, then start again:\n  %s\n' \
      "${sudo}apt-get update && ${sudo}apt-get install --no-install-recommends -y ${*:2}" >&2
    exit 1
  fi
  printf 'Installing Debian packages:\n'
  printf '  %s\n' "${@:2}"
  as_root apt-get update -q
  as_root env DEBIAN_FRONTEND=noninteractive apt-get install --no-install-recommends -y -q "${@:2}"
}

require_packages() {
  local missing
  if ! command -v dpkg-query >/dev/null; then
    printf 'Not a Debian system: taking it that the equivalents of these are installed:\n  %s\n' \
      "${POTDEM_PACKAGES[*]}"
    return
  fi
  mapfile -t missing < <(missing_packages)
  if [ "${#missing[@]}" -gt 0 ]; then
    install_packages "$1" "${missing[@]}"
  fi
}

# the last thing that a log of CMake and Ninja says, in one line
build_state() {
  local line
  line=$(grep -aoE '^\[[0-9]+/[0-9]+\]|POTDEM: .*' "$1" | tail -n 1 || true)
  if [[ $line =~ ^\[([0-9]+)/([0-9]+)\]$ ]]; then
    printf 'compiling LAMMPS with POTDEM: %3d %% %s' \
      $((100 * BASH_REMATCH[1] / BASH_REMATCH[2])) "$line"
  else
    printf '%s' "${line:-configuring}"
  fi
}

# Shows how the build that writes the log $1 gets on, until it is killed or the process $2 has gone. Nothing is
# shown in the first seconds: a build with nothing to do is quiet. A sleep that outlives its watcher must
# not hold the script's output open.
watch_build() {
  local log=$1 script=$2 start=$SECONDS line
  sleep 4 &>/dev/null
  while kill -0 "$script" 2>/dev/null; do
    line=$(printf '%s  %d:%02d' "$(build_state "$log")" $(((SECONDS - start) / 60)) $(((SECONDS - start) % 60)))
    if [ -t 1 ]; then
      printf '\r\033[K%s' "$line"
      sleep 1 &>/dev/null
    else
      printf '%s\n' "$line"
      sleep 20 &>/dev/null
    fi
  done
}

configure_and_build() {
  cd "$POTDEM_ROOT" || return
  if [ ! -f "$POTDEM_BUILD/build.ninja" ]; then
    cmake --preset default || return
  fi
  cmake --build --preset default
}

# The build runs in the foreground and its watcher behind it, so that an interrupt ends the build.
build_potdem() {
  local log=$POTDEM_BUILD/build.log watcher built=yes
  mkdir -p "$POTDEM_BUILD"
  # a second command that is started meanwhile waits and finds the build done
  exec 9>"$POTDEM_BUILD/.lock"
  flock 9
  : >"$log"
  watch_build "$log" $$ 9>&- &
  watcher=$!
  (configure_and_build) >"$log" 2>&1 || built=no
  kill "$watcher"
  wait "$watcher" 2>/dev/null || true
  exec 9>&-
  if [ -t 1 ]; then printf '\r\033[K'; fi
  if [ "$built" = no ]; then
    # the first error is the one that matters, and hundreds of lines may follow it
    grep -aE -m 1 -A 24 'CMake Error|FAILED:|error:' "$log" >&2 || tail -n 25 "$log" >&2
    die "The build failed. Its whole output is in $log"
  fi
}

# bootstrap yes|no: whether missing packages may be installed
bootstrap() {
  require_packages "$1"
  build_potdem
}
