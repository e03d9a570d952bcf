#include "check_command.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <utility>

#include "dialect_setting.h"
#include "exit_status.h"
#include "finding_text.h"
#include "source_file.h"
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/setting_kinds.h"
#include "cobot_command/rapid/checks/check.h"
#include "cobot_command/rapid/checks/signal_file.h"
#include "cobot_command/rapid/source/limits.h"

namespace cobot_command::tools {

namespace {

using rapid::Finding;
using rapid::Place;
using rapid::Severity;
using rapid::SignalFileFault;
using rapid::Source;

Result<std::vector<std::string>, std::string> namesIn(const std::string& text) {
  std::vector<std::string> names;
  std::size_t begin = 0;
  while (begin <= text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    if (end == begin) return refuse(std::string("has an empty name"));
    names.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return names;
}

Result<std::vector<rapid::Signal>, SignalFileFault> signalsOf(const std::string& file) {
  if (file.empty()) return std::vector<rapid::Signal>{};
  const auto bytes = bytesOf(file);
  if (!bytes) {
    return refuse(SignalFileFault{1, 1, "signal file: cannot be read: " + foreignText(bytes.error())});
  }
  if (bytes->size() > rapid::kMostFileBytes) {
    return refuse(SignalFileFault{1, 1, "signal file: longer than 16 MiB"});
  }
  return rapid::readSignalFile(*bytes);
}

/// Where the findings of all files go.
class Report {
 public:
  explicit Report(bool is_json) : is_json_(is_json) {}

  void add(const std::string& file, const SignalFileFault& fault) {
    constexpr std::string_view kId = "E905";
    has_errors_ = true;
    if (is_json_) {
      row(file, kId, Severity::Error, fault.text, {fault.line, fault.column}, {fault.line, fault.column});
    } else {
      std::cout << fmt::format("{}:{}:{}: error {}: {}\n", foreignText(file), fault.line, fault.column, kId,
                               forPeople(fault.text));
    }
  }

  void add(const std::string& file, const Source& source, const Finding& finding) {
    const bool is_error = finding.severity() == Severity::Error;
    (is_error ? has_errors_ : has_warnings_) = true;
    if (is_json_) {
      row(file, finding.id, finding.severity(), finding.text, source.placeOf(finding.span.begin),
          source.placeOf(finding.span.end));
    } else {
      for (const std::string& line : findingLines(source, finding, file)) {
        std::cout << forPeople(line) << '\n';
      }
    }
  }

  void print() const {
    using Dump = nlohmann::ordered_json;
    if (is_json_) std::cout << rows_.dump(2, ' ', false, Dump::error_handler_t::replace) << '\n';
  }

  [[nodiscard]] int status(bool is_strict) const {
    return has_errors_ || (is_strict && has_warnings_) ? kFound : kDone;
  }

 private:
  void row(const std::string& file, std::string_view id, Severity severity, const std::string& text,
           const Place& begin, const Place& end) {
    rows_.push_back({{"file", file},
                     {"id", id},
                     {"severity", rapid::toString(severity)},
                     {"line", begin.line},
                     {"column", begin.column},
                     {"text", text},
                     {"end_line", end.line},
                     {"end_column", end.column}});
  }

  bool is_json_;
  bool has_errors_ = false;
  bool has_warnings_ = false;
  nlohmann::ordered_json rows_ = nlohmann::ordered_json::array();
};

}  // namespace

SettingTable checkTable(CheckCommand& command) {
  const auto show = [](const std::vector<std::string>& names) {
    return fmt::format("{}", fmt::join(names, ","));
  };
  return {
      dialectSetting(command.dialect),
      {"signals", setting_kinds::text(command.signals), "Signal file, in YAML"},
      {"library", setting_kinds::flag(command.is_library), "The modules need no main()"},
      {"strict", setting_kinds::flag(command.is_strict), "Exit with 1 also if there are only warnings"},
      {"json", setting_kinds::flag(command.is_json), "Print the findings as JSON"},
      {"skip",
       setting_kinds::written<std::vector<std::string>>(
           command.skipped, "names of procedures, separated by commas", namesIn, show),
       "Pass over calls of these procedures if they are not supported or not declared"},
  };
}

int check(const CheckCommand& command) {
  std::vector<rapid::CheckedFile> files;
  for (const std::string& file : command.files) {
    files.push_back({file, std::make_shared<const Source>(readSourceFile(file, {command.dialect}))});
  }
  auto signals = signalsOf(command.signals);
  Report report(command.is_json);
  rapid::CheckOptions options;
  options.is_library = command.is_library;
  options.skipped = command.skipped;
  if (signals) {
    options.signals = *std::move(signals);
    const rapid::CheckedProgram checked = rapid::check(files, options);
    for (std::size_t i = 0; i < files.size(); ++i) {
      for (const Finding& finding : checked.findings[i]) report.add(files[i].name, *files[i].source, finding);
    }
  } else {
    // Without the signals each use of one would be an error: only what reading finds is reported.
    report.add(command.signals, signals.error());
    for (const rapid::CheckedFile& file : files) {
      for (const Finding& finding : file.source->findings()) report.add(file.name, *file.source, finding);
    }
  }
  report.print();
  return report.status(command.is_strict);
}

}  // namespace cobot_command::tools
