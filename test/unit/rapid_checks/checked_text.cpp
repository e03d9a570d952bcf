#include "checked_text.h"

#include <fmt/format.h>

namespace cobot_command::rapid {

CheckedProgram checkedText(const std::string& text, const CheckOptions& options, Dialect dialect) {
  return check({{"a.mod", std::make_shared<const Source>(readSource(text, {dialect}))}}, options);
}

std::vector<std::string> idsAndPlaces(const Source& source, const std::vector<Finding>& findings) {
  std::vector<std::string> lines;
  for (const Finding& finding : findings) {
    const Place place = source.placeOf(finding.span.begin);
    lines.push_back(fmt::format("{} {}:{}", finding.id, place.line, place.column));
  }
  return lines;
}

std::string withMain(const std::string& lines, const std::string& declarations) {
  return "MODULE m\n" + declarations + "PROC main()\n" + lines + "\nENDPROC\nENDMODULE\n";
}

std::vector<std::string> findingsInMain(const std::string& lines, const std::string& declarations) {
  const CheckedProgram checked = checkedText(withMain(lines, declarations));
  return idsAndPlaces(checked.draft->source(kPredefinedFiles), checked.findings.front());
}

}  // namespace cobot_command::rapid
