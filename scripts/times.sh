# Shared by the scripts beside it: says what took how long. To be sourced behind setup.sh.

phases=$(mktemp)
readonly phases
tested_folders=()

# phase <what begins now>
phase() {
  say "$*"
  printf '%s\t%s\n' "$(date +%s.%N)" "$*" >>"$phases"
}

# times_of_tests <build folder>: its times.xml is new when ctest has run.
times_of_tests() {
  rm -f "$1/times.xml"
  tested_folders+=("$1")
}

# To be run at the end, whatever the outcome.
print_times() {
  local outcome=$?
  /usr/bin/python3 "$root/scripts/print_times.py" "$phases" "$build" "${tested_folders[@]}" || true
  rm -f "$phases"
  return $outcome
}
