// The types of expressions: what the checker finds wrong with them, and what the evaluator needs to know.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cobot_command/common/result.h"
#include "cobot_command/tm_script/environment.h"
#include "cobot_command/tm_script/functions.h"
#include "cobot_command/tm_script/script.h"

namespace cobot_command::tm_script {

/// The type of a variable; nothing when there is none.
using TypeOfName = std::function<std::optional<Type>(const std::string&)>;

/// Looks at each part of an expression once: parts nest, so looking twice would take exponential time.
class Typing {
 public:
  Typing(const FunctionTable& functions, const Environment& environment, TypeOfName type_of_name)
      : functions_(functions), environment_(environment), type_of_name_(std::move(type_of_name)) {}

  /// The type of a value. The error is what a static check finds.
  [[nodiscard]] Result<Type, std::string> typeOf(const Expression& expression);
  /// Can it be put where a value of this type is wanted? Nothing when it can.
  [[nodiscard]] std::optional<std::string> accept(const Expression& expression, Type wanted);
  /// What the form of a call is, with the types of its arguments.
  [[nodiscard]] Result<Match, std::string> match(const Call& call);
  [[nodiscard]] Result<AttributeShape, std::string> shapeOf(const Attribute& attribute);

  /// All warnings so far, which are then forgotten.
  [[nodiscard]] std::vector<std::string> takeWarnings() { return std::exchange(warnings_, {}); }

 private:
  using Typed = Result<Type, std::string>;

  [[nodiscard]] Typed of(const Literal& literal);
  [[nodiscard]] Typed of(const Name& name);
  [[nodiscard]] Typed of(const ArrayLiteral& array);
  [[nodiscard]] Typed of(const Call& call);
  [[nodiscard]] Typed of(const Attribute& attribute);
  [[nodiscard]] Typed of(const Element& element);
  [[nodiscard]] Typed of(const Prefix& prefix);
  [[nodiscard]] Typed of(const Postfix& postfix);
  [[nodiscard]] Typed of(const Chain& chain);
  [[nodiscard]] Typed of(const Conditional& conditional);
  [[nodiscard]] Typed of(const Assignment& assignment);
  [[nodiscard]] Result<AttributeShape, std::string> targetShape(const Expression& target);
  [[nodiscard]] Typed valueFor(const AttributeShape& target, const Assignment& assignment);
  [[nodiscard]] Typed stepped(const Expression& target, const char* step);
  [[nodiscard]] Typed commonOf(const Expressions& expressions);
  [[nodiscard]] bool isBareWord(const Expression& expression) const;
  void warnOfQuotes(const Expression& bare_word);

  const FunctionTable& functions_;
  const Environment& environment_;
  TypeOfName type_of_name_;
  std::vector<std::string> warnings_;
};

}  // namespace cobot_command::tm_script
