// Any text: commands whose own text is read back the same, or faults of its lines.
#include <cstdint>
#include <string_view>

#include "require.h"

#include "cobot_command/script/script_reader.h"

using namespace cobot_command::script;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto script = readScript(std::string_view(reinterpret_cast<const char*>(data), size));
  if (!script) {
    REQUIRE(!script.error().empty());
    return 0;
  }
  for (const auto& [line, command] : *script) {
    const auto again = readScript(toText(command));
    REQUIRE(again.has_value());
    REQUIRE(again->size() == 1U);
    REQUIRE(again->front().command.index() == command.index());
  }
  return 0;
}
