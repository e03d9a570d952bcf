// Any text as a steps file of a pick-and-place cycle: steps, or a fault that names the file.
#include <cstdint>
#include <string>

#include "files/pick_and_place_file.h"
#include "require.h"

#include "cobot_command/common/foreign_text.h"

using namespace cobot_command;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto steps = ros_adapter::parsePickAndPlace(text, "steps.yaml");
  if (!steps) {
    REQUIRE(steps.error().compare(0, 10, "steps.yaml") == 0);
    REQUIRE(steps.error().size() < 1000);
    REQUIRE(steps.error() == escaped(steps.error()));
  }
  return 0;
}
