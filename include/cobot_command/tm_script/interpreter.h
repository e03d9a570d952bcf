// Runs a checked script, a statement at a time.
//
//   Interpreter script(parse(text).statements, functions, scope, robot);
//   while (script.run(1000) == Progress::Ready) ...   // let others run
//
// When the robot answers a call with Wait, the script stands at that line. resume() gives the result of the
// call, and run() goes on behind it; whatever the line did before is not done again. Owned and called by one
// thread. The function table, the variables and the environment outlive it. Precondition: check() found no
// errors, with the same of all these.
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
  Ready,    ///< more statements are to be run
  Waiting,  ///< for resume()
  Done,     ///< behind the last line, or at the end that the robot made
  Failed    ///< fault() tells the line and the reason; nothing behind it is run
};

/// What the robot has said to a statement that waits now: when it goes on, it is run anew with these.
struct Answer {
  Value value;
  bool ends_script = false;
};

class Interpreter {
 public:
  Interpreter(Script script, const FunctionTable& functions, Scope scope, Environment& robot);

  /// Runs at most so many statements, until one waits, fails or is the last.
  Progress run(int most_statements);
  /// The result of the call that waits; it must have the declared type. Ignored when none waits.
  void resume(Value result);

  [[nodiscard]] Progress progress() const { return progress_; }
  /// Of the statement to be run next, or that waits or failed; 0 when done.
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
