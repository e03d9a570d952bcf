// Runs a checked script, one statement at a time.
//
//   Interpreter script(parse(text).statements, functions, scope, robot);
//   while (script.run(1000) == Progress::Ready) ...   // let others run
//
// If the robot answers a call with Wait, the script waits at that line. resume() passes the result of the
// call, and run() continues after it; completed parts of the line are not repeated. Owned and called by one
// thread. The function table, the variables and the environment must outlive it. Precondition: check() found
// no errors with these same objects.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/tm_script/environment.h"
#include "cobot_command/tm_script/functions.h"
#include "cobot_command/tm_script/parser.h"
#include "cobot_command/tm_script/variables.h"

namespace cobot_command::tm_script {

enum class Progress {
  Ready,    ///< more statements can be run
  Waiting,  ///< for resume()
  Done,     ///< after the last line, or at the end that the robot requested
  Failed    ///< fault() has the line and the reason; no line after it is run
};

/// A result of the robot for the statement that is waiting. When it continues, the statement is run again
/// with these results.
struct Answer {
  Value value;
  bool ends_script = false;
};

class Interpreter {
 public:
  Interpreter(Script script, const FunctionTable& functions, Scope scope, Environment& robot);

  /// Runs at most this number of statements, until one waits, fails or is the last.
  Progress run(int most_statements);
  /// The result of the waiting call, of the declared type. Ignored if no call waits.
  void resume(Value result);

  [[nodiscard]] Progress progress() const { return progress_; }
  /// Line of the next, waiting or failed statement; 0 when done.
  [[nodiscard]] int line() const;
  /// Only when Failed.
  [[nodiscard]] const std::optional<Fault>& fault() const { return fault_; }

 private:
  void runNext();

  Script script_;
  const FunctionTable& functions_;
  Scope scope_;
  Environment& robot_;
  std::size_t next_ = 0;
  Progress progress_ = Progress::Ready;
  std::vector<Answer> answers_;
  std::optional<Fault> fault_;
};

}  // namespace cobot_command::tm_script
