// The arm on the path of one motion, and from there into the next one: where it is, and when it gets where.
//
// What can happen to it is the table in arm_states.h.
#pragma once

#include <optional>

#include "drive/arm_states.h"
#include "drive/path_clock.h"
#include "drive/robot_error.h"

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"
#include "cobot_command/motion/blend.h"
#include "cobot_command/motion/trajectory.h"

namespace cobot_command::simulator {

struct ArmMotion {
  motion::TrajectoryPtr path;          ///< as the arm makes it
  motion::TrajectoryPtr planned;       ///< the same without the blend into it
  std::optional<motion::Blend> blend;  ///< into the motion behind it
  double speed_override = 1.0;         ///< as planned
  bool is_pvt = false;
  Duration lag{};                        ///< so much behind the plan it comes to its places
  std::optional<RobotError> obstacle{};  ///< why a velocity ends there
};

class MovingArm {
 public:
  /// `stop_time`: from full motion to standstill on the path, and back.
  MovingArm(const arm::JointVector& posture, Duration stop_time) : posture_(posture), clock_(stop_time) {}

  /// From rest; velocities also out of the motion that is under way.
  void begin(ArmMotion motion, Instant now);
  void hold(Instant now) { on(ArmEvent::Hold, now); }
  void release(Instant now) { on(ArmEvent::Release, now); }
  /// Slows down on the path and gives up the rest.
  void brake(Instant now);
  void halt(Instant now);
  /// From now on as if what is under way had been planned with this project speed, (0, 1]; only its times
  /// change.
  void setSpeedOverride(double override, Instant now);

  [[nodiscard]] ArmState state() const { return state_; }
  [[nodiscard]] bool isOnPath() const { return state_ != ArmState::Standing; }
  /// How the arm is at a time from the last event on.
  [[nodiscard]] motion::JointState at(Instant now) const;
  [[nodiscard]] bool inMotion(Instant now) const { return isOnPath() && clock_.rate(now) > 0.0; }

  // --- The rest is for an arm on its path.
  [[nodiscard]] const ArmMotion& motion() const { return active_->motion; }
  /// Path time to the end.
  [[nodiscard]] Duration left(Instant now) const { return pathEnd() - clock_.pathTime(now); }
  /// To be told by end(). Nothing while a hold lets it stand before.
  [[nodiscard]] std::optional<Instant> endsAt() const { return end_at_; }
  /// When it has made so much of its motion, or all of it; as planned at a project speed of 100 % [s].
  [[nodiscard]] std::optional<Instant> passes(double time) const;

  /// Is it open into which motion it blends?
  [[nodiscard]] bool seeksNext() const;
  /// It blends into none, unless into one of prepareNext().
  void seekNoMore() { active_->seeks_next = false; }
  /// What was prepared was planned for other circumstances.
  void seekAnew();
  void prepareNext(ArmMotion next, Duration overlap, Instant now);
  /// When the prepared motion takes over; nothing as with endsAt(), and without one.
  [[nodiscard]] std::optional<Instant> takesOverAt() const;
  void takeOver(Instant now);

  struct Ended {
    bool was_stopped = false;
    std::optional<RobotError> obstacle{};
  };
  /// At endsAt(): it stands.
  Ended end();

 private:
  struct Active {
    ArmMotion motion;
    Duration start{};         // path time; it runs on through blends
    bool seeks_next = false;  // whether it blends is open
  };
  struct Next {
    ArmMotion motion;
    Duration overlap;
    std::optional<Instant> takes_over_at;
  };

  void on(ArmEvent event, Instant now);
  void perform(ArmAction action, Instant now);
  void set(ArmMotion motion, Duration start);
  void stand(const arm::JointVector& posture);
  void schedule(Instant now);
  void scheduleStop(Instant now);
  [[nodiscard]] motion::JointState onPath(Instant now) const;
  [[nodiscard]] Duration pathEnd() const { return active_->start + active_->motion.planned->duration(); }

  ArmState state_ = ArmState::Standing;
  arm::JointVector posture_;  // where it stands
  PathClock clock_;
  std::optional<Active> active_;  // while it does not stand
  std::optional<Next> next_;      // will take over from the active one
  std::optional<Instant> end_at_;
};

}  // namespace cobot_command::simulator
