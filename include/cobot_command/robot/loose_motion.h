// Motions that no goal waits for any more, and that may still be under way: blended ones, which are done with
// their acceptance, and whatever a stop was to end that was not confirmed. The next command may follow a
// blended one at once; what nobody could stop holds it back.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/common/time.h"
#include "cobot_command/robot/arrival.h"
#include "cobot_command/robot/robot_watch.h"

namespace cobot_command::robot {

class LooseMotion {
 public:
  static constexpr const char* kMayStillMove = "the robot may still move";

  /// Does the layer know where the robot will come to rest? Never: velocities, which go on until others end
  /// them.
  enum class End { Planned, Unknown, Never };
  /// The controller has a motion whose end no tag will tell; `target`: where that is to be seen at its end,
  /// if known.
  void begin(const std::optional<Target>& target, End end, Instant now);
  /// Nobody knows what the robot does; `why`: what was found. `target`: of what was to be stopped.
  void stopFailed(const std::string& why, const std::optional<Target>& target, Instant now);
  /// It was stopped, is done, or nobody can be told any more.
  void end() { *this = LooseMotion(); }
  /// A robot that is seen to stand has none, once a motion had the time to be seen.
  void see(const RobotWatch& robot, Instant now);

  [[nodiscard]] bool mayMove() const { return state_ != State::None; }
  /// It may move, and nobody can plan from where it will stand.
  [[nodiscard]] bool endsUnknown() const { return mayMove() && end_ != End::Planned; }
  /// It may move, and who waits for its end does not wait for ever.
  [[nodiscard]] bool endsByItself() const { return mayMove() && end_ != End::Never; }
  /// Of a stop that failed: nothing may queue behind it unseen.
  [[nodiscard]] bool holdsBack() const { return state_ == State::Unstopped; }
  [[nodiscard]] const std::optional<Target>& target() const { return target_; }
  /// Of a stop that failed, for people; empty: none did.
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  enum class State { None, Blended, Unstopped };

  State state_ = State::None;
  End end_ = End::Planned;
  Instant since_{};
  std::optional<Target> target_;
  std::string text_;
};

}  // namespace cobot_command::robot
