#include "cobot_command/tm_script/interpreter.h"

#include <utility>

#include "execution/evaluator.h"

namespace cobot_command::tm_script {

Interpreter::Interpreter(Script script, const FunctionTable& functions, Scope scope, Environment& robot)
    : script_(std::move(script)), functions_(functions), scope_(scope), robot_(robot) {
  if (script_.empty()) progress_ = Progress::Done;
}

Progress Interpreter::run(int most_statements) {
  for (; most_statements > 0 && progress_ == Progress::Ready; --most_statements) runNext();
  return progress_;
}

void Interpreter::resume(Value result) {
  if (progress_ != Progress::Waiting) return;
  answers_.push_back({std::move(result), false});
  progress_ = Progress::Ready;
}

int Interpreter::line() const {
  return progress_ == Progress::Done ? 0 : script_[next_].line;
}

void Interpreter::runNext() {
  auto ends = Evaluator(functions_, scope_, robot_, answers_).run(script_[next_]);
  if (!ends && ends.error().waits) {
    progress_ = Progress::Waiting;
  } else if (!ends) {
    fault_ = faultOf(line(), ends.error().reason);
    progress_ = Progress::Failed;
  } else {
    answers_.clear();
    ++next_;
    if (*ends || next_ == script_.size()) progress_ = Progress::Done;
  }
}

}  // namespace cobot_command::tm_script
