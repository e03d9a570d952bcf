#include "printer/declarations.h"

namespace cobot_command::rapid {

namespace {

bool isType(NodeKind kind) {
  return kind == NodeKind::Record || kind == NodeKind::Alias;
}

/// More parameters or components are not searched: two long lists would take quadratic time.
constexpr int kMostParts = 256;

}  // namespace

Declarations::Declarations(const Source& source, const PredefinedNames& predefined)
    : source_(source),
      predefined_(predefined),
      file_(source.names().size()),
      file_types_(source.names().size()),
      module_(source.names().size()),
      module_types_(source.names().size()),
      routine_(source.names().size()),
      labels_(source.names().size()) {
  const Tree& tree = source.tree();
  for (const NodeIndex module : tree.children(Tree::kRoot)) {
    for (const NodeIndex node : tree.children(module)) {
      if (!tree[node].has(Node::Local)) declare(file_, file_types_, node);
    }
  }
}

bool Declarations::isName(TokenIndex token) const {
  return token != kNoToken && source_.tokens()[token].kind == TokenKind::Name;
}

void Declarations::declare(Scope& names, Scope& types, NodeIndex node) {
  const Node& declaration = source_.tree()[node];
  if (isName(declaration.name)) {
    (isType(declaration.kind) ? types : names).declare(nameOf(declaration.name), node);
  }
}

void Declarations::enterModule(NodeIndex module) {
  module_.clear();
  module_types_.clear();
  for (const NodeIndex node : source_.tree().children(module)) declare(module_, module_types_, node);
}

void Declarations::enterRoutine(NodeIndex routine) {
  routine_.clear();
  labels_.clear();
  const Tree& tree = source_.tree();
  for (const NodeIndex part : tree.children(routine)) {
    const NodeKind kind = tree[part].kind;
    if (kind == NodeKind::Parameters) {
      for (const NodeIndex parameter : tree.children(part)) declare(routine_, module_types_, parameter);
    } else if (kind == NodeKind::List) {
      declareList(part);
    } else if (kind == NodeKind::Handler) {
      declareList(tree.childOf(part, NodeKind::List));
    }
  }
}

/// Data and labels, also of the lists within.
void Declarations::declareList(NodeIndex list) {
  const Tree& tree = source_.tree();
  for (const NodeIndex node : tree.children(list)) {
    const NodeKind kind = tree[node].kind;
    if (kind == NodeKind::Data) declare(routine_, module_types_, node);
    if (kind == NodeKind::Label) declare(labels_, module_types_, node);
    if (containsInstructions(kind)) declareList(node);
  }
}

NodeIndex Declarations::enterFor(NodeIndex loop) {
  const TokenIndex name = source_.tree()[loop].name;
  return isName(name) ? routine_.replace(nameOf(name), loop) : kNoNode;
}

void Declarations::leaveFor(NodeIndex loop, NodeIndex hidden) {
  const TokenIndex name = source_.tree()[loop].name;
  if (isName(name)) static_cast<void>(routine_.replace(nameOf(name), hidden));
}

DeclaredName Declarations::declared(NodeIndex node) const {
  return {source_.textOf(source_.tree()[node].name), &source_, node};
}

DeclaredName Declarations::find(TokenIndex name) const {
  if (!isName(name)) return {};
  for (const Scope* scope : {&routine_, &module_, &file_}) {
    const NodeIndex node = scope->find(nameOf(name));
    if (node != kNoNode) return declared(node);
  }
  return predefined_.find(source_.names().folded(nameOf(name)));
}

DeclaredName Declarations::findType(TokenIndex name) const {
  if (!isName(name)) return {};
  for (const Scope* scope : {&module_types_, &file_types_}) {
    const NodeIndex node = scope->find(nameOf(name));
    if (node != kNoNode) return declared(node);
  }
  return predefined_.findType(source_.names().folded(nameOf(name)));
}

DeclaredName Declarations::findLabel(TokenIndex name) const {
  const NodeIndex node = isName(name) ? labels_.find(nameOf(name)) : kNoNode;
  return node == kNoNode ? DeclaredName{} : declared(node);
}

DeclaredName Declarations::findPart(const DeclaredName& whole, TokenIndex name) const {
  if (whole.source == nullptr || !isName(name)) return {};
  const Tree& tree = whole.source->tree();
  const bool is_routine = tree[whole.node].kind == NodeKind::Routine;
  const NodeIndex list = is_routine ? tree.childOf(whole.node, NodeKind::Parameters) : whole.node;
  if (list == kNoNode) return {};
  const std::string_view folded = source_.names().folded(nameOf(name));
  int searched = 0;
  for (const NodeIndex part : tree.children(list)) {
    if (++searched > kMostParts) break;
    if (whole.source->nameOf(part) == folded) {
      return {whole.source->textOf(tree[part].name), whole.source, part};
    }
  }
  return {};
}

DeclaredName Declarations::typeOf(const DeclaredName& data) const {
  if (data.source == nullptr) return {};
  const NodeIndex type = data.source->tree().childOf(data.node, NodeKind::TypeName);
  if (type == kNoNode) return {};
  if (data.source == &source_) return findType(source_.tree()[type].name);
  return predefined_.findType(data.source->nameOf(type));
}

DeclaredName Declarations::recordOf(const DeclaredName& data) const {
  DeclaredName type = typeOf(data);
  constexpr int kLongestChain = 16;  // of aliases; one that is its own never ends
  for (int step = 0; step < kLongestChain && type.source != nullptr; ++step) {
    if (type.source->tree()[type.node].kind == NodeKind::Record) return type;
    type = typeOf(type);
  }
  return {};
}

}  // namespace cobot_command::rapid
