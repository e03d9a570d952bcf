// Types and values of expressions.
#pragma once

#include <limits>
#include <string>

#include "draft.h"
#include "names.h"

namespace cobot_command::rapid {

/// It is unknown what an aggregate is used as.
inline constexpr TypeIndex kNoContext = std::numeric_limits<TypeIndex>::max();

struct Typed {
  TypeIndex type = kNoType;
  ConstantIndex constant = kNoConstant;
};

/// Data that a Reference stands for, or a part of it.
struct Referred {
  SymbolIndex symbol = kNoSymbol;  ///< kNoSymbol after a finding
  TypeIndex type = kNoType;
  ConstantIndex constant = kNoConstant;
  bool is_whole = true;  ///< no index, no component
};

class ExpressionCheck {
 public:
  ExpressionCheck(FileDraft& file, Names& names) : file_(file), names_(names), draft_(file.draft()) {}

  [[nodiscard]] FileDraft& file() const { return file_; }
  [[nodiscard]] Names& names() const { return names_; }

  /// `context`: what an aggregate is used as; kNoContext: unknown (E406); kNoType: unknown because of an
  /// error.
  Typed check(NodeIndex node, TypeIndex context = kNoContext);
  /// Reports E404 if the type does not fit.
  Typed expect(NodeIndex node, TypeIndex type);
  /// Reports E405.
  void condition(NodeIndex node);
  /// A Reference to data. `context`: a type of signals makes E419 of an unknown name.
  Referred refer(NodeIndex reference, TypeIndex context = kNoContext);
  /// The type of what is assigned to; kNoType after a finding (E411, E412, E401 ...).
  TypeIndex target(NodeIndex reference);

  /// `found` can be used where `wanted` is needed.
  [[nodiscard]] bool fits(TypeIndex found, TypeIndex wanted) const;
  /// Of a num that is constant.
  [[nodiscard]] const Cell* valueOf(const Typed& typed) const {
    return typed.constant == kNoConstant ? nullptr : draft_.cells(typed.constant);
  }
  /// What a name stands for. Reports and returns kNoSymbol if it means nothing, or nothing of dialect s4c.
  SymbolIndex bind(TokenIndex name, const FindingKind& unknown, Meant meant);
  void reportWrongKind(TokenIndex name, const Symbol& symbol, std::string_view wanted);
  void reportWrongType(NodeIndex node, TypeIndex wanted, TypeIndex found);

 private:
  Typed checkKind(NodeIndex node, TypeIndex context);
  Typed number(NodeIndex node);
  Typed text(NodeIndex node);
  Typed value(TypeIndex type, Cell cell);
  Typed reference(NodeIndex node, TypeIndex context);
  Typed function(NodeIndex node);
  Typed sign(NodeIndex node, TypeIndex context);
  Typed negation(NodeIndex node);

  Typed aggregate(NodeIndex node, TypeIndex context);
  Typed parts(NodeIndex node, TypeIndex type, std::uint32_t count);
  [[nodiscard]] TypeIndex partType(TypeIndex type, std::uint32_t position);
  [[nodiscard]] TypeIndex sizedBy(NodeIndex aggregate, TypeIndex conformant);
  Typed leaveOpen(NodeIndex aggregate);
  ConstantIndex joined(NodeIndex aggregate, std::uint32_t cells, ConstantIndex last);
  void checkQuaternion(NodeIndex node, ConstantIndex constant);

  Typed chain(NodeIndex node);
  Typed operation(NodeIndex operation, const Typed& left, const Typed& right);
  Typed relation(NodeIndex operation, const Typed& left, const Typed& right);
  void warnOfDivision(NodeIndex operation, const Typed& left, const Typed& right);

  void select(Referred& referred, NodeIndex reference);
  void index(Referred& referred, NodeIndex reference, NodeIndex index);
  void component(Referred& referred, NodeIndex part);

  FileDraft& file_;
  Names& names_;
  Draft& draft_;
};

}  // namespace cobot_command::rapid
