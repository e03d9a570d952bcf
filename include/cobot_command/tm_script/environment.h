// The interface of a script to its environment: attributes of objects, and functions of a robot. The user of
// this room implements it.
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
  std::optional<std::size_t> length;       ///< of an array with a fixed length
  std::optional<int> most = std::nullopt;  ///< a written integer must be 0 to this
};

/// The robot has not finished: the script waits at this line until Interpreter::resume().
struct Wait {};
/// The call is done, and no line after it is run: ScriptExit().
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

  /// Called before a script runs: the shape of the attribute, if it exists. A key is absent if it is not a
  /// literal. The error names the existing attributes.
  [[nodiscard]] virtual Result<AttributeShape, std::string> shapeOf(
      const std::string& object, const std::vector<std::optional<Scalar>>& keys,
      const std::string& name) const = 0;

  /// Called before a script runs: the error of a call of a declared function. An argument is absent if it is
  /// not a literal. std::nullopt if no error is found.
  [[nodiscard]] virtual std::optional<std::string> objectionTo(
      const std::string& function, const std::vector<std::optional<Scalar>>& arguments) const = 0;

  /// Returns a value of the type of the attribute's shape.
  [[nodiscard]] virtual Result<Value, std::string> read(const AttributeName& attribute) = 0;

  /// Writes one element if an index is given, otherwise the whole attribute. The value has the type of the
  /// attribute or of its elements. The index is not negative, and below the length of the shape. Only called
  /// for writable attributes. An error ends the script.
  [[nodiscard]] virtual std::optional<std::string> write(const AttributeName& attribute,
                                                         std::optional<std::size_t> index,
                                                         const Value& value) = 0;

  /// Calls a declared function. The arguments have the types of the parameters. A returned Value must have
  /// the declared type.
  [[nodiscard]] virtual CallAnswer call(const std::string& function, const Arguments& arguments) = 0;
};

}  // namespace cobot_command::tm_script
