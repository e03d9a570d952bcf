#include "routines/routine_check.h"

#include <cmath>
#include <utility>

#include "type_reference.h"

namespace cobot_command::rapid {

namespace {

constexpr int kMostErrorNumber = 90;
/// The predefined procedures that nothing follows.
constexpr std::string_view kExitCycle = "ExitCycle";

}  // namespace

void RoutineCheck::check(SymbolIndex routine) {
  routine_ = routine;
  is_uncertain_ = false;
  scope_.enter(routine);
  const NodeIndex node = draft_.symbol(routine).node;
  has_error_handler_ = false;
  for (const NodeIndex child : file_.tree().children(node)) {
    if (file_[child].kind == NodeKind::Handler && file_[child].word == TokenKind::Error) {
      has_error_handler_ = true;
    }
  }
  for (const NodeIndex child : file_.tree().children(node)) {
    if (file_[child].kind == NodeKind::Handler) handler(child);
    if (file_[child].kind != NodeKind::List) continue;
    handler_ = TokenKind::End;
    reach_ = Reach::Open;
    list(child);
    const bool is_function = draft_.symbol(routine).kind == SymbolKind::Function;
    const bool has_open_end = is_function && reach_ == Reach::Open && !is_uncertain_;
    if (has_open_end && file_.isName(file_[node].name)) {
      file_.report(kinds::kEndOfFunction, file_[node].name, file_.quotedAt(file_[node].name));
    }
  }
}

void RoutineCheck::handler(NodeIndex node) {
  handler_ = file_[node].word;
  reach_ = Reach::Open;
  for (const NodeIndex child : file_.tree().children(node)) {
    if (file_[child].kind == NodeKind::List) list(child);
    if (file_[child].kind != NodeKind::ErrorNumbers || file_[node].has(Node::Faulty)) continue;
    for (const NodeIndex number : file_.tree().children(child)) expressions_.expect(number, kNum);
  }
}

void RoutineCheck::list(NodeIndex node) {
  blocks_.push_back(node);
  for (const NodeIndex child : file_.tree().children(node)) instruction(child);
  blocks_.pop_back();
}

/// Reports the first instruction that nothing reaches.
void RoutineCheck::mark(NodeIndex node) {
  if (reach_ != Reach::Closed) return;
  reach_ = Reach::Reported;
  if (!file_[node].has(Node::Faulty)) file_.report(kinds::kUnreachable, file_[node].first);
}

void RoutineCheck::instruction(NodeIndex node) {
  file_.countStep();
  const NodeKind kind = file_[node].kind;
  if (kind == NodeKind::Label) {
    reach_ = Reach::Open;
    return;
  }
  if (kind == NodeKind::Data) {
    const SymbolIndex symbol = file_.at(node).symbol;
    if (symbol != kNoSymbol) data_.declare(symbol, false);
    return;
  }
  mark(node);
  switch (kind) {
    case NodeKind::If:
    case NodeKind::CompactIf:
      return ifInstruction(node);
    case NodeKind::For:
      return forInstruction(node);
    case NodeKind::While:
      return whileInstruction(node);
    case NodeKind::Test:
      return testInstruction(node);
    case NodeKind::Unread:
      is_uncertain_ = true;
      reach_ = Reach::Open;
      return;
    default:
      return simpleInstruction(node);
  }
}

void RoutineCheck::simpleInstruction(NodeIndex node) {
  const bool is_faulty = file_[node].has(Node::Faulty);
  switch (file_[node].kind) {
    case NodeKind::Assignment:
      return is_faulty ? void() : assignment(node);
    case NodeKind::Call:
      return is_faulty ? void() : call(node);
    case NodeKind::LateCall:
      return is_faulty ? void() : lateCall(node);
    case NodeKind::Connect:
      return is_faulty ? void() : connect(node);
    case NodeKind::Goto:
      if (!is_faulty) scope_.bindGoto(node, blocks_);
      break;
    case NodeKind::Return:
      if (!is_faulty) returnInstruction(node);
      break;
    case NodeKind::Raise:
      if (!is_faulty) raise(node);
      // TRYNEXT of the handler continues after it.
      if (handler_ == TokenKind::End && has_error_handler_) return;
      break;
    case NodeKind::Retry:
    case NodeKind::Trynext:
      if (!is_faulty) requireHandler(node);
      break;
    case NodeKind::Exit:
      break;
    default:
      return;
  }
  reach_ = closed(reach_);
}

void RoutineCheck::assignment(NodeIndex node) {
  const NodeIndex target = file_[node].child;
  const NodeIndex value = file_[target].next;
  const TypeIndex type = expressions_.target(target);
  if (type == kNoType) {
    expressions_.check(value, kNoType);
  } else {
    expressions_.expect(value, type);
  }
}

bool RoutineCheck::isPassedOver(TokenIndex name) {
  auto& skipped = draft_.skipped;
  const auto found = skipped.find(std::string(file_.foldedAt(name)));
  if (found == skipped.end()) return false;
  if (!std::exchange(found->second, true)) file_.report(kinds::kPassedOver, name, file_.quotedAt(name));
  return true;
}

void RoutineCheck::call(NodeIndex node) {
  const TokenIndex name = file_[node].name;
  if (!file_.isName(name)) return;
  const SymbolIndex visible = names_.find(name);
  const bool is_known = visible != kNoSymbol && draft_.symbol(visible).kind != SymbolKind::Refused &&
                        !draft_.symbol(visible).has(Symbol::NotBuilt);
  if (!is_known && isPassedOver(name)) return;
  const SymbolIndex found = expressions_.bind(name, kinds::kNoProcedure, Meant::Procedure);
  if (found != kNoSymbol) procedure(node, found);
}

void RoutineCheck::procedure(NodeIndex node, SymbolIndex found) {
  const TokenIndex name = file_[node].name;
  const Symbol symbol = draft_.symbol(found);
  switch (symbol.kind) {
    case SymbolKind::Trap:
      return file_.report(kinds::kTrapCalled, name);
    case SymbolKind::Function:
      if (symbol.has(Symbol::NotBuilt)) return reportRefused(file_, name, symbol);
      return file_.report(kinds::kFunctionCalled, name, file_.quotedAt(name));
    case SymbolKind::Procedure:
      break;
    default:
      return expressions_.reportWrongKind(name, symbol, "a procedure");
  }
  if (symbol.has(Symbol::NotBuilt)) return reportRefused(file_, name, symbol);
  file_.at(node).symbol = found;
  calls_.check(node, found);
  if (symbol.file < kPredefinedFiles && symbol.name == kExitCycle) reach_ = closed(reach_);
}

void RoutineCheck::lateCall(NodeIndex node) {
  bool is_name = true;
  for (const NodeIndex child : file_.tree().children(node)) {
    const NodeIndex value = file_[child].kind == NodeKind::Argument ? file_[child].child : child;
    if (is_name) {
      expressions_.expect(value, kString);
    } else if (value != kNoNode && !file_[child].has(Node::Conditional)) {
      expressions_.check(value);
    }
    is_name = false;
  }
}

void RoutineCheck::connect(NodeIndex node) {
  const NodeIndex reference = file_[node].child;
  const TypeIndex type = expressions_.target(reference);
  if (type != kNoType && type != kNum) expressions_.reportWrongType(reference, kNum, type);
  const SymbolIndex variable = file_.at(reference).symbol;
  if (type == kNum && variable != kNoSymbol) {
    const Symbol& symbol = draft_.symbol(variable);
    const bool is_of_routine = symbol.kind == SymbolKind::Data && symbol.owner == routine_;
    if (symbol.word == TokenKind::Pers) {
      file_.reportNode(kinds::kArgumentForm, reference, "CONNECT", "a variable");
    } else if (is_of_routine) {
      file_.report(kinds::kInterruptOfRoutine, file_[reference].name);
    }
  }
  const TokenIndex name = file_[node].name;
  if (!file_.isName(name)) return;
  const SymbolIndex trap = expressions_.bind(name, kinds::kNotDeclared, Meant::Trap);
  if (trap == kNoSymbol) return;
  file_.at(node).symbol = trap;
  if (draft_.symbol(trap).kind != SymbolKind::Trap) file_.report(kinds::kNoTrap, name, file_.quotedAt(name));
}

void RoutineCheck::returnInstruction(NodeIndex node) {
  const Symbol routine = draft_.symbol(routine_);
  const NodeIndex value = file_[node].child;
  if (routine.kind != SymbolKind::Function) {
    if (value != kNoNode) file_.reportNode(kinds::kValueReturned, value);
  } else if (value == kNoNode) {
    file_.report(kinds::kNoValueReturned, file_[node].first);
  } else {
    expressions_.expect(value, routine.type);
  }
}

void RoutineCheck::raise(NodeIndex node) {
  const NodeIndex number = file_[node].child;
  const bool is_handler = handler_ == TokenKind::Error;
  if (number == kNoNode) {
    if (!is_handler) file_.report(kinds::kNoErrorNumber, file_[node].first);
    return;
  }
  if (is_handler) return file_.reportNode(kinds::kNumberInHandler, number);
  const Typed typed = expressions_.expect(number, kNum);
  const Cell* const value = typed.type == kNum ? expressions_.valueOf(typed) : nullptr;
  if (value == nullptr) return;
  const bool is_allowed = *value >= 1 && *value <= kMostErrorNumber && *value == std::trunc(*value);
  if (is_allowed) return;
  const Span span = file_.source().spanOf(number);
  const std::string_view written = file_.source().text().substr(span.begin, span.end - span.begin);
  file_.reportNode(kinds::kErrorNumber, number, quoted(written));
}

void RoutineCheck::requireHandler(NodeIndex node) {
  if (handler_ == TokenKind::Error) return;
  const bool is_retry = file_[node].kind == NodeKind::Retry;
  file_.report(kinds::kOutsideHandler, file_[node].first, is_retry ? "RETRY" : "TRYNEXT");
}

}  // namespace cobot_command::rapid
