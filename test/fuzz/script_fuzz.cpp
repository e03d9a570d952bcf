// Any text: commands whose own text is read back the same, or faults of its lines.
#include <cstdint>
#include <string_view>

#include "require.h"

#include "cobot_command/protocol/script_command.h"

using namespace cobot_command::protocol;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto script = parseScript(std::string_view(reinterpret_cast<const char*>(data), size));
  if (!script) {
    REQUIRE(!script.error().empty());
    return 0;
  }
  for (const ParsedScript::Line& line : script->lines) {
    const std::string text = toText(line.command);
    const auto again = parseCommand(text);
    REQUIRE(again.has_value());
    REQUIRE(again->index() == line.command.index());
  }
  return 0;
}
