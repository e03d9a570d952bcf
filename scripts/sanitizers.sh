# Shared by the scripts beside it: builds with sanitizers, in folders of their own. To be sourced behind setup.sh.

# The rooms that read what a peer sent, those that decide what becomes of it, and what they stand on. Their tests run once
# with every change, watched, in a build of their own; the build of everything leaves them out then. What is quick
# (corpora) runs in both. Not those that calculate for minutes when they are watched, geometry most of all: they run in
# the build of everything, and `scripts/test --sanitize address` watches them.
readonly core_tests=(allocation automata blocks capabilities cell_agent cell_artifact cell_model cell_monitor cell_program
  cell_supervision command common files kinematics link peers protocol robot script simulator tables tm_script
  dynamics follow_joint_trajectory hostile io_failures paths project_values runtime runtime_parts synchronisation transport)
core_tests_pattern=$(IFS='|' && echo "^((${core_tests[*]})[.]|fuzz[.]|locale[.](${core_tests[*]})_)")
readonly core_tests_pattern
# Both nodes as processes: goals and cancels of four clients at once, connections made and lost, ends and kills.
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
  watch
}

# What the address sanitizer does not see by itself. The other checks of undefined behaviour, of each pointer that is
# followed, cost a third of the time of the compiler, and what they find before it does is left to --sanitize address.
readonly core_sanitizers=address,bool,bounds,builtin,enum,integer-divide-by-zero,return,shift,signed-integer-overflow,unreachable

# What ROS could hide shows here: rooms of the core are built without it; and what one compiler lets pass: clang builds
# this, g++ all but these tests. What precompiled headers hide, clang-tidy shows. Nothing is gained by optimizing the tests
# themselves, and half of the compiler's time is lost.
build_core() {
  configure "$build/watched" -DCOBOT_CORE_ONLY=ON -DCOBOT_SANITIZE="$core_sanitizers" -DCMAKE_CXX_COMPILER=clang++ \
    -DCOBOT_TEST_OPTIONS=-O0
  ninja -C "$build/watched" fuzz_corpora cobot_german_locale cobot_german_locale_files "${core_tests[@]/#/test_}"
  watch
}

# What the sanitizers are to do, for the programs that are run from now on.
watch() {
  export ASAN_OPTIONS=detect_stack_use_after_return=1:strict_string_checks=1:check_initialization_order=1
  export UBSAN_OPTIONS=print_stacktrace=1
  export TSAN_OPTIONS="halt_on_error=1:second_deadlock_stack=1:suppressions=$root/test/tsan-suppressions.txt"
}
