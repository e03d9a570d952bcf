#include "connecting/link_keeper.h"

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/robot/loose_motion.h"

namespace cobot_command::command {

std::vector<blocks::Failure> LinkKeeper::objectionsTo(const blocks::ConnectGoal& goal,
                                                      const std::optional<blocks::Block>& user,
                                                      bool may_move) const {
  std::vector<blocks::Failure> failures = check(goal);
  const auto target = fmt::format("{}:{}", run_.target().host, run_.target().port);
  if (!run_.mayExecute()) {
    failures.push_back(
        {blocks::own_error::kConnectBusy,
         run_.disconnecting() ? fmt::format("the link to {} is being closed", target) : "with " + target,
         ""});
  } else if (run_.busy() && user) {
    failures.push_back({blocks::own_error::kConnectBusy,
                        fmt::format("the link to {} is used by {}", target, toString(*user)),
                        "Wait for its end, or cancel it, then connect"});
  } else if (run_.busy() && may_move && !run_.isSameController(goal)) {
    failures.push_back({blocks::own_error::kConnectBusy,
                        fmt::format("the robot at {} may still move", target),
                        "Stop that robot first (stop), or wait until it is at standstill"});
  }
  return failures;
}

std::vector<blocks::Failure> LinkKeeper::objectionsToCommands() const {
  if (run_.disconnecting()) {
    return {{blocks::motion_error::kNotConnected, "the connection is being closed", ""}};
  }
  if (!run_.busy() || !script_.established()) {
    return {{blocks::motion_error::kNotConnected, diagnosis(), ""}};
  }
  if (script_.state() != link::ScriptLinkState::Ready) {
    return {{blocks::own_error::kNotListening, script_.diagnosis(), ""}};
  }
  return {};
}

std::vector<blocks::Failure> LinkKeeper::objectionsToATry() const {
  if (script_.connected()) return {};
  return {{blocks::motion_error::kNotConnected, diagnosis(), ""}};
}

void LinkKeeper::execute(blocks::GoalId id, const blocks::ConnectGoal& goal, Instant now) {
  cancelled_ = false;
  run_.execute(id, goal, now);
}

void LinkKeeper::cancel(Instant now) {
  if (kept_) cancelled_ = true;
  run_.cancel(now);
}

void LinkKeeper::keep(const blocks::ConnectGoal& target) {
  kept_ = target;
  cancelled_ = false;
}

bool LinkKeeper::keepOn(Instant now) {
  if (!kept_ || cancelled_ || run_.busy()) return false;
  run_.keep(*kept_, now);
  return true;
}

std::string LinkKeeper::textOfTheRobotLeft() const {
  if (!left_moving_) return "";
  return fmt::format("the link to {}:{} was lost during a motion: {}", left_moving_->host, left_moving_->port,
                     robot::LooseMotion::kMayStillMove);
}

void LinkKeeper::lookForTheRobotLeft() {
  if (run_.ready() && left_moving_ && run_.isSameController(*left_moving_)) left_moving_.reset();
}

std::string LinkKeeper::diagnosis() const {
  std::string text = script_.diagnosis();
  if (endedByCancel()) {
    text += text.empty() ? "" : "; ";
    text +=
        "the connect goal that was cancelled has ended the automatic link (auto_connect): send a connect "
        "goal, or start the node again";
  }
  return text;
}

}  // namespace cobot_command::command
