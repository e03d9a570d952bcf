// What a script can reach outside of itself: attributes of objects, and functions of a robot. The user of the
// room implements it.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "cobot_command/common/result.h"
#include "cobot_command/tm_script/functions.h"
#include "cobot_command/tm_script/value.h"

namespace cobot_command::tm_script {

/// IO["ControlBox"].DO: object, keys (numbers or texts) and name.
struct AttributeName {
  std::string object;
  std::vector<Scalar> keys;
  std::string name;
};

struct AttributeShape {
  Type type;
  bool is_writable = false;
  std::optional<std::size_t> length;       ///< of an array whose length never changes
  std::optional<int> most = std::nullopt;  ///< an integer that is written must be 0 to this
};

/// The robot is not done: the script stands at this line until Interpreter::resume().
struct Wait {};
/// The call is done, and nothing behind its line is run: ScriptExit().
struct EndScript {
  Value result;
};
struct CallFailure {
  std::string reason;
};
using CallAnswer = std::variant<Value, Wait, EndScript, CallFailure>;

class Environment {
 public:
  virtual ~Environment() = default;

  /// Before a script runs: is there such an attribute? A key is absent when it is not written as a literal.
  /// The error says what there is instead.
  [[nodiscard]] virtual Result<AttributeShape, std::string> shapeOf(
      const std::string& object, const std::vector<std::optional<Scalar>>& keys,
      const std::string& name) const = 0;

  /// Before a script runs: what is wrong with this call of a declared function? An argument is absent when it
  /// is not written as a literal. Nothing when it is right as far as one can see.
  [[nodiscard]] virtual std::optional<std::string> objectionTo(
      const std::string& function, const std::vector<std::optional<Scalar>>& arguments) const = 0;

  /// A value of the type of the attribute's shape.
  [[nodiscard]] virtual Result<Value, std::string> read(const AttributeName& attribute) = 0;

  /// One element when an index is given, otherwise all of it. The value has the type of the attribute, or of
  /// its elements; the index is not negative, and below the length of the shape. Called for writable items
  /// only. An error ends the script.
  [[nodiscard]] virtual std::optional<std::string> write(const AttributeName& attribute,
                                                         std::optional<std::size_t> index,
                                                         const Value& value) = 0;

  /// A declared function. The arguments have the types of the parameters. A Value must have the declared
  /// type.
  [[nodiscard]] virtual CallAnswer call(const std::string& function, const Arguments& arguments) = 0;
};

}  // namespace cobot_command::tm_script
