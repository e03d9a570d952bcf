// The pause of the project that this layer makes by itself: for a path that is stopped on its way, and for a
// speed override of 0. It is one pause, whoever wants it: made for the first, and taken back when nobody
// wants it any more. A pause that somebody else has made is his to end; so is one that only RESUME may end.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "paths/path_desk.h"
#include "runs/command_window.h"

#include "cobot_command/command/actions.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::command {

class PauseDesk {
 public:
  /// What it uses of the core; all have to live longer.
  struct Core {
    PathDesk& paths;
    CommandWindow& window;
    robot::RobotWatch& robot;
    std::vector<Action>& actions;
    /// Why nothing can be sent to the controller.
    std::function<std::vector<blocks::Failure>()> objections;
    /// A client has let the project go on, and the controller has taken it.
    std::function<void()> resumed;
  };
  explicit PauseDesk(Core core) : core_(std::move(core)) {}

  enum class Holder { Path, Override };
  struct Answer {
    bool done = false;
    int error_id = 0;
    std::string message;  ///< why not; or what holds the robot all the same
  };
  /// Called once: at once, or when the controller has answered.
  using Reply = std::function<void(const Answer& answer)>;

  void hold(Holder holder, const Reply& reply, Instant now);
  void letGo(Holder holder, const Reply& reply, Instant now);
  /// It wants the pause, and that is there, or asked for.
  [[nodiscard]] bool isHeldBy(Holder holder) const { return holders_.count(holder) != 0; }
  /// A Pause() is under way.
  [[nodiscard]] bool isPausing() const { return state_ == State::Pausing; }
  [[nodiscard]] bool stands() const { return state_ == State::Paused || state_ == State::Resuming; }
  /// The project is paused, by somebody else.
  [[nodiscard]] bool isPausedByOthers() const;
  /// Why the robot stands, apart from this desk; empty: nothing is known that holds it.
  [[nodiscard]] std::string heldByOthers() const;

  /// A goal that pauses or resumes the project was sent: what it does is its client's, also where nobody sees
  /// that in the stream.
  void sentFor(blocks::GoalId goal, bool pauses) { of_goals_[goal] = pauses; }
  /// Paused until a client resumes it, whoever holds the robot now, and lets go of it.
  void pauseForGood(Instant now);
  /// What was sent beside has ended.
  void ended(const CommandWindow::Ended& ended);
  /// The project may have been let go by others, or stopped.
  void robotChanged();
  /// Whether the project is paused behind the next link nobody knows here.
  void linkLost() { forget(); }

 private:
  /// Of the pause; with no answer yet: Pausing, Resuming.
  enum class State { None, Pausing, Paused, Resuming };
  struct Waiting {
    blocks::CommandKey key = 0;
    Reply reply;
  };

  /// Pausing or Resuming from now on.
  void send(State state, const Reply& reply, Instant now);
  [[nodiscard]] blocks::CommandKey sendLine(bool pauses, Instant now);
  void goalEnded(bool pauses);
  void endedForGood(const CommandWindow::Ended& ended);
  void join(const Reply& reply) { waiting_.push_back({last_, reply}); }
  void changeTo(State state);
  void tellStanding();
  /// For what is held no more, though nobody here has let it go.
  void letGoByOthers();
  void forget();

  Core core_;
  std::set<Holder> holders_;
  std::optional<Holder> leaving_;  ///< whose Resume() is under way: the last one's
  std::vector<Waiting> waiting_;
  blocks::CommandKey sent_ = 0;  ///< counts up
  blocks::CommandKey last_ = 0;  ///< of what was sent last for holders, whose answer counts
  State state_ = State::None;
  bool seen_ = false;                           ///< the status stream has shown that pause
  bool others_pause_ = false;                   ///< the same project, by a client, or until one resumes it
  bool others_seen_ = false;                    ///< the status stream has shown that one
  std::map<blocks::GoalId, bool> of_goals_;     ///< not answered yet; true: it pauses
  std::optional<blocks::CommandKey> for_good_;  ///< the same, of pauseForGood()
};

}  // namespace cobot_command::command
