# Several sources of a target compiled as one, so that the headers they share are read once: half of the time of the
# compiler. For whoever builds everything, as the scripts do; who changes one source waits for its neighbours then.
# What one source may leave out because its neighbour includes it, clang-tidy shows: it reads each by itself.
# Names without linkage meet: two sources that call different things the same cannot be compiled together. Find another
# name, make one thing of two that are the same, or name the source as ALONE where its room or test is declared.
option(COBOT_UNITY "Compile several sources of a target as one")

# cobot_use_unity(<target> [ALONE <source>...])
# About eight together. Which ones, their names decide: what is compiled alone moves no other source, and what is added
# does so only where it makes one more group.
function(cobot_use_unity target)
  if(NOT COBOT_UNITY)
    return()
  endif()
  cmake_parse_arguments(UNITY "" "" "ALONE" ${ARGN})
  get_target_property(sources ${target} SOURCES)
  list(LENGTH sources count)
  math(EXPR groups "(${count} + 7) / 8")
  foreach(source IN LISTS sources)
    string(MD5 hash ${source})
    string(SUBSTRING ${hash} 0 6 digits)
    math(EXPR group "0x${digits} % ${groups}")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${group})
  endforeach()
  set_source_files_properties(${UNITY_ALONE} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
