# Shared by the scripts of this folder: says what is done and what remains, and at the end what took how long, and the verdict.
# Source it after setup.sh.

phases=$(mktemp)
readonly phases
trap 'rm -f "$phases"' EXIT
reports=()
failed_phases=()

# phases <number of phases that are announced>
phases() {
  number_of_phases=$1
}

# phase <name of the phase that begins now>
phase() {
  local begun
  begun=$(wc -l <"$phases")
  say "[$((begun + 1))/${number_of_phases:-?}] $*"
  printf '%s\t%s\n' "$(date +%s.%N)" "$*" >>"$phases"
}

# phase_failed: the present phase has failed; the script continues.
phase_failed() {
  failed_phases+=(--failed-phase "$(tail -n 1 "$phases" | cut -f 2)")
}

# new_report <build folder>: sets report, the JUnit file for ctest to write. Reports of an earlier run of the script are removed.
new_report() {
  [[ " ${reports[*]} " = *" $1/report-"* ]] || rm -rf "$1/reports" "$1"/report-*.xml
  report=$1/report-$((${#reports[@]} + 1)).xml
  reports+=("$report")
}

# Run it at the end, whatever the outcome.
print_summary() {
  local outcome=$?
  /usr/bin/python3 "$root/scripts/print_summary.py" --outcome "$outcome" "${failed_phases[@]}" "$phases" "$build" "${reports[@]}" || true
  rm -f "$phases"
  return $outcome
}
