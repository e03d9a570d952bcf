// One row for each function of the robot: everything that is known of it in one place.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "call_arguments.h"
#include "call_text.h"

#include "cobot_command/script/robot_functions.h"
#include "cobot_command/script/script_command.h"
#include "cobot_command/tm_script/functions.h"

namespace cobot_command::script {

/// A way to call a function. p6 stands for six numbers or an array of six; so do p9, and i3 for integers.
struct Form {
  std::string_view parameters;
  tm_script::Version since;
};

/// The letters of the data formats that a motion takes (I848-E-03 chapter 8).
using Formats = std::vector<std::string_view>;

/// An integer that the controller takes from `least` to `most` only.
struct Range {
  std::size_t argument = 0;
  std::string_view what;
  int least = 0;
  int most = 0;
};

struct FunctionRow {
  enum class Way { Queued, Immediate };
  enum class Licence { NotNeeded, Needed };

  std::string_view result;
  std::string_view name;
  std::vector<Form> forms;
  Way way = Way::Queued;
  Formats formats = {};
  std::vector<Range> ranges = {};
  Licence licence = Licence::NotNeeded;
  /// What else is wrong with a call.
  std::optional<std::string> (*objection)(const KnownArguments& arguments) = nullptr;

  std::size_t command = 0;  ///< its alternative of ScriptCommand
  ScriptCommand (*make)(CallArguments& arguments) = nullptr;
  void (*write)(CallText& text, const ScriptCommand& command) = nullptr;
};

/// The place of a type among the alternatives of ScriptCommand.
template <class Command, std::size_t place = 0>
constexpr std::size_t placeOf() {
  if constexpr (std::is_same_v<std::variant_alternative_t<place, ScriptCommand>, Command>) {
    return place;
  } else {
    return placeOf<Command, place + 1>();
  }
}

/// Completes a row by what turns a call into its command, and its command into the arguments of a call.
template <class Command, Command (*make)(CallArguments&), void (*write)(CallText&, const Command&)>
FunctionRow rowOf(FunctionRow row) {
  row.command = placeOf<Command>();
  row.make = [](CallArguments& arguments) -> ScriptCommand { return make(arguments); };
  row.write = [](CallText& text, const ScriptCommand& command) { write(text, std::get<Command>(command)); };
  return row;
}

/// For a command without arguments.
template <class Command>
FunctionRow plainRow(std::string_view name, tm_script::Version since, FunctionRow::Way way,
                     FunctionRow::Licence licence = FunctionRow::Licence::NotNeeded) {
  FunctionRow row{"bool", name, {{"", since}}, way};
  row.licence = licence;
  row.command = placeOf<Command>();
  row.make = [](CallArguments& /*arguments*/) -> ScriptCommand { return Command{}; };
  row.write = [](CallText& /*text*/, const ScriptCommand& /*command*/) {};
  return row;
}

[[nodiscard]] std::vector<FunctionRow> motionFunctions();
[[nodiscard]] std::vector<FunctionRow> modeFunctions();  ///< PVT, continuous velocities
[[nodiscard]] std::vector<FunctionRow> settingFunctions();
[[nodiscard]] std::vector<FunctionRow> queueFunctions();

}  // namespace cobot_command::script
