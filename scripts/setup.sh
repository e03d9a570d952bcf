# Shared by the scripts of this folder: prints the current step, installs missing packages, builds. Source it.

set -euo pipefail
# Every script explains itself by the comment at its beginning.
case ${1:-} in
  -h | --help)
    sed -n '2,/^[^#]/s/^# \{0,1\}//p' "$0"
    exit 0
    ;;
esac
readonly root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
readonly build=${COBOT_BUILD_DIR:-$root/build}
# It chooses tests; the shell may have it from an earlier command.
unset COBOT_TEST_PATTERN

say() { printf '\n== %s\n' "$*"; }

# install_missing [list of packages, from the root of the repository]; without one: those of every system, and of this one.
install_missing() {
  local lists=("$@") package missing=()
  if [ $# -eq 0 ]; then
    local codename
    codename=$(. /etc/os-release && echo "${VERSION_CODENAME:-}")
    lists=(scripts/packages.txt)
    [ ! -f "$root/scripts/packages-$codename.txt" ] || lists+=("scripts/packages-$codename.txt")
  fi
  say "Looking for the packages of ${lists[*]}"
  while read -r package; do
    [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] ||
      missing+=("$package")
  done < <(sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "${lists[@]/#/$root/}")
  if [ ${#missing[@]} -eq 0 ]; then
    echo "all installed"
    return
  fi
  echo "installing: ${missing[*]}"
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "Run this as root, or install sudo: packages are missing." >&2; exit 1; }
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" \
    >/dev/null
}

# Into the build folder, where CTest looks for them. They are the only packages that are not from Debian. Without them the
# tests that need them are skipped, with a message.
install_python_packages() {
  local folder=$build/python-packages list=$root/scripts/python-packages.txt
  say "Looking for the packages of scripts/python-packages.txt"
  if cmp -s "$list" "$folder/installed.txt"; then
    echo "all installed"
    return
  fi
  rm -rf "$folder"
  if /usr/bin/python3 -m pip install --quiet --disable-pip-version-check --root-user-action=ignore --no-deps \
    --only-binary :all: --require-hashes --target "$folder" --requirement "$list"; then
    cp "$list" "$folder/installed.txt"
  else
    echo "They cannot be fetched: their tests will be skipped." >&2
  fi
}

# configure <build folder> <cmake option>...
# For work on the project: assertions are on; debug information and optimization are reduced to save compile time (a third
# with full debug information, as much again with -O2). Every build of the scripts has the same options, so that they share
# the compiler cache.
configure() {
  local folder=$1
  shift
  mkdir -p "$folder"
  # Paths relative to the repository, so that all clones on a machine share the compiler cache.
  export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1
  # ccache needs this for precompiled headers.
  export CCACHE_SLOPPINESS=pch_defines,time_macros
  # Generate our messages only for the languages that are used here, so not for Lisp.
  export ROS_LANG_DISABLE=genlisp
  # The ROS tools need the system's Python, even if another one is first on the PATH.
  cmake -S "$root" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG="-O1 -g1" \
    -DBUILD_SHARED_LIBS=ON -DCMAKE_LINK_DEPENDS_NO_SHARED=ON -DCOBOT_WARNINGS_AS_ERRORS=ON -DCOBOT_PRECOMPILE=ON -DCOBOT_UNITY=ON \
    -DPYTHON_EXECUTABLE=/usr/bin/python3 -DPython3_EXECUTABLE=/usr/bin/python3 -DCMAKE_CXX_COMPILER_LAUNCHER=ccache \
    -DCMAKE_EXPORT_COMPILE_COMMANDS=ON -DCOBOT_PYTHON_PACKAGES="$build/python-packages" "$@" >"$folder/configure.log" 2>&1 ||
    { cat "$folder/configure.log" >&2; exit 1; }
}

# build_with <build folder> <cmake option>...
build_with() {
  configure "$@"
  ninja -C "$1"
}

# use_build [build folder]: its messages, programs and packages, in this shell.
use_build() {
  local folder=${1:-$build}
  # For the same reason: our own Python programs use the first python3 on the PATH.
  export PATH="/usr/bin:$PATH"
  # ROS's own set-up script reads variables that might not be set.
  set +u
  # shellcheck disable=SC1091
  source "$folder/devel/setup.bash"
  set -u
}

free_port() {
  /usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])'
}

# run_rostest <name> [argument:=value...]: runs test/rostest/<name>.test and prints its output. With --text, rostest itself always
# ends with 0. Therefore the verdict of the test program counts, and a missing verdict is a failure.
run_rostest() {
  local name=$1 log
  shift
  log=$(mktemp)
  ROS_LOG_DIR=$build/$name/log ROS_HOME=$build/$name/home ROS_HOSTNAME=localhost \
    rostest --text "$root/test/rostest/$name.test" "$@" 2>&1 | tee "$log" || true
  local verdict=1
  grep -q ' \* RESULT: SUCCESS' "$log" && ! grep -q ' \* RESULT: FAIL' "$log" && verdict=0
  rm -f "$log"
  return $verdict
}
