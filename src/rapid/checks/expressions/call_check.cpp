#include "expressions/call_check.h"

#include <algorithm>
#include <array>

#include "type_reference.h"

namespace cobot_command::rapid {

namespace {

/// Functions that take the name of data, not its value.
constexpr std::array<std::string_view, 5> kTakeNames{"Present", "Dim", "IsPers", "IsVar", "ArgName"};
/// An option that is not supported, for the reason of this instruction.
constexpr std::string_view kRefusedOption = "Corr";
constexpr std::string_view kRefusedWith = "corrcon";
/// Parameters of a routine that are compared one by one.
constexpr std::uint32_t kFewParameters = 32;

bool isReferred(TokenKind mode) {
  return mode == TokenKind::Var || mode == TokenKind::Inout || mode == TokenKind::Pers;
}

std::string_view formOf(TokenKind mode) {
  return mode == TokenKind::Var     ? "a variable"
         : mode == TokenKind::Inout ? "a variable or whole persistent"
                                    : "a whole persistent";
}

/// What holds a value that a routine may change: a parameter by value is a variable, too.
bool isVariable(const Symbol& symbol) {
  if (symbol.kind == SymbolKind::Parameter) return symbol.word != TokenKind::Pers;
  return symbol.kind == SymbolKind::Signal || symbol.word == TokenKind::Var;
}

bool isPersistent(const Symbol& symbol) {
  const bool is_data = symbol.kind == SymbolKind::Data || symbol.kind == SymbolKind::Parameter;
  return is_data && symbol.word == TokenKind::Pers;
}

}  // namespace

void CallCheck::check(NodeIndex call, SymbolIndex routine) {
  routine_ = draft_.symbol(routine);
  if (routine_.has(Symbol::Faulty)) return;
  const bool is_predefined = routine_.file < kPredefinedFiles;
  takes_names_ =
      is_predefined && std::find(kTakeNames.begin(), kTakeNames.end(), routine_.name) != kTakeNames.end();
  Progress progress;
  progress.given.resize(routine_.parameters);
  for (const NodeIndex argument : file_.tree().children(call)) {
    file_.countStep();
    if (file_[argument].has(Node::Optional)) {
      option(argument, progress);
    } else if (!required(argument, progress)) {
      return;
    }
  }
  requireAll(call, progress);
}

/// False after a surplus argument: what follows it cannot be judged.
bool CallCheck::required(NodeIndex argument, Progress& progress) {
  while (progress.next < routine_.parameters && parameter(progress.next).has(Symbol::Optional)) {
    ++progress.next;
  }
  if (progress.next == routine_.parameters) {
    file_.reportNode(kinds::kSurplusArgument, argument);
    return false;
  }
  const Symbol wanted = parameter(progress.next);
  progress.given[progress.next] = 1;
  const bool is_named = file_[argument].kind == NodeKind::Argument;
  if (is_named) {
    file_.at(argument).symbol = routine_.first_parameter + progress.next;
    const TokenIndex name = file_[argument].name;
    if (file_.isName(name) && folded(wanted.name) != file_.foldedAt(name)) {
      file_.report(kinds::kArgumentName, name, nameOf(wanted), file_.quotedAt(name));
    }
  }
  ++progress.next;
  value(is_named ? file_[argument].child : argument, wanted);
  return true;
}

SymbolIndex CallCheck::parameterNamed(TokenIndex name) {
  if (!file_.isName(name)) return kNoSymbol;
  const std::string_view wanted = file_.foldedAt(name);
  const SymbolIndex first = routine_.first_parameter;
  const auto folded_name = [&](SymbolIndex symbol) {
    const Symbol& at = draft_.symbol(symbol);
    return draft_.parts.files[at.file].source->nameOf(at.node);
  };
  if (routine_.parameters <= kFewParameters) {
    for (SymbolIndex at = first; at < first + routine_.parameters; ++at) {
      if (folded_name(at) == wanted) return at;
    }
    return kNoSymbol;
  }
  if (parameters_of_ != first) {
    parameters_.clear();
    for (SymbolIndex at = first; at < first + routine_.parameters; ++at) {
      parameters_.emplace(folded_name(at), at);
    }
    parameters_of_ = first;
  }
  const auto found = parameters_.find(wanted);
  return found == parameters_.end() ? kNoSymbol : found->second;
}

std::string CallCheck::nearestOption(TokenIndex name) const {
  std::vector<std::string_view> names;
  for (std::uint32_t i = 0; i < std::min(routine_.parameters, kFewParameters); ++i) {
    if (parameter(i).has(Symbol::Optional)) names.push_back(parameter(i).name);
  }
  return nearestName(file_.source().textOf(name), names);
}

void CallCheck::option(NodeIndex argument, Progress& progress) {
  const TokenIndex name = file_[argument].name;
  const SymbolIndex found = parameterNamed(name);
  if (found == kNoSymbol || !draft_.symbol(found).has(Symbol::Optional)) {
    if (file_.isName(name)) file_.reportNear(kinds::kNoOption, name, nearestOption(name));
    if (file_[argument].child != kNoNode) expressions_.check(file_[argument].child, kNoType);
    return;
  }
  file_.at(argument).symbol = found;
  const bool is_refused = routine_.file < kPredefinedFiles && draft_.symbol(found).name == kRefusedOption;
  if (is_refused) {
    return reportRefused(file_, name, draft_.symbol(draft_.parts.names.predefined.at(kRefusedWith)));
  }
  checkOrder(name, found, progress);
  optionValue(argument, draft_.symbol(found));
}

void CallCheck::checkOrder(TokenIndex name, SymbolIndex option, Progress& progress) {
  const std::uint32_t position = option - routine_.first_parameter;
  const bool is_late = progress.last_option == kNoSymbol || option > progress.last_option;
  if (!is_late) return file_.report(kinds::kOptionOrder, name, file_.quotedAt(name));
  progress.given[position] = 1;
  // Options in order: of those that exclude this one only the last given can be one.
  const SymbolIndex last = std::exchange(progress.last_option, option);
  std::uint32_t first = position;
  while (parameter(first).has(Symbol::Excludes)) --first;
  const bool is_excluded = last != kNoSymbol && last - routine_.first_parameter >= first;
  if (is_excluded) {
    file_.report(kinds::kOptionExcluded, name, file_.quotedAt(name), nameOf(draft_.symbol(last)));
  }
}

void CallCheck::optionValue(NodeIndex argument, const Symbol& parameter) {
  const TokenIndex name = file_[argument].name;
  const NodeIndex given = file_[argument].child;
  if (file_[argument].has(Node::Conditional)) {
    if (given != kNoNode) passedOn(given, parameter);
  } else if (parameter.type == kSwitch) {
    if (given != kNoNode) file_.report(kinds::kSwitchValue, name, file_.quotedAt(name));
  } else if (given == kNoNode) {
    file_.report(kinds::kOptionValue, name, file_.quotedAt(name));
  } else {
    value(given, parameter);
  }
}

/// `\name?parameter`
void CallCheck::passedOn(NodeIndex reference, const Symbol& parameter) {
  const TokenIndex name = file_[reference].name;
  if (!file_.isName(name)) return;
  const SymbolIndex found = expressions_.names().find(name);
  const bool is_optional = found != kNoSymbol && draft_.symbol(found).kind == SymbolKind::Parameter &&
                           draft_.symbol(found).has(Symbol::Optional);
  if (!is_optional) return file_.report(kinds::kNoOptionalParameter, name, file_.quotedAt(name));
  file_.at(reference) = {found, draft_.symbol(found).type, kNoConstant};
  if (isReferred(parameter.word)) {
    const Referred referred{found, draft_.symbol(found).type, kNoConstant, true};
    if (!canBeReferred(reference, referred, parameter)) return;
  }
  requireType(reference, draft_.symbol(found).type, parameter);
}

void CallCheck::requireAll(NodeIndex call, const Progress& progress) {
  for (std::uint32_t i = 0; i < routine_.parameters; ++i) {
    if (progress.given[i] != 0 || parameter(i).has(Symbol::Optional)) continue;
    return file_.report(kinds::kMissingArgument, file_[call].last, nameOf(parameter(i)));
  }
}

void CallCheck::value(NodeIndex node, const Symbol& parameter) {
  if (node == kNoNode) return;
  if (takes_names_ && parameter.type == kAnytype) return byName(node, parameter);
  isReferred(parameter.word) ? byReference(node, parameter) : byValue(node, parameter);
}

void CallCheck::byValue(NodeIndex node, const Symbol& parameter) {
  const bool is_any = parameter.type == kAnytype;
  const Typed typed = expressions_.check(node, is_any ? kNoContext : parameter.type);
  const bool has_values = draft_.types()[typed.type].has_values;
  const bool is_without = is_any && !has_values;
  if (is_without) return file_.reportNode(kinds::kNoValues, node, file_.typeName(typed.type));
  requireType(node, typed.type, parameter);
}

void CallCheck::byReference(NodeIndex node, const Symbol& parameter) {
  if (file_[node].kind == NodeKind::Placeholder || file_[node].kind == NodeKind::Star) return;
  if (file_[node].kind != NodeKind::Reference) {
    return file_.reportNode(kinds::kArgumentForm, node, nameOf(parameter), formOf(parameter.word));
  }
  const Referred referred = expressions_.refer(node, parameter.type);
  if (referred.symbol == kNoSymbol || !canBeReferred(node, referred, parameter)) return;
  requireType(node, referred.type, parameter);
}

void CallCheck::byName(NodeIndex node, const Symbol& parameter) {
  if (file_[node].kind != NodeKind::Reference) {
    return file_.reportNode(kinds::kArgumentForm, node, nameOf(parameter), "a name");
  }
  const Referred referred = expressions_.refer(node);
  const bool is_array = draft_.types()[referred.type].kind == TypeKind::Array;
  const bool is_no_array = routine_.name == "Dim" && referred.type != kNoType && !is_array;
  if (is_no_array) {
    file_.reportNode(kinds::kWrongType, node, "an array", file_.typeName(referred.type));
  }
}

bool CallCheck::canBeReferred(NodeIndex node, const Referred& referred, const Symbol& parameter) {
  const Symbol& symbol = draft_.symbol(referred.symbol);
  const bool takes_parts = draft_.dialect == Dialect::Irc5;
  const bool fits_persistent =
      isPersistent(symbol) && (referred.is_whole || (takes_parts && parameter.word == TokenKind::Inout));
  const bool is_form = parameter.word == TokenKind::Var     ? isVariable(symbol)
                       : parameter.word == TokenKind::Inout ? isVariable(symbol) || fits_persistent
                                                            : fits_persistent;
  const TokenIndex name = file_[node].name;
  if (!is_form) {
    file_.reportNode(kinds::kArgumentForm, node, nameOf(parameter), formOf(parameter.word));
  } else if (symbol.has(Symbol::ReadOnly) && parameter.word != TokenKind::Pers) {
    file_.report(kinds::kUnchangeable, name, file_.quotedAt(name), "read-only");
    return false;
  }
  return is_form;
}

void CallCheck::requireType(NodeIndex node, TypeIndex found, const Symbol& parameter) {
  const bool is_referred = isReferred(parameter.word);
  // A reference is of the type itself: nothing is read where a num is needed.
  const bool is_read =
      is_referred && draft_.types()[found].kind == TypeKind::SemiValue && found != parameter.type;
  if (expressions_.fits(found, parameter.type) && !is_read) return;
  const Type& from = draft_.types()[found];
  const Type& to = draft_.types()[parameter.type];
  const TypeIndex base = from.kind == TypeKind::Array ? from.element : found;
  if (to.kind == TypeKind::Array && base == to.element) {
    const int given = from.kind == TypeKind::Array ? from.dimensions : 0;
    return file_.reportNode(kinds::kArgumentDimensions, node, nameOf(parameter), int{to.dimensions}, given);
  }
  expressions_.reportWrongType(node, parameter.type, found);
}

}  // namespace cobot_command::rapid
