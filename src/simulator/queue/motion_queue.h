// The queue of the robot: motions one after the other, and the changes, outputs and tags between them.
//
// Everything happens in order and at its exact time: a motion starts where the one before it ends, or,
// blended, where it is to take over; that is where the one before it is done. A change of base, TCP or load
// acts on the motions behind it; a tag is settled when all before it is done. A PVT is one motion; what is
// queued between its points acts when the arm is there. While the arm takes velocities, what is behind waits.
// Call run() at nextEvent() at the latest.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "drive/moving_arm.h"
#include "drive/robot_error.h"
#include "queue/holds.h"
#include "queue/motion_planner.h"
#include "queue/queue_entry.h"
#include "queue/queue_reports.h"
#include "queue/tool_and_base.h"
#include "queue/velocities.h"
#include "queue/waiting_entries.h"

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/simulator/fault_switches.h"

namespace cobot_command::simulator {

class MotionQueue {
 public:
  using Options = MotionPlanner::Options;

  /// Of `faults`, which outlives it, those of its motions and of the tags that a stop drops.
  MotionQueue(const arm::ArmModel& arm, const arm::JointVector& posture, Options options,
              FaultSwitches& faults);

  /// Takes an entry; it acts at the next run(). A motion clears the error of the one before.
  void push(QueueEntry entry);
  /// Does all that is due at `now`: ends a motion, settles tags, starts the next motion. A motion that cannot
  /// be made does not start; the queue is emptied, and its tags are settled as not complete. False when
  /// nothing was due.
  bool run(Instant now);
  [[nodiscard]] Instant nextEvent() const;
  [[nodiscard]] std::vector<QueueEvent> takeEvents() { return reports_.take(); }

  /// Slows down on the path and stands; goes on when none of those who held it does any more. Each acts once
  /// however often it is called. A PVT holds itself, and no other motion.
  void pause(Instant now, Holder holder = Holder::Project);
  void resume(Instant now, Holder holder = Holder::Project);

  /// While it is open it takes points, and all that is pushed; what it makes of them is to be pushed then.
  [[nodiscard]] PvtRecorder& pvt() { return waiting_.pvt(); }

  /// Why not, if it cannot be taken: no mode of this kind is there or waits, or the arm is held.
  [[nodiscard]] std::optional<std::string> setVelocity(const Velocity& velocity, Instant now);
  /// The arm comes to rest.
  void suspendVelocity(Instant now);
  /// And the mode ends.
  void endVelocity(Instant now);
  /// Ends what a script has begun and nobody can end any more: an open PVT, velocities.
  void leaveModes(Instant now);

  /// For the motions that start from now on, (0, 1]; with Options::live_speed also for the one under way, if
  /// it is no velocity.
  void setSpeedOverride(double override, Instant now);
  /// Stops on the path; what is queued, and what will be until clearError(), fails with this error.
  void raise(RobotError error, Instant now);
  void clearError() { errors_.clear(); }
  /// Slows down on the path, gives up the rest of the motion and everything behind it. A pause stays.
  void stop(Instant now);
  /// Stands at once; everything is given up.
  void halt(Instant now);
  /// As when a project starts: no base, no TCP, no load, no error, no pause. A motion that is under way is
  /// not ended.
  void resetSetting(const arm::Pose& tcp, Instant now);

  [[nodiscard]] const MovingArm& arm() const { return arm_; }
  /// No motion is under way and none waits.
  [[nodiscard]] bool idle() const { return !arm_.isOnPath() && !velocities_.on() && waiting_.empty(); }
  /// By the project; a safeguard may hold it all the same.
  [[nodiscard]] bool paused() const { return holds_.by(Holder::Project); }
  [[nodiscard]] int motionCount() const { return waiting_.motionCount() + (arm_.isOnPath() ? 1 : 0); }
  /// Behind the motion that is under way.
  [[nodiscard]] const WaitingEntries& waiting() const { return waiting_; }
  [[nodiscard]] const ToolAndBase& toolAndBase() const { return setting_; }
  /// Why the last motion was not made; until the next one is queued.
  [[nodiscard]] const std::optional<RobotError>& error() const { return errors_.error(); }

 private:
  bool step(Instant now);
  bool stepOnPath(Instant now);
  void lookAhead(Instant now);
  void takeOver(Instant now);
  void endMotion();
  /// Of what is to be done at a place within the PVT that is under way.
  [[nodiscard]] std::optional<Instant> markAt() const;
  void apply(const QueueEntry& entry, Instant now);
  void start(const MotionRequest& request, Instant now);
  void drive(const Velocity& velocity, Instant now);
  void fail(RobotError error);
  void giveUp();

  MotionPlanner planner_;
  ToolAndBase setting_;
  MovingArm arm_;
  Holds holds_;
  ErrorLatch errors_;
  Velocities velocities_;
  WaitingEntries waiting_;
  QueueReports reports_;
};

}  // namespace cobot_command::simulator
