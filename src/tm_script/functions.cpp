#include "cobot_command/tm_script/functions.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "library/declaration.h"
#include "library/library.h"
#include "library/refused_functions.h"
#include "values/conversion.h"
#include <fmt/format.h>

namespace cobot_command::tm_script {

namespace {

/// What the argument is to be converted to; nothing when no conversion helps.
std::optional<Type> wanted(const Parameter& parameter, Type argument, Type first) {
  switch (parameter.kind) {
    case Parameter::Kind::Fixed:
      return parameter.type;
    case Parameter::Kind::Element:
      return Type{first.scalar, parameter.type.is_array};
    case Parameter::Kind::Number:
      if (!isNumber(argument.scalar)) return std::nullopt;
      [[fallthrough]];
    default:
      if (parameter.type.is_array != argument.is_array) return std::nullopt;
      return argument;
  }
}

struct Fit {
  Match match;
  int cost = 0;
};

std::optional<Fit> fit(const Function& function, const std::vector<Type>& arguments) {
  if (arguments.size() < function.required || arguments.size() > function.parameters.size()) {
    return std::nullopt;
  }
  Fit found;
  found.match.function = &function;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const auto type = wanted(function.parameters[i], arguments[i], arguments.front());
    const Conversion conversion = type ? conversionOf(arguments[i], *type) : Conversion::None;
    // A text that becomes a number would be a target for a motion: the robot takes none.
    if (conversion == Conversion::None || (conversion == Conversion::Text && !function.compute)) {
      return std::nullopt;
    }
    found.match.arguments.push_back(*type);
    found.match.is_warned = found.match.is_warned || isWarned(conversion);
    // One bad conversion is worse than any number of better ones.
    constexpr int kCosts[] = {0, 1, 100, 10000};
    found.cost += kCosts[static_cast<int>(conversion)];
  }
  const Parameter& result = function.result;
  if (result.kind == Parameter::Kind::Fixed) {
    found.match.result = result.type;
  } else {
    found.match.result = {arguments.front().scalar, result.type.is_array};
  }
  return found;
}

std::string listOf(const std::vector<Type>& types) {
  std::string text;
  for (const Type type : types) text += (text.empty() ? "" : ", ") + toText(type);
  return text;
}

/// Those that this version has: others would be no help.
std::string formsOf(const std::vector<Function>& functions, Version tmflow) {
  std::string text;
  for (const Function& function : functions) {
    if (!(tmflow < function.since)) text += (text.empty() ? "" : " or ") + toText(function);
  }
  return text;
}

}  // namespace

FunctionTable::FunctionTable(Version tmflow) : tmflow_(tmflow) {
  defineByteFunctions(*this);
  defineStringFunctions(*this);
  defineArrayFunctions(*this);
  defineTextFunctions(*this);
  defineChecksumFunctions(*this);
  defineMathematics(*this);
  definePoseFunctions(*this);
}

void FunctionTable::declare(std::string_view declaration, Version since) {
  define(declaration, since, nullptr);
}

void FunctionTable::define(std::string_view declaration, Version since, Builtin compute) {
  Function function = readDeclaration(declaration);
  function.since = since;
  function.compute = std::move(compute);
  functions_[function.name].push_back(std::move(function));
}

Result<Match, std::string> FunctionTable::find(const std::string& name,
                                               const std::vector<Type>& arguments) const {
  const auto found = functions_.find(name);
  if (found == functions_.end()) return refuse(whyUnknown(name));
  std::optional<Fit> best;
  Version oldest{9999, 0};
  bool has_version = false;
  for (const Function& function : found->second) {
    oldest = std::min(oldest, function.since);
    if (tmflow_ < function.since) continue;
    has_version = true;
    auto candidate = fit(function, arguments);
    if (candidate && (!best || candidate->cost < best->cost)) best = std::move(candidate);
  }
  if (!has_version) {
    return refuse(fmt::format("{} exists since TMflow {}.{}; this is {}.{}", name, oldest.major, oldest.minor,
                              tmflow_.major, tmflow_.minor));
  }
  if (!best) {
    return refuse(fmt::format("{}({}) is not defined, only {}", name, listOf(arguments),
                              formsOf(found->second, tmflow_)));
  }
  return best->match;
}

}  // namespace cobot_command::tm_script
