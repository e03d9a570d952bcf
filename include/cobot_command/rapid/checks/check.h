// Checks all modules of a program together: names, types, calls and flow.
//
//   const auto source = std::make_shared<const Source>(readSource(bytes));
//   const CheckedProgram checked = check({{"robot.mod", source}}, {});
//   for (const Finding& finding : checked.findings.front()) print(describe(*source, finding, "robot.mod"));
//   if (checked.program) run(*checked.program);
//
// Every error of every file is found in one pass. An error is reported once: what follows from it is not.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cobot_command/rapid/source/finding.h"
#include "cobot_command/rapid/source/source.h"
#include "cobot_command/rapid/types/program.h"
#include "cobot_command/rapid/types/signal.h"

namespace cobot_command::rapid {

struct CheckedFile {
  std::string name;  ///< for texts that refer to another file
  std::shared_ptr<const Source> source;
};

struct CheckOptions {
  /// A set of modules without main().
  bool is_library = false;
  /// Procedures that are passed over if they are not supported or not declared (W524). Case does not count.
  std::vector<std::string> skipped;
  /// Empty: none are configured.
  std::vector<Signal> signals;
};

struct CheckedProgram {
  /// Of each file, in their order: those of reading, too. At most kMostFindings of a file, then E903.
  std::vector<std::vector<Finding>> findings;
  /// nullptr if there is an error: it cannot be run.
  std::shared_ptr<const Program> program;
  /// What was bound, errors or not: for an editor.
  std::shared_ptr<const Program> draft;
  /// How many nodes were looked at; tests count them, because a clock proves no linear time.
  std::uint64_t steps = 0;
};

/// All files are of one dialect: that of the first one counts.
[[nodiscard]] CheckedProgram check(const std::vector<CheckedFile>& files, const CheckOptions& options);

}  // namespace cobot_command::rapid
