# Several sources of a target compiled as one, so that the headers they share are read once: half of the time of a build
# from scratch. For whoever builds everything, as the scripts do; who changes one source waits for its neighbours then.
# What one source may leave out because its neighbour includes it, clang-tidy shows: it reads each by itself.
# Names without linkage meet: two sources that call different things the same cannot be compiled together. Find another
# name, make one thing of two that are the same, or name the source as ALONE where its room or test is declared.
option(COBOT_UNITY "Compile several sources of a target as one")

# cobot_use_unity(<target> [ALONE <source>...])
function(cobot_use_unity target)
  cmake_parse_arguments(UNITY "" "" "ALONE" ${ARGN})
  set_target_properties(${target} PROPERTIES UNITY_BUILD ${COBOT_UNITY} UNITY_BUILD_BATCH_SIZE 8)
  set_source_files_properties(${UNITY_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
