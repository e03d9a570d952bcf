// Any bytes as a RAPID program, in both dialects: findings within the limits, and a program exactly if there
// is no error. All its values are within its constants.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <string_view>

#include "require.h"

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/rapid/checks/check.h"
#include "cobot_command/rapid/source/limits.h"

using namespace cobot_command;
using namespace cobot_command::rapid;

namespace {

void checkFindings(const Source& source, const CheckedProgram& checked) {
  const std::vector<Finding>& findings = checked.findings.front();
  REQUIRE(findings.size() <= kMostFindings + 1);
  bool has_error = false;
  for (const Finding& finding : findings) {
    REQUIRE(finding.span.begin <= finding.span.end && finding.span.end <= source.text().size());
    const std::string line = describe(source, finding, "a.mod");
    REQUIRE(line.size() < 800 && line == escaped(line));
    has_error = has_error || finding.severity() == Severity::Error;
  }
  REQUIRE((checked.program == nullptr) == has_error);
}

void checkMeanings(const Program& program) {
  const FileIndex file = kPredefinedFiles;
  float sum = 0;
  for (NodeIndex node = 0; node < program.source(file).tree().size(); ++node) {
    const Cell* const value = program.constantAt(file, node);
    const std::uint32_t cells = program.types()[program.at(file, node).type].cells;
    for (std::uint32_t i = 0; value != nullptr && i < std::min(cells, 1000U); ++i) sum += value[i];
  }
  volatile float unused = sum;  // so that the cells are read
  static_cast<void>(unused);
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  for (const Dialect dialect : {Dialect::Irc5, Dialect::S4c}) {
    const auto source = std::make_shared<const Source>(readSource(bytes, {dialect}));
    CheckOptions options;
    options.is_library = dialect == Dialect::S4c;
    const CheckedProgram checked = check({{"a.mod", source}}, options);
    checkFindings(*source, checked);
    checkMeanings(*checked.draft);
  }
  return 0;
}
