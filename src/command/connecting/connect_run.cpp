#include "connecting/connect_run.h"

#include <fmt/format.h>

#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/blocks/shared/robot_failure.h"
#include "cobot_command/common/deadline.h"
#include "cobot_command/robot/diagnosis.h"

namespace cobot_command::command {

using Event = ConnectEvent;
using State = ConnectState;

namespace {

constexpr blocks::Block kConnect = blocks::kBlock<blocks::ConnectGoal>;
/// A controller streams every 15 ms; opening the connection takes time as well.
constexpr Duration kFirstFrameWait = std::chrono::milliseconds(500);

/// What the troubles of the link mean when the timeout is over.
blocks::Failure timedOut(link::Trouble trouble, const std::string& diagnosis) {
  using link::Trouble;
  switch (trouble) {
    case Trouble::NotListening:
      return {blocks::connect_error::kTimeOut, diagnosis,
              "Let the flow of the TMflow project enter its Listen node"};
    case Trouble::Silent:
    case Trouble::NotTmRobot:
    case Trouble::OtherAnswers:
    case Trouble::StatusPort:
      return {blocks::connect_error::kNotACobot, diagnosis,
              "Check that host and port are those of the robot controller; its script port is usually 5890"};
    case Trouble::Refused:
      return {blocks::connect_error::kConnection, diagnosis,
              "Start a TMflow project that has a Listen node, or check the port"};
    case Trouble::None:
    case Trouble::NotTriedYet:
    case Trouble::Unreachable:
    case Trouble::UnknownHost:
    case Trouble::OpenTimedOut:
    case Trouble::OpenFailed:
    case Trouble::Closed:
      break;
  }
  return {blocks::connect_error::kConnection, diagnosis,
          "Check the host name or address, the Ethernet connection, and that the controller is on"};
}

}  // namespace

ConnectRun::ConnectRun(const link::LinkSettings& settings, link::ScriptLink& script, link::StatusLink& status,
                       const robot::RobotWatch& robot, OutputBoard& board)
    : settings_(settings), script_(script), status_(status), robot_(robot), board_(board) {}

bool ConnectRun::isSameController(const blocks::ConnectGoal& goal) const {
  return goal.host == goal_.host && goal.port == goal_.port &&
         goal.status_port.value_or(settings_.status_port) == statusPort();
}

/// The link that is made keeps its status port, whatever the settings become.
void ConnectRun::take(const blocks::ConnectGoal& goal) {
  goal_ = goal;
  if (!goal_.status_port) goal_.status_port = settings_.status_port;
}

void ConnectRun::execute(blocks::GoalId id, const blocks::ConnectGoal& goal, Instant now) {
  const bool take_over = busy() && isSameController(goal);
  if (busy() && !take_over) end(blocks::Outcome{}, now);
  id_ = id;
  take(goal);
  reported_.reset();
  times_ =
      take_over && connected_ ? blocks::LinkTimes{times_.last_connected, std::nullopt} : blocks::LinkTimes{};
  board_.accept(kConnect, id, 0);
  if (!take_over) {
    state_ = State::Idle;
    fire(Event::Execute, now);
  } else if (state_ == State::Trying) {
    deadline_ = now + fromSeconds(goal_.timeout);
  }
  report();
}

void ConnectRun::keep(const blocks::ConnectGoal& target, Instant now) {
  id_.reset();
  take(target);
  fire(Event::Execute, now);
}

void ConnectRun::cancel(Instant now) {
  fire(Event::Cancel, now);
}

void ConnectRun::motionsEnded(Instant now) {
  fire(Event::MotionsEnded, now);
}

void ConnectRun::abandon(const std::string& why, Instant now) {
  if (!busy()) return;
  state_ = State::Idle;
  end(blocks::commandAborted(why), now);
}

void ConnectRun::linkChanged(Instant now) {
  if (!busy() || state_ == State::Explaining) return;
  becomeReadyWhenDue(now);
  if (!disconnecting()) report();
}

void ConnectRun::statusChanged(Instant now) {
  if (state_ == State::Explaining) {
    lookForReason(now);
  } else if (busy() && !disconnecting()) {
    linkChanged(now);
  }
}

void ConnectRun::lookForReason(Instant now) {
  if (robot_.emergencyStop()) {
    loss_.found = "emergency stop: " + loss_.found;
    loss_.remedy = blocks::emergencyStop().remedy;
    fire(Event::Lost, now);
  } else if (robot_.inError()) {
    loss_.found = fmt::format("{}: {}", robot_.errorText(), loss_.found);
    fire(Event::Lost, now);
  } else if (!robot_.status() || reason_.endsWithFrame(now)) {
    blocks::tellStoppedProject(robot_, loss_);
    fire(Event::Lost, now);
  }
}

/// Without the first status frame nobody knows where the robot stands, and a command that comes at once could
/// not be planned.
void ConnectRun::becomeReadyWhenDue(Instant now) {
  if (state_ != State::Trying || script_.state() != link::ScriptLinkState::Ready) {
    first_frame_by_.reset();
    return;
  }
  if (!first_frame_by_) first_frame_by_ = now + kFirstFrameWait;
  const bool known = statusPort() == 0 || status_.streaming();
  if (!known && now < *first_frame_by_) return;
  first_frame_by_.reset();
  fire(Event::BecameReady, now);
}

void ConnectRun::linkLost(const std::string& reason, Instant now) {
  loss_ = {blocks::connect_error::kDisconnected, reason, ""};
  if (connected_) {
    times_.last_lost = now;
    if (!disconnecting()) kept_times_.last_lost = now;
  }
  connected_ = false;
  if (settings_.auto_reconnect || !id_) {
    fire(Event::LostToRetry, now);
  } else {
    const bool may_be_explained = state_ == State::Supervising && robot_.status();
    fire(may_be_explained ? Event::LostUnexplained : Event::Lost, now);
  }
}

std::optional<Instant> ConnectRun::nextDeadline() const {
  return earlier(deadline_, first_frame_by_);
}

void ConnectRun::advance(Instant now) {
  if (first_frame_by_ && now >= *first_frame_by_) linkChanged(now);
  if (deadline_ && now >= *deadline_) fire(Event::TimedOut, now);
}

void ConnectRun::fire(Event event, Instant now) {
  const auto row = findTransition<ConnectTable>(state_, event);
  if (!row) return;
  state_ = row->to;
  act(row->action, now);
}

void ConnectRun::act(ConnectAction action, Instant now) {
  using Do = ConnectAction;
  switch (action) {
    case Do::None:
      return;
    case Do::Start:
      start(now);
      return;
    case Do::Hold:
      deadline_.reset();
      connected_ = true;
      times_.last_connected = kept_times_.last_connected = now;
      return;
    case Do::RestartTimeout:
      if (id_) deadline_ = now + fromSeconds(goal_.timeout);
      return;
    case Do::StopMotions:
      deadline_.reset();
      return;
    case Do::AwaitReason:
      reportLoss();
      reason_.begin(now);
      deadline_ = now + settings_.evidence_timeout;
      return;
    case Do::EndTimedOut:
      end(blocks::toOutcome(kConnect, blocks::Ending::Aborted,
                            timedOut(script_.trouble(), robot::diagnose(script_, robot_))),
          now);
      return;
    case Do::EndLost:
      end(blocks::toOutcome(kConnect, blocks::Ending::Aborted, loss_), now);
      return;
    case Do::EndDone: {
      blocks::Outcome outcome;
      outcome.error_description = "disconnected on request";
      end(std::move(outcome), now);
      return;
    }
  }
}

void ConnectRun::start(Instant now) {
  if (id_) deadline_ = now + fromSeconds(goal_.timeout);
  script_.start(goal_.host, goal_.port, now);
  if (statusPort() != 0) status_.start(goal_.host, statusPort(), now);
}

void ConnectRun::end(blocks::Outcome outcome, Instant now) {
  deadline_.reset();
  first_frame_by_.reset();
  if (connected_) times_.last_lost = now;
  connected_ = false;
  script_.stop(now);
  status_.stop(now);
  outcome.detail = blocks::Detail(times_);
  if (id_) board_.end(kConnect, *id_, std::move(outcome));
}

void ConnectRun::report() {
  blocks::Progress progress;
  progress.text = robot::diagnose(script_, robot_);
  switch (script_.state()) {
    case link::ScriptLinkState::Ready:
      progress.phase = ready() ? blocks::Phase::Connected : blocks::Phase::Probing;
      if (!ready()) {
        progress.text += "; waiting for the first status frame";
      } else if (const std::string unseen = robot::whatIsUnseen(robot_); !unseen.empty()) {
        progress.text += "; " + unseen;
      }
      break;
    case link::ScriptLinkState::Probing:
    case link::ScriptLinkState::NotListening:
    case link::ScriptLinkState::Leaving:
      progress.phase = blocks::Phase::Probing;
      break;
    default:
      progress.phase = blocks::Phase::Connecting;
  }
  tell(std::move(progress));
}

void ConnectRun::reportLoss() {
  blocks::Progress progress;
  progress.phase = blocks::Phase::Connecting;
  progress.text = robot::ReasonWait::text("the link was lost, " + loss_.found);
  tell(std::move(progress));
}

void ConnectRun::tell(blocks::Progress progress) {
  if (!id_) return;
  if (reported_ == std::pair(progress.phase, progress.text)) return;
  reported_.emplace(progress.phase, progress.text);
  progress.detail = blocks::Detail(times_);
  board_.progress(kConnect, *id_, std::move(progress));
}

}  // namespace cobot_command::command
