// Any bytes as a signal file: signals within the limits, or one bounded reason.
#include <cstdint>
#include <string>

#include "require.h"

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/rapid/checks/signal_file.h"
#include "cobot_command/rapid/source/name_table.h"

using namespace cobot_command;
using namespace cobot_command::rapid;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto signals = readSignalFile(std::string(reinterpret_cast<const char*>(data), size));
  if (!signals) {
    REQUIRE(signals.error().line >= 1 && signals.error().column >= 1);
    REQUIRE(signals.error().text.size() < 500 && signals.error().text == escaped(signals.error().text));
    return 0;
  }
  for (const Signal& signal : *signals) {
    REQUIRE(!signal.name.empty() && signal.folded == folded(signal.name));
    REQUIRE(!signal.indices.empty() && signal.indices.size() <= 16);
  }
  return 0;
}
