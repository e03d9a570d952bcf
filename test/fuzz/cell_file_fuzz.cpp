// Any text as the file of a cell: a cell that has a hash, or faults that say where and what to do.
#include <cstdint>
#include <string>

#include "require.h"

#include "cobot_command/cell/program/canonical.h"
#include "cobot_command/cell/program/cell_file.h"
#include "cobot_command/common/foreign_text.h"

using namespace cobot_command;

namespace {

/// The text is its own file of steps, too.
cell::ReadFile reading(const std::string& text) {
  return [&text](const std::string&) -> Result<std::string, std::string> { return text; };
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const auto cell = cell::parseCell(text, "cell.yaml", reading(text));
  if (cell) {
    REQUIRE(cell::hashOf(*cell).size() == 64);
    return 0;
  }
  REQUIRE(!cell.error().empty() && cell.error().size() <= 100);
  for (const cell::Fault& fault : cell.error()) {
    const std::string told = describe(fault);
    REQUIRE(!fault.file.empty() && !fault.found.empty() && !fault.advice.empty());
    REQUIRE(told.size() < 3000);
    REQUIRE(told == escaped(told));
  }
  return 0;
}
