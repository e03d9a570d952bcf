#include "cobot_command/script/robot_functions.h"

#include <algorithm>
#include <array>
#include <cassert>

#include "function_row.h"
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cobot_command/common/overloaded.h"

namespace cobot_command::script {
namespace {

const std::vector<FunctionRow>& functionRows() {
  static const std::vector<FunctionRow> kFunctions = [] {
    std::vector<FunctionRow> all;
    for (const auto& some : {motionFunctions(), settingFunctions(), queueFunctions(), modeFunctions()}) {
      all.insert(all.end(), some.begin(), some.end());
    }
    return all;
  }();
  return kFunctions;
}

const FunctionRow* find(std::string_view name) {
  const auto& all = functionRows();
  const auto found = std::find_if(all.begin(), all.end(), [&](const auto& f) { return f.name == name; });
  return found == all.end() ? nullptr : &*found;
}

/// Nothing for what is no function: an output.
const FunctionRow* find(const ScriptCommand& command) {
  const auto& all = functionRows();
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const auto& f) { return f.command == command.index(); });
  return found == all.end() ? nullptr : &*found;
}

void declareForms(tm_script::FunctionTable& functions, const std::string& declaration,
                  tm_script::Version since) {
  static const std::array<std::array<std::string_view, 3>, 3> kShort{
      {{"p6", "6 double", "double[6]"}, {"p9", "9 double", "double[9]"}, {"i3", "3 int", "int[3]"}}};
  for (const auto& [mark, apart, array] : kShort) {
    const std::size_t at = declaration.find(mark);
    if (at == std::string::npos) continue;
    for (const std::string_view form : {apart, array}) {
      declareForms(functions, std::string(declaration).replace(at, mark.size(), form), since);
    }
    return;
  }
  functions.declare(declaration, since);
}

std::optional<std::string> wrongFormat(const FunctionRow& function, const KnownArguments& arguments) {
  if (function.formats.empty() || !arguments[0]) return std::nullopt;
  const auto* format = std::get_if<std::string>(&*arguments[0]);
  const auto& allowed = function.formats;
  if (format == nullptr || std::find(allowed.begin(), allowed.end(), *format) != allowed.end()) {
    return std::nullopt;
  }
  return fmt::format("{} takes the formats {}", function.name, fmt::join(allowed, ", "));
}

std::optional<std::string> outside(const Range& range, const KnownArguments& arguments) {
  if (arguments.size() <= range.argument || !arguments[range.argument]) return std::nullopt;
  const auto number = std::visit(Overloaded{[](std::uint8_t byte) { return std::optional<int>(byte); },
                                            [](std::int32_t integer) { return std::optional<int>(integer); },
                                            [](const auto&) { return std::optional<int>(); }},
                                 *arguments[range.argument]);
  if (!number || (*number >= range.least && *number <= range.most)) return std::nullopt;
  return fmt::format("{} is {} to {}, not {}", range.what, range.least, range.most, *number);
}

}  // namespace

void declareRobotFunctions(tm_script::FunctionTable& functions) {
  for (const FunctionRow& function : functionRows()) {
    for (const Form& form : function.forms) {
      declareForms(functions, fmt::format("{} {}({})", function.result, function.name, form.parameters),
                   form.since);
    }
  }
  functions.declare("int ListenSend(int, any)", {1, 76});
  functions.declare("int ListenSend(int, any[])", {1, 76});
}

KnownArguments knownArguments(const tm_script::Arguments& arguments) {
  KnownArguments known;
  for (const tm_script::Value& argument : arguments) {
    const auto* scalar = std::get_if<tm_script::Scalar>(&argument);
    known.push_back(scalar == nullptr ? std::nullopt : std::optional(*scalar));
  }
  return known;
}

std::optional<std::string> objectionTo(const std::string& function, const KnownArguments& arguments) {
  const FunctionRow* known = find(function);
  if (known == nullptr) return std::nullopt;
  if (auto wrong = wrongFormat(*known, arguments)) return wrong;
  for (const Range& range : known->ranges) {
    if (auto wrong = outside(range, arguments)) return wrong;
  }
  return known->objection == nullptr ? std::nullopt : known->objection(arguments);
}

ScriptCommand commandOf(const std::string& function, const tm_script::Arguments& arguments) {
  CallArguments reader(arguments);
  return find(function)->make(reader);
}

std::string toText(const ScriptCommand& command) {
  if (const auto* write = std::get_if<WriteOutput>(&command)) return toText(*write);
  if (const auto* write = std::get_if<WriteAnalogOutput>(&command)) return toText(*write);
  const FunctionRow* function = find(command);
  assert(function != nullptr);
  CallText text(function->name);
  function->write(text, command);
  return std::move(text).str();
}

bool isQueued(std::string_view function) {
  const FunctionRow* known = find(function);
  return known != nullptr && known->way == FunctionRow::Way::Queued;
}

bool isQueued(const ScriptCommand& command) {
  if (const auto* write = std::get_if<WriteOutput>(&command)) return !write->instant;
  if (const auto* write = std::get_if<WriteAnalogOutput>(&command)) return !write->instant;
  return find(command)->way == FunctionRow::Way::Queued;
}

bool needsLicence(std::string_view function) {
  const FunctionRow* known = find(function);
  return known != nullptr && known->licence == FunctionRow::Licence::Needed;
}

}  // namespace cobot_command::script
