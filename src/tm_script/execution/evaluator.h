// Runs one statement.
//
// A statement that has to wait is run again from its start later. So that nothing happens twice, its changes
// of variables come into force only at its end, and what the robot has answered once is not asked again.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "execution/typing.h"

#include "cobot_command/common/result.h"
#include "cobot_command/tm_script/interpreter.h"

namespace cobot_command::tm_script {

/// Bytes that one line may handle, each value counted whenever it is handed on: ours, so that a line ends
/// soon.
inline constexpr std::size_t kMaxLineWork = std::size_t{64} << 20;

/// Why a statement does not go on.
struct Stop {
  bool waits = false;
  std::string reason;  ///< unless it waits
};

[[nodiscard]] inline tl::unexpected<Stop> fault(std::string reason) {
  return refuse(Stop{false, std::move(reason)});
}

class Evaluator {
 public:
  /// The robot's answers are taken from `answers` as long as there are some; new ones are added.
  Evaluator(const FunctionTable& functions, Scope scope, Environment& robot, std::vector<Answer>& answers);

  /// Afterwards, true when the script ends here.
  [[nodiscard]] Result<bool, Stop> run(const Statement& statement);

 private:
  using Evaluated = Result<Value, Stop>;
  /// A place to change, with what stands there now: the whole of an array also where one element is the
  /// target.
  struct Target {
    std::string variable;  ///< empty: an attribute
    AttributeName attribute;
    AttributeShape shape;
    std::optional<std::size_t> index;
    std::optional<Value> whole;  ///< of an attribute: only when something has asked for it
  };

  [[nodiscard]] Evaluated valueOf(const Expression& expression);
  [[nodiscard]] Evaluated of(const Literal& literal);
  [[nodiscard]] Evaluated of(const Name& name);
  [[nodiscard]] Evaluated of(const ArrayLiteral& array);
  [[nodiscard]] Evaluated of(const Call& call);
  [[nodiscard]] Evaluated of(const Attribute& attribute);
  [[nodiscard]] Evaluated of(const Element& element);
  [[nodiscard]] Evaluated of(const Prefix& prefix);
  [[nodiscard]] Evaluated of(const Postfix& postfix);
  [[nodiscard]] Evaluated of(const Chain& chain);
  [[nodiscard]] Evaluated of(const Conditional& conditional);
  [[nodiscard]] Evaluated of(const Assignment& assignment);

  [[nodiscard]] Result<Arguments, Stop> argumentsOf(const Call& call);
  [[nodiscard]] Evaluated callRobot(const std::string& function, const Arguments& arguments);
  [[nodiscard]] Result<AttributeName, Stop> nameOf(const Attribute& attribute);
  [[nodiscard]] Evaluated readAttribute(const AttributeName& name);
  [[nodiscard]] Result<std::size_t, Stop> indexOf(const Expression& index, std::size_t size);
  [[nodiscard]] Result<std::size_t, Stop> sizeOfTarget(Target& target);
  [[nodiscard]] Result<Target, Stop> targetOf(const Expression& expression);
  [[nodiscard]] Evaluated readTarget(Target& target);
  [[nodiscard]] Evaluated assign(Target target, const Value& value, const Expression* source = nullptr);
  [[nodiscard]] Evaluated writeAttribute(const Target& target, const Value& value);
  /// Adds 1 or -1, and gives the value before or after.
  [[nodiscard]] Evaluated step(const Expression& expression, int by, bool gives_old);
  [[nodiscard]] const Value* find(const std::string& name) const;

  /// The answer that is known already.
  [[nodiscard]] std::optional<Value> known();
  Value remember(Value value, bool ends_script);

  const FunctionTable& functions_;
  Scope scope_;
  Environment& robot_;
  std::vector<Answer>& answers_;
  std::size_t next_answer_ = 0;
  bool ends_script_ = false;
  std::size_t work_ = 0;
  std::map<std::string, Value> changed_;
  Typing typing_;
};

}  // namespace cobot_command::tm_script
