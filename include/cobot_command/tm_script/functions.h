// The functions that a script may call: the general functions of the language, which this room computes, and
// those of the robot, which the user of the room declares and implements.
//
// A declaration is written as in the manual:
//
//   bool PTP(string, 6 double, int, int, int, bool)    six separate numbers
//   bool PTP(string, double[6], int, int, int, bool)   an array of exactly six
//   bool QueueTag(int, int?)                           ?: optional, with all parameters after it
//   bool StopAndClearBuffer(literal int)               no variable or expression
//   any[] Array_Append(any[], element)                 any: of any type; number: any number;
//                                                      element: of the type of the first argument's
//                                                      elements; as a result, any means the type of
//                                                      the first argument
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

/// Version of TMflow: {1, 80}
struct Version {
  int major = 1;
  int minor = 80;

  friend bool operator<(Version a, Version b) {
    return a.major != b.major ? a.major < b.major : a.minor < b.minor;
  }
};

using Arguments = std::vector<Value>;
/// Computes a general function. The arguments are already converted to the types of the parameters.
using Builtin = std::function<Result<Value, std::string>(const Arguments&)>;

struct Parameter {
  enum class Kind { Fixed, Any, Number, Element };
  Kind kind = Kind::Fixed;
  Type type;               ///< of a Fixed parameter; for the others only is_array is used
  std::size_t length = 0;  ///< required number of elements of the array; 0: any
  bool is_literal = false;
};

struct Function {
  std::string name;
  Parameter result;
  std::vector<Parameter> parameters;
  std::size_t required = 0;  ///< number of parameters that are not optional
  Version since;
  Builtin compute;  ///< empty: the robot implements it
};

/// The function that a call refers to.
struct Match {
  const Function* function = nullptr;
  std::vector<Type> arguments;  ///< type to which each argument is converted
  Type result;
  bool is_warned = false;  ///< a conversion of an argument gives a warning
};

/// Must not be copied while a checker or an interpreter uses it.
class FunctionTable {
 public:
  /// Has the general functions of this TMflow version.
  explicit FunctionTable(Version tmflow = {});

  /// Adds a function of the robot, or another overload of one. Precondition: a declaration as above.
  void declare(std::string_view declaration, Version since);
  /// Adds a general function.
  void define(std::string_view declaration, Version since, Builtin compute);

  /// The overload with the best conversions. The error names the cause: an unknown function, a function that
  /// is missing in the simulation or in this version, or arguments that no overload accepts.
  [[nodiscard]] Result<Match, std::string> find(const std::string& name,
                                                const std::vector<Type>& arguments) const;

  /// True for any overload of any version.
  [[nodiscard]] bool has(std::string_view name) const { return functions_.find(name) != functions_.end(); }

 private:
  Version tmflow_;
  std::map<std::string, std::vector<Function>, std::less<>> functions_;
};

}  // namespace cobot_command::tm_script
