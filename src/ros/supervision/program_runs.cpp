#include "supervision/program_runs.h"

#include <algorithm>
#include <utility>

#include "supervision/supervisor_errors.h"
#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {
namespace {

using Mode = cell::SupervisorMode;
using State = cell::RobotState;

constexpr int kMostCycles = 1000000;
constexpr double kNotHeard = -1.0;
/// For the action of a node that has just come up.
constexpr Duration kPatience = std::chrono::seconds(5);
/// A robot that was silent for shorter goes on by itself when it is heard again.
constexpr Duration kGoneAfter = std::chrono::seconds(10);

bool isGone(const cell::RobotStatus& status) {
  return status.state == State::Out || (status.state == State::Lost && status.report_age > kGoneAfter);
}

std::string wordsOfGone(const cell::RobotStatus& status) {
  return fmt::format("{} is {}: {}", status.name, toString(status.state), status.text);
}

bool canRun(State state) {
  return state == State::Ready || state == State::Moving || state == State::Waiting;
}

}  // namespace

ProgramRuns::ProgramRuns(const ros::NodeHandle& node, const ActionQueues& queues,
                         std::vector<std::string> robots,
                         const std::vector<std::unique_ptr<RobotContact>>& contacts)
    : robots_(std::move(robots)),
      contacts_(contacts),
      server_(
          node, "run_cell", queues, [this](const Handle& goal) { onGoal(goal); },
          [this](const Handle& goal) { onCancel(goal); }) {
  server_.start();
}

void ProgramRuns::follow(const cell::CellStatus& status, const cobot_command::CellState& told, Instant now) {
  status_ = status;
  now_ = now;
  feedback_.state = told;
  if (!goal_) return;
  tell();
  sendGoals();
  giveUpLost();
}

void ProgramRuns::refuse(const std::string& why) {
  status_.mode = Mode::Holding;
  status_.diagnosis = forPeople(why);
}

void ProgramRuns::heardDistance(double distance) {
  if (!goal_) return;
  const bool is_first = result_.least_distance == kNotHeard;
  result_.least_distance = is_first ? distance : std::min(result_.least_distance, distance);
}

// --- Goals.

void ProgramRuns::onGoal(Handle goal) {
  if (const auto fault = objectionTo(*goal.getGoal())) {
    cobot_command::RunCellResult result;
    result.error_id = fault->id;
    result.error_description = forPeople(fault->found);
    result.remedy = fault->remedy;
    result.least_distance = kNotHeard;
    return goal.setRejected(result, result.error_description);
  }
  goal.setAccepted();
  begin(goal);
}

std::optional<ProgramRuns::Fault> ProgramRuns::objectionTo(const cobot_command::RunCellGoal& goal) const {
  if (goal.cycles < 0 || goal.cycles > kMostCycles) {
    return Fault{blocks::own_error::kCycleRange,
                 fmt::format("cycles is {}: allowed are 0 to {}", goal.cycles, kMostCycles),
                 "Set 0 to run until cancelled, or a number of cycles"};
  }
  if (!alarm_.empty()) {
    return Fault{supervisor_error::kCellNotReady, "the monitor has stopped all robots: " + alarm_,
                 "Move the robots apart, and call reset_monitor; if the monitor has died, restart it"};
  }
  for (const std::string& name : goal.robots) {
    if (std::count(robots_.begin(), robots_.end(), name) == 1) continue;
    return Fault{blocks::own_error::kProgramUnknown,
                 fmt::format("there is no robot \"{}\": the cell has {}", foreignText(name, kQuoteLimit),
                             fmt::join(robots_, ", ")),
                 "Name robots of the cell, or none for all"};
  }
  if (goal_) {
    return Fault{supervisor_error::kCellNotReady,
                 fmt::format("another run_cell is running, with {} robots still active", open()),
                 "Wait until it has ended, or cancel it"};
  }
  if (status_.mode != Mode::Ready && status_.mode != Mode::Running) {
    return Fault{
        supervisor_error::kCellNotReady,
        fmt::format("the cell is {}{}{}", toString(status_.mode), status_.diagnosis.empty() ? "" : ": ",
                    status_.diagnosis),
        "Make the cell ready: call hold with false if it is HOLDING; recover the robots that it names"};
  }
  if (status_.is_finishing) {
    return Fault{supervisor_error::kCellNotReady, "the cell is finishing: no robot starts another cycle",
                 "Call finish with false"};
  }
  for (const std::size_t robot : membersOf(goal)) {
    if (auto fault = objectionTo(robot)) return fault;
  }
  return std::nullopt;
}

std::optional<ProgramRuns::Fault> ProgramRuns::objectionTo(std::size_t robot) const {
  const cell::RobotStatus& status = status_.robots[robot];
  if (canRun(status.state)) return std::nullopt;
  return Fault{supervisor_error::kCellNotReady,
               fmt::format("{} is {}{}{}", status.name, toString(status.state),
                           status.text.empty() ? "" : ": ", status.text),
               "Bring it to READY, or name only robots that can run"};
}

std::vector<std::size_t> ProgramRuns::membersOf(const cobot_command::RunCellGoal& goal) const {
  std::vector<std::size_t> members;
  for (std::size_t robot = 0; robot < robots_.size(); ++robot) {
    const bool is_named = std::count(goal.robots.begin(), goal.robots.end(), robots_[robot]) > 0;
    if (goal.robots.empty() || is_named) members.push_back(robot);
  }
  return members;
}

void ProgramRuns::begin(const Handle& goal) {
  result_ = {};
  result_.least_distance = kNotHeard;
  fault_.reset();
  is_cancelled_ = false;
  has_lost_monitor_ = false;
  begun_ = now_;
  members_.clear();
  for (const std::size_t robot : membersOf(*goal.getGoal())) {
    result_.robots.push_back(robots_[robot]);
    result_.cycles_done.push_back(0);
    members_.push_back({robot});
  }
  goal_ = goal;
  sendGoals();
}

void ProgramRuns::sendGoals() {
  if (!goal_) return;
  cobot_command::RunProgramGoal program;
  program.cycles = goal_->getGoal()->cycles;
  for (std::size_t number = 0; number < members_.size(); ++number) {
    Member& member = members_[number];
    if (!member.is_open || member.client) continue;
    member.client = is_cancelled_ ? nullptr : contacts_[member.robot]->programs();
    if (member.client) {
      member.session = status_.robots[member.robot].session;
      member.handle =
          member.client->sendGoal(program, [this, number](const auto& handle) { onProgram(number, handle); });
    } else if (is_cancelled_) {
      member.is_open = false;
      fail({supervisor_error::kCellNotReady, robots_[member.robot] + ": cancelled before it started",
            "Recover the stopped robots, and run the cell again"});
    } else if (now_ > begun_ + kPatience) {
      member.is_open = false;
      fail({supervisor_error::kCellNotReady,
            fmt::format("{} reports from node {}, which provides no run_program", robots_[member.robot],
                        foreignText(contacts_[member.robot]->publisher(), kQuoteLimit)),
            "Check that this node is the robot's command node"});
    }
  }
  endIfOver();
}

void ProgramRuns::onCancel(const Handle& goal) {
  if (!goal_ || goal != *goal_) return;
  is_cancelled_ = true;
  for (Member& member : members_) {
    if (member.is_open && member.client) member.handle.cancel();
  }
  sendGoals();
}

// --- What becomes of the robots' goals.

void ProgramRuns::onProgram(std::size_t number, const RobotContact::ProgramHandle& handle) {
  Member& member = members_[number];
  if (!goal_ || !member.is_open || handle.getCommState() != actionlib::CommState::DONE) return;
  member.is_open = false;
  member.is_done = handle.getTerminalState() == actionlib::TerminalState::SUCCEEDED;
  const auto result = handle.getResult();
  if (result) result_.cycles_done[number] = result->cycles_done;
  const std::string& name = robots_[member.robot];
  if (!member.is_done && result && result->error_id == blocks::motion_error::kOtherBlockBusy) {
    fail({supervisor_error::kCellNotReady,
          name + " already runs a program: of another client, or from before the supervisor was restarted",
          "Let it end with finish, or stop it with stop; then run the cell again"});
  } else if (!member.is_done && result) {
    const bool is_error = result->error_id != 0;  // else it was stopped, or another command has taken it away
    fail({is_error ? result->error_id : supervisor_error::kCellNotReady,
          fmt::format("{}: {}", name, result->error_description),
          is_error ? result->remedy : "Recover it if it is FAULT or LOST, and run the cell again"});
  } else if (!member.is_done) {
    fail({supervisor_error::kCellNotReady, name + ": its goal was lost", "Check the output of its node"});
  }
  endIfOver();
}

void ProgramRuns::giveUpLost() {
  for (Member& member : members_) {
    const cell::RobotStatus& status = status_.robots[member.robot];
    if (member.is_open && member.client && status.session != 0 && status.session != member.session) {
      member.is_open = false;
      fail({supervisor_error::kCellNotReady, status.name + ": its node was restarted, and its goal was lost",
            "Run the cell again"});
      continue;
    }
    // It may be heard again while the others are still at it.
    if (!member.is_open || !isGone(status)) continue;
    const bool is_alone = std::all_of(members_.begin(), members_.end(), [&](const Member& other) {
      return !other.is_open || isGone(status_.robots[other.robot]);
    });
    if (!is_alone) continue;
    member.is_open = false;
    fail({supervisor_error::kCellNotReady, wordsOfGone(status),
          "Check the output of its node; recover it, or confirm that its zones are clear"});
  }
  endIfOver();
}

void ProgramRuns::fail(Fault fault) {
  if (!is_cancelled_) result_.failures.push_back(fault.found);
  if (!fault_) fault_ = std::move(fault);
  tell();
}

void ProgramRuns::tell() {
  feedback_.open = open();
  feedback_.failures = result_.failures;
  for (const Member& member : members_) {
    const cell::RobotStatus& status = status_.robots[member.robot];
    if (!member.is_open || is_cancelled_ || !isGone(status)) continue;
    feedback_.failures.push_back(wordsOfGone(status));
  }
  goal_->publishFeedback(feedback_);
}

int ProgramRuns::open() const {
  return static_cast<int>(
      std::count_if(members_.begin(), members_.end(), [](const Member& member) { return member.is_open; }));
}

void ProgramRuns::endIfOver() {
  if (!goal_ || open() > 0) return;
  if (has_lost_monitor_) result_.least_distance = kNotHeard;
  result_.makespan = ros::Duration(toSeconds(now_ - begun_));
  if (fault_) {
    result_.error_id = fault_->id;
    result_.error_description = forPeople(fault_->found);
    result_.remedy = fault_->remedy;
  }
  Handle goal = *std::exchange(goal_, std::nullopt);
  if (is_cancelled_ && fault_) {
    goal.setCanceled(result_, result_.error_description);
  } else if (fault_) {
    goal.setAborted(result_, result_.error_description);
  } else {
    goal.setSucceeded(result_);
  }
}

}  // namespace cobot_command::ros_adapter
