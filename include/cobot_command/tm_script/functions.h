// The functions that a script may call: the general ones of the language, which this room computes, and those
// of the robot, which the user of the room declares and answers.
//
// A declaration reads as in the manual:
//
//   bool PTP(string, 6 double, int, int, int, bool)    six numbers of their own
//   bool PTP(string, double[6], int, int, int, bool)   an array of exactly six
//   bool QueueTag(int, int?)                           ? may be left out, with all behind it
//   bool StopAndClearBuffer(literal int)               no variable or expression
//   any[] Array_Append(any[], element)                 any: of any type; number: any number; element: of the
//   type of
//                                                      the first argument's elements; as a result, any means
//                                                      the type of the first argument
#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/common/result.h"
#include "cobot_command/tm_script/value.h"

namespace cobot_command::tm_script {

/// Of TMflow: {1, 80}
struct Version {
  int major = 1;
  int minor = 80;

  friend bool operator<(Version a, Version b) {
    return a.major != b.major ? a.major < b.major : a.minor < b.minor;
  }
};

using Arguments = std::vector<Value>;
/// Computes a general function. The arguments have been converted to the types of the parameters.
using Builtin = std::function<Result<Value, std::string>(const Arguments&)>;

struct Parameter {
  enum class Kind { Fixed, Any, Number, Element };
  Kind kind = Kind::Fixed;
  Type type;               ///< of a Fixed one; of the others only is_array counts
  std::size_t length = 0;  ///< elements that the array must have; 0: any number
  bool is_literal = false;
};

struct Function {
  std::string name;
  Parameter result;
  std::vector<Parameter> parameters;
  std::size_t required = 0;  ///< parameters that cannot be left out
  Version since;
  Builtin compute;  ///< nothing: the robot answers
};

/// The function that a call means.
struct Match {
  const Function* function = nullptr;
  std::vector<Type> arguments;  ///< what each is to be converted to
  Type result;
  bool is_warned = false;  ///< for a conversion of an argument
};

/// Not copied while a checker or an interpreter uses it.
class FunctionTable {
 public:
  /// The general functions that this version of TMflow has.
  explicit FunctionTable(Version tmflow = {});

  /// Adds a function of the robot, or another form of one. Precondition: a declaration as above.
  void declare(std::string_view declaration, Version since);
  /// Adds a general function.
  void define(std::string_view declaration, Version since, Builtin compute);

  /// The form with the best conversions. The error names what is wrong: an unknown function, one that the
  /// simulation or the version does not have, or arguments that no form takes.
  [[nodiscard]] Result<Match, std::string> find(const std::string& name,
                                                const std::vector<Type>& arguments) const;

  /// In any form, of any version.
  [[nodiscard]] bool has(std::string_view name) const { return functions_.find(name) != functions_.end(); }

 private:
  Version tmflow_;
  std::map<std::string, std::vector<Function>, std::less<>> functions_;
};

}  // namespace cobot_command::tm_script
