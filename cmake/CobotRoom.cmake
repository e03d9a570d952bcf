# A room is one folder, one namespace, one library and one test program.
# A room states its sources and the rooms and libraries that it may use; arrows point down only.

add_library(cobot_warnings INTERFACE)
target_compile_options(cobot_warnings INTERFACE -Wall -Wextra -Wconversion -Wshadow
                                                $<$<BOOL:${COBOT_WARNINGS_AS_ERRORS}>:-Werror>)

# For all that is compiled here, and nothing that an installed library asks of those who use it.
if(COBOT_SANITIZE)
  add_compile_options(-fsanitize=${COBOT_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  # g++ loses sight of what is initialized between the checks that sanitizers put in, and says so of itself.
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  add_link_options(-fsanitize=${COBOT_SANITIZE})
  if(COBOT_SANITIZE MATCHES thread)
    # The thread sanitizer knows no fences, and g++ refuses them with it. Asio's locks say what it has to know.
    add_compile_definitions(BOOST_ASIO_DISABLE_FENCED_BLOCK)
    # ROS's libraries keep to their own copies of boost's inline functions, and do not take ours, which are watched: a lock
    # and its unlock are then of one kind.
    add_compile_options(-fvisibility-inlines-hidden)
  endif()
endif()
if(COBOT_COVERAGE)
  add_compile_options(--coverage -fprofile-update=atomic)
  add_link_options(--coverage)
endif()
if(COBOT_FUZZ)
  # What libFuzzer sees of the code that it drives.
  add_compile_options(-fsanitize=fuzzer-no-link)
endif()
# Where TinyXML-2 asks for large files of whoever uses it (Debian 13), all sources have them: those that share precompiled
# headers have to agree on what the C library's types are.
find_package(tinyxml2 REQUIRED)
get_target_property(asked tinyxml2::tinyxml2 INTERFACE_COMPILE_DEFINITIONS)
if(_FILE_OFFSET_BITS=64 IN_LIST asked)
  add_compile_definitions(_FILE_OFFSET_BITS=64)
endif()

include(CobotUnity)
include(CobotPrecompiled)
if(COBOT_PRECOMPILE)
  cobot_precompiled_headers(cobot_room_headers HEADERS ${cobot_room_headers} USES Eigen3::Eigen fmt::fmt tl::expected)
  set_target_properties(cobot_room_headers PROPERTIES POSITION_INDEPENDENT_CODE ${BUILD_SHARED_LIBS})
endif()

# cobot_add_room(<name> SOURCES <file>... [ALONE <file>...] [USES <target>...] [PRIVATELY_USES <target>...] [FOR_NODES])
# Makes the library cobot_<name>, known to the others, and to other projects, as cobot_command::<name>. FOR_NODES: to ours
# only, as it is nothing but a part of the nodes.
function(cobot_add_room name)
  cmake_parse_arguments(ROOM "FOR_NODES" "" "SOURCES;ALONE;USES;PRIVATELY_USES" ${ARGN})
  add_library(cobot_${name} ${ROOM_SOURCES})
  add_library(cobot_command::${name} ALIAS cobot_${name})
  target_compile_features(cobot_${name} PUBLIC cxx_std_17)
  target_include_directories(
    cobot_${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>)
  target_link_libraries(
    cobot_${name}
    PUBLIC ${ROOM_USES}
    PRIVATE ${ROOM_PRIVATELY_USES})
  target_compile_options(cobot_${name} PRIVATE $<TARGET_PROPERTY:cobot_warnings,INTERFACE_COMPILE_OPTIONS>)
  cobot_use_unity(cobot_${name} ALONE ${ROOM_ALONE})
  if(fmt::fmt IN_LIST ROOM_PRIVATELY_USES)
    cobot_use_precompiled(cobot_${name} cobot_room_headers)
  endif()
  set_target_properties(cobot_${name} PROPERTIES EXPORT_NAME ${name} INSTALL_RPATH $ORIGIN)
  if(ROOM_FOR_NODES)
    set_property(GLOBAL APPEND PROPERTY COBOT_LIBRARIES_OF_NODES cobot_${name})
  else()
    set_property(GLOBAL APPEND PROPERTY COBOT_EXPORTED_LIBRARIES cobot_${name})
  endif()
endfunction()

# cobot_add_program(<name> SOURCES <file>... USES <target>...)
function(cobot_add_program name)
  cmake_parse_arguments(PROGRAM "" "" "SOURCES;USES" ${ARGN})
  add_executable(${name} ${PROGRAM_SOURCES})
  target_link_libraries(${name} PRIVATE ${PROGRAM_USES} cobot_warnings)
  cobot_use_unity(${name})
  set_property(GLOBAL APPEND PROPERTY COBOT_INSTALLED_PROGRAMS ${name})
endfunction()

set(COBOT_TEST_OPTIONS "" CACHE STRING "Compiler options of the test programs, behind those of everything")

# cobot_add_test(<name> SOURCES <file>... [ALONE <file>...] USES <target>... [TIMEOUT <seconds>])
# Makes one GoogleTest program; each of its tests is a CTest entry of its own, named <name>.<Suite>.<test>, that may take
# 120 s or the time that is given, and under a sanitizer five times as long. One that COBOT_TESTED_ELSEWHERE names is made
# only when it is asked for.
set(COBOT_TESTED_ELSEWHERE "" CACHE STRING "Test programs that another build makes and runs: names as in cobot_add_test")
function(cobot_add_test name)
  cmake_parse_arguments(TEST "" "TIMEOUT" "SOURCES;ALONE;USES" ${ARGN})
  if(NOT TEST_TIMEOUT)
    set(TEST_TIMEOUT 120)
  endif()
  if(COBOT_SANITIZE)
    math(EXPR TEST_TIMEOUT "5 * ${TEST_TIMEOUT}")
  endif()
  add_executable(test_${name} ${TEST_SOURCES})
  # Not where catkin puts programs: rosrun and roslaunch look there.
  set_target_properties(test_${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
  target_include_directories(test_${name} PRIVATE ${PROJECT_SOURCE_DIR}/test/support)
  target_link_libraries(test_${name} PRIVATE ${TEST_USES} cobot_source_tree GTest::gmock GTest::gtest_main cobot_warnings)
  target_compile_options(test_${name} PRIVATE ${COBOT_TEST_OPTIONS})
  cobot_use_unity(test_${name} ALONE ${TEST_ALONE})
  cobot_use_precompiled(test_${name} cobot_test_headers)
  if(name IN_LIST COBOT_TESTED_ELSEWHERE)
    set_target_properties(test_${name} PROPERTIES EXCLUDE_FROM_ALL TRUE)
    return()
  endif()
  gtest_discover_tests(test_${name} TEST_PREFIX "${name}." NO_PRETTY_VALUES DISCOVERY_TIMEOUT 60
                       PROPERTIES TIMEOUT ${TEST_TIMEOUT})
endfunction()
