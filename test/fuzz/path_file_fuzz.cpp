// Any text as a file of path points: points, or a fault that names the file.
#include <cstdint>
#include <string>

#include "files/path_file.h"
#include "require.h"

#include "cobot_command/common/foreign_text.h"

using namespace cobot_command;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto points = ros_adapter::parsePath(text, "points.yaml");
  if (!points) {
    REQUIRE(points.error().compare(0, 11, "points.yaml") == 0);
    REQUIRE(points.error().size() < 1000);
    REQUIRE(points.error() == escaped(points.error()));
  }
  return 0;
}
