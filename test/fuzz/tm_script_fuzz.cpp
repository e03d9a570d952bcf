// Any text: statements whose own text is read back the same, or faults; what the check passes also runs to an
// end.
#include <cstdint>
#include <string_view>

#include "require.h"
#include "script_session.h"

using namespace cobot_command::tm_script;

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const ParsedScript script = parse(text);
  const ParsedScript again = parse(toText(script.statements));
  REQUIRE(again.faults.empty());
  REQUIRE(toText(again.statements) == toText(script.statements));

  Session session({1, 84});
  if (!session.check(text).errors.empty()) return 0;
  Interpreter interpreter = session.start(text);
  for (int waits = 0; interpreter.run(10000) == Progress::Waiting && waits < 1000; ++waits) {
    interpreter.resume(Scalar(1));
  }
  REQUIRE((interpreter.progress() == Progress::Failed) == interpreter.fault().has_value());
  return 0;
}
