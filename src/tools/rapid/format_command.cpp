#include "format_command.h"

#include <algorithm>
#include <iostream>
#include <utility>

#include "dialect_setting.h"
#include "exit_status.h"
#include "finding_text.h"
#include "source_file.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/setting_kinds.h"
#include "cobot_command/rapid/source/printer.h"
#include "cobot_command/rapid/types/predefined.h"

namespace cobot_command::tools {

namespace {

void printErrors(const rapid::Source& source, const std::string& file) {
  for (const rapid::Finding& finding : source.findings()) {
    if (finding.severity() == rapid::Severity::Warning) continue;
    for (const std::string& line : findingLines(source, finding, file)) std::cerr << forPeople(line) << '\n';
  }
}

/// The first place of the source that the canonical form does not have.
rapid::Place firstDifference(const rapid::Source& source, std::string_view canonical) {
  const std::string_view text = source.text();
  const auto* const at = std::mismatch(text.begin(), text.end(), canonical.begin(), canonical.end()).first;
  return source.placeOf(static_cast<std::uint32_t>(at - text.begin()));
}

int check(const rapid::Source& source, const std::string& canonical, const std::string& file) {
  if (source.text() == canonical) return kDone;
  const rapid::Place place = firstDifference(source, canonical);
  std::cerr << foreignText(file) << ':' << place.line << ':' << place.column
            << ": not in canonical form; rapid format --write makes it so\n";
  return kFound;
}

int write(const std::string& file, const std::string& bytes) {
  const auto why = replaceFile(file, bytes);
  if (!why) return kDone;
  std::cerr << "rapid: " << foreignText(file) << " cannot be written: " << forPeople(*why) << '\n';
  return kFound;
}

}  // namespace

SettingTable formatTable(FormatOptions& options) {
  return {
      dialectSetting(options.dialect),
      {"write", setting_kinds::flag(options.is_written),
       "Replace the file instead of printing its canonical form"},
      {"check", setting_kinds::flag(options.is_checked),
       "Print nothing; exit with 1 if the file is not in canonical form"},
  };
}

std::string contradictionIn(const FormatOptions& options) {
  if (options.is_written && options.is_checked) return "--write and --check exclude each other";
  const bool is_stream = options.file == kStandardInput;
  return options.is_written && is_stream ? "--write needs a file: standard input cannot be replaced" : "";
}

int format(const FormatOptions& options) {
  const rapid::Source source = readSourceFile(options.file, {options.dialect});
  if (source.isBroken()) {
    printErrors(source, options.file);
    return kFound;
  }
  const std::string canonical = rapid::print(source, rapid::predefinedNames());
  if (options.is_checked) return check(source, canonical, options.file);
  const std::string bytes = rapid::encoded(canonical, source.encoding());
  if (!options.is_written) {
    std::cout << bytes;
    return kDone;
  }
  return source.text() == canonical ? kDone : write(options.file, bytes);
}

}  // namespace cobot_command::tools
