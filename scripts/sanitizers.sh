# Shared by the scripts of this folder: builds with sanitizers, each in its own folder. Source it after setup.sh.

# The rooms that read the data of a peer, those that process them, and the rooms that these use. Their tests run once with
# every change, with sanitizers, in their own build; the complete build leaves them out then. Quick tests (corpora) run in
# both.
readonly core_tests=(allocation automata blocks capabilities cell_agent cell_artifact cell_model cell_monitor
  cell_program cell_supervision command common files kinematics link peers protocol rapid_checks rapid_source
  rapid_types robot script simulator tables tm_script
  dynamics follow_joint_trajectory hostile io_failures paths project_values runtime runtime_parts synchronisation
  transport)
core_tests_pattern=$(IFS='|' && echo "^((${core_tests[*]})[.]|fuzz[.]|locale[.](${core_tests[*]})_)")
readonly core_tests_pattern
# Both nodes as processes: goals and cancels of four clients at once, connections opened and lost, ends and kills.
readonly node_tests_pattern='^rostest\.(load|ends)$'
readonly threaded_targets=(test_transport test_runtime test_runtime_parts test_ros command_node simulated_controller_node
  cobot_command_generate_messages_py)
readonly threaded_tests_pattern="^(transport|runtime|runtime_parts|ros)\\.|$node_tests_pattern"

# build_sanitized address|thread [target...]
build_sanitized() {
  local kind=$1 flags=$1
  shift
  [ "$kind" = address ] && flags=address,undefined
  configure "$build/$kind" -DCOBOT_SANITIZE="$flags"
  ninja -C "$build/$kind" "$@"
  use_build "$build/$kind"
  watch
}

# Checks that the address sanitizer does not include. The other checks of undefined behaviour, of each dereferenced pointer,
# cost a third of the compile time; their additional findings are left to --sanitize address.
readonly core_sanitizers=address,bool,bounds,builtin,enum,integer-divide-by-zero,return,shift,signed-integer-overflow,unreachable

# This build finds faults that ROS could hide, because it builds the rooms of the core without ROS. It also finds faults that one
# compiler accepts: clang builds this, g++ everything except these tests. Faults that precompiled headers hide are found by
# clang-tidy. The rooms are instrumented, their tests are not: optimizing these would gain nothing and cost half of the compile time.
build_core() {
  configure "$build/watched" -DCOBOT_CORE_ONLY=ON -DCOBOT_WATCH="$core_sanitizers" -DCMAKE_CXX_COMPILER=clang++ \
    -DCOBOT_TEST_OPTIONS=-O0
  ninja -C "$build/watched" fuzz_corpora cobot_german_locale cobot_german_locale_files "${core_tests[@]/#/test_}"
  watch
}

# Options of the sanitizers for all programs that run from now on.
watch() {
  export ASAN_OPTIONS=detect_stack_use_after_return=1:strict_string_checks=1:check_initialization_order=1
  export UBSAN_OPTIONS=print_stacktrace=1
  export TSAN_OPTIONS="halt_on_error=1:second_deadlock_stack=1:suppressions=$root/test/tsan-suppressions.txt"
}
