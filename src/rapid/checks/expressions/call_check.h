// Arguments of calls of procedures and functions.
#pragma once

#include <string>
#include <vector>

#include "expressions/expression_check.h"

namespace cobot_command::rapid {

class CallCheck {
 public:
  explicit CallCheck(ExpressionCheck& expressions)
      : expressions_(expressions), file_(expressions.file()), draft_(file_.draft()) {}

  /// The arguments of a Call or Function of `routine`. Reports E503 to E513 and what expressions report.
  void check(NodeIndex call, SymbolIndex routine);

 private:
  struct Progress {
    std::uint32_t next = 0;  ///< parameter of the next required argument
    SymbolIndex last_option = kNoSymbol;
    std::vector<std::uint8_t> given;  ///< by parameter
  };

  [[nodiscard]] const Symbol& parameter(std::uint32_t position) const {
    return draft_.symbol(routine_.first_parameter + position);
  }
  [[nodiscard]] std::string nameOf(const Symbol& parameter) const { return quoted(parameter.name); }
  [[nodiscard]] SymbolIndex parameterNamed(TokenIndex name);
  [[nodiscard]] std::string nearestOption(TokenIndex name) const;

  bool required(NodeIndex argument, Progress& progress);
  void option(NodeIndex argument, Progress& progress);
  void checkOrder(TokenIndex name, SymbolIndex option, Progress& progress);
  void optionValue(NodeIndex argument, const Symbol& parameter);
  void passedOn(NodeIndex reference, const Symbol& parameter);
  void requireAll(NodeIndex call, const Progress& progress);

  void value(NodeIndex node, const Symbol& parameter);
  void byValue(NodeIndex node, const Symbol& parameter);
  void byReference(NodeIndex node, const Symbol& parameter);
  void byName(NodeIndex node, const Symbol& parameter);
  [[nodiscard]] bool canBeReferred(NodeIndex node, const Referred& referred, const Symbol& parameter);
  void requireType(NodeIndex node, TypeIndex found, const Symbol& parameter);

  ExpressionCheck& expressions_;
  FileDraft& file_;
  Draft& draft_;
  Symbol routine_;
  bool takes_names_ = false;
  NameMap parameters_;  // of routine_, if it has many
  SymbolIndex parameters_of_ = kNoSymbol;
};

}  // namespace cobot_command::rapid
