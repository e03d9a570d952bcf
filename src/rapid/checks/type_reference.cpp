#include "type_reference.h"

#include "cobot_command/rapid/types/predefined.h"

namespace cobot_command::rapid {

namespace {

bool isPredefined(const FileDraft& file) {
  return file.file() < kPredefinedFiles;
}

}  // namespace

bool isSignalType(const Type& type) {
  constexpr std::string_view kPrefix = "signal";
  const bool is_atomic = type.kind == TypeKind::NonValue || type.kind == TypeKind::SemiValue;
  return is_atomic && type.name.substr(0, kPrefix.size()) == kPrefix;
}

void reportRefused(FileDraft& file, TokenIndex name, const Symbol& symbol) {
  if (symbol.kind == SymbolKind::Refused) {
    const Refusal& refusal = refusals()[symbol.index];
    return file.report(kinds::kNotSupported, name, file.quotedAt(name), refusal.reason, refusal.way_around);
  }
  file.report(kinds::kNotSupported, name, file.quotedAt(name), "not built yet",
              "--skip passes over a call of an instruction");
}

TypeIndex typeNamed(FileDraft& file, Names& names, NodeIndex type_name) {
  const TokenIndex name = file[type_name].name;
  if (!file.isName(name)) return kNoType;
  const SymbolIndex found = names.findType(name);
  if (found == kNoSymbol) {
    file.reportNear(kinds::kNoDataType, name, names.nearest(name, Meant::Type));
    return kNoType;
  }
  const Symbol& symbol = file.draft().symbol(found);
  file.at(type_name) = {found, symbol.type, kNoConstant};
  if (symbol.kind == SymbolKind::Refused) {
    reportRefused(file, name, symbol);
  } else if (symbol.type == kAnytype && !isPredefined(file)) {
    file.reportNear(kinds::kNoDataType, name, {});
    return kNoType;
  }
  return symbol.type;
}

TypeIndex typeOfData(FileDraft& file, Names& names, NodeIndex data) {
  const NodeIndex node = file.tree().childOf(data, NodeKind::TypeName);
  const TypeIndex type = node == kNoNode ? kNoType : typeNamed(file, names, node);
  if (type == kNoType) return kNoType;
  const TokenIndex name = file[node].name;
  const Type& at = file.draft().types()[type];
  const TokenKind word = file[data].word;
  if (type == kSwitch) {
    file.report(kinds::kSwitchParameter, name);
  } else if (isSignalType(at)) {
    file.report(kinds::kNeverDeclared, name, at.name, "declared");
  } else if (!at.has_values && word != TokenKind::Var) {
    file.report(kinds::kNeverDeclared, name, quoted(at.name), toString(word));
  } else {
    return type;
  }
  return kNoType;
}

TypeIndex typeOfParameter(FileDraft& file, Names& names, NodeIndex parameter) {
  const NodeIndex node = file.tree().childOf(parameter, NodeKind::TypeName);
  const TypeIndex type = node == kNoNode ? kNoType : typeNamed(file, names, node);
  if (type == kNoType || isPredefined(file)) return type;
  const Type& at = file.draft().types()[type];
  const Node& node_of = file[parameter];
  if (type == kSwitch) {
    if (!node_of.has(Node::Optional)) file.report(kinds::kSwitchParameter, file[node].name);
  } else if (!at.has_values && node_of.word != TokenKind::Var && file.isName(node_of.name)) {
    file.report(kinds::kNoValues, node_of.name, quoted(at.name));
  }
  return type;
}

}  // namespace cobot_command::rapid
