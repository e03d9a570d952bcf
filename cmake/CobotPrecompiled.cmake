# The headers that most sources include, read once for all rooms and once for all tests: a third to a half of the time
# of a compilation. For whoever builds everything from scratch, as the scripts do. Each source of a room includes what it
# uses all the same: clang-tidy reads them without.
option(COBOT_PRECOMPILE "Precompile the headers that most sources include")

set(cobot_room_headers
    <algorithm>
    <array>
    <chrono>
    <cmath>
    <functional>
    <map>
    <memory>
    <optional>
    <string>
    <string_view>
    <utility>
    <variant>
    <vector>
    <Eigen/Geometry>
    <tl/expected.hpp>)
set(cobot_test_headers ${cobot_room_headers} <gmock/gmock.h> <gtest/gtest.h>)
list(APPEND cobot_room_headers <fmt/format.h>)

# cobot_precompiled_headers(<name> HEADERS <header>... USES <target>...)
# A library without code, whose headers others take with cobot_use_precompiled(); they must be compiled with its options.
function(cobot_precompiled_headers name)
  cmake_parse_arguments(PRECOMPILED "" "" "HEADERS;USES" ${ARGN})
  file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp "")
  add_library(${name} OBJECT ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
  target_compile_features(${name} PRIVATE cxx_std_17)
  target_precompile_headers(${name} PRIVATE ${PRECOMPILED_HEADERS})
  target_link_libraries(${name} PRIVATE ${PRECOMPILED_USES} cobot_warnings)
  # For ccache, which compares what is in them.
  target_compile_options(${name} PRIVATE "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
endfunction()

function(cobot_use_precompiled target name)
  if(TARGET ${name})
    target_precompile_headers(${target} REUSE_FROM ${name})
    # For ccache, which looks into what the preprocessor makes of a source.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
    # clang may read the list of headers once more, beside what is precompiled of it: always where ccache asks the
    # preprocessor alone, and with ccache's relative paths on Debian 13. It has to find them then, though all are known.
    target_include_directories(${target} SYSTEM
                               PRIVATE "$<$<CXX_COMPILER_ID:Clang>:$<TARGET_PROPERTY:${name},INCLUDE_DIRECTORIES>>")
  endif()
endfunction()
