// The queue of the robot: motions one after the other, and the changes, outputs and tags between them.
//
// Everything happens in order and at its exact time: a motion starts where the one before it ends, or,
// blended, where it is to take over; that is where the one before it is done. A change of base, TCP or load
// acts on the motions behind it; a tag is settled when all before it is done. A PVT is one motion; what is
// queued between its points acts when the arm is there. While the arm takes velocities, what is behind waits.
// Call run() at nextEvent() at the latest.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "queue/path_clock.h"
#include "queue/queued_tag.h"
#include "queue/robot_error.h"

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/motion/blend.h"
#include "cobot_command/motion/command.h"
#include "cobot_command/motion/trajectory.h"
#include "cobot_command/motion/velocity.h"
#include "cobot_command/planning/script_motion.h"
#include "cobot_command/simulator/fault_switches.h"

namespace cobot_command::simulator {

using MotionRequest = planning::ScriptMotion;
struct BaseChange {
  arm::Pose pose;    ///< in the robot base [m]
  std::string name;  ///< empty when given by value
};
struct TcpChange {
  arm::Pose pose;                              ///< in the flange [m]
  std::string name;                            ///< empty when given by value
  std::optional<double> mass;                  ///< [kg]; absent: as before
  std::optional<script::ToolInertia> inertia;  ///< likewise
};
struct LoadChange {
  double mass = 0;  ///< [kg]
};
/// Within a PVT that is under way, what is behind this waits until so long after its start, at a project
/// speed of 100 % [s].
struct PvtMark {
  double time = 0.0;
};
using Velocity = std::variant<arm::JointVector, motion::TcpVelocity>;
/// From here on the arm takes velocities, of one kind.
struct VelocityMode {
  bool of_tcp = false;
  /// Since the last velocity: the arm comes to rest, the mode ends.
  std::optional<Duration> time_to_rest, time_to_end;
  std::optional<Velocity> first{};  ///< came before the mode began
};
using QueueItem = std::variant<MotionRequest, BaseChange, TcpChange, LoadChange, QueuedTag, PvtMark,
                               VelocityMode, script::WriteOutput, script::WriteAnalogOutput>;

/// What the queue tells: a tag came to its end.
struct TagSettled {
  QueuedTag tag;
  bool complete = false;  ///< false: a motion before it could not be made
};
/// A tag was thrown away with the queue.
struct TagDropped {
  QueuedTag tag;
};
struct MotionStarted {
  Duration duration;  ///< as planned
};
struct MotionFailed {
  RobotError error;
};
/// WriteOutput, WriteAnalogOutput: the motions before it are done, it is to be written now.
using QueueEvent = std::variant<TagSettled, TagDropped, MotionStarted, MotionFailed, script::WriteOutput,
                                script::WriteAnalogOutput>;

class MotionQueue {
 public:
  struct Options {
    Duration stop_time{};         ///< from full motion to standstill by pause() and stop()
    double speed_override = 1.0;  ///< project speed, (0, 1]
    bool checks_payload = true;   ///< no motion with more than the model carries
  };

  /// `stale_tag`: does a stop report the tags that it drops with the next motion?
  MotionQueue(const arm::ArmModel& arm, const arm::JointVector& posture, Options options,
              FaultSwitch& stale_tag);

  /// Takes an item; it acts at the next run(). A motion clears a robot error.
  void push(QueueItem item);
  /// Does all that is due at `now`: ends a motion, settles tags, starts the next motion. A motion that cannot
  /// be made does not start; the queue is emptied, and its tags are settled as not complete. False when
  /// nothing was due.
  bool run(Instant now);
  [[nodiscard]] Instant nextEvent() const;
  [[nodiscard]] std::vector<QueueEvent> takeEvents();

  /// Slows down on the path and stands; goes on when none of those who held it does any more. Each acts once
  /// however often it is called.
  enum class Holder { Project, Safeguard, Pvt };
  void pause(Instant now, Holder holder = Holder::Project);
  void resume(Instant now, Holder holder = Holder::Project);
  // --- PVT: motion_modes.cpp
  /// From here on points, and what is queued between them.
  void openPvt(bool cartesian) { pvt_.emplace(OpenPvt{{cartesian, {}}, {}, 0.0}); }
  void addPoint(const script::PvtPoint& point);
  /// The whole is queued.
  void closePvt();
  [[nodiscard]] bool pvtIsOpen() const { return pvt_.has_value(); }
  /// Holds a PVT that is under way, and no other motion.
  void pausePvt(Instant now);
  void resumePvt(Instant now) { resume(now, Holder::Pvt); }

  // --- Velocities: motion_modes.cpp
  /// Why not, if it cannot be taken: no mode of this kind is there or waits, or the arm is held.
  [[nodiscard]] std::optional<std::string> setVelocity(const Velocity& velocity, Instant now);
  /// The arm comes to rest.
  void suspendVelocity(Instant now);
  /// And the mode ends.
  void endVelocity(Instant now);
  /// Ends what a script has begun and nobody can end any more: an open PVT, velocities.
  void leaveModes(Instant now);

  /// For the motions that start from now on, (0, 1].
  void setSpeedOverride(double override);
  /// Stops on the path; what is queued, and what will be until clearError(), fails with this error.
  void raise(RobotError error, Instant now);
  void clearError();
  /// Slows down on the path, gives up the rest of the motion and everything behind it. A pause stays.
  void stop(Instant now);
  /// Stands at once; everything is given up.
  void halt(Instant now);
  /// As when a project starts: no base, no TCP, no load, no error, no pause. Motion is not touched.
  void resetSetting();

  [[nodiscard]] motion::JointState at(Instant now) const;
  [[nodiscard]] bool inMotion(Instant now) const;
  /// No motion is under way and none waits.
  [[nodiscard]] bool idle() const { return !active_ && !velocity_ && items_.empty(); }
  /// By the project; a safeguard may hold it all the same.
  [[nodiscard]] bool paused() const { return paused_; }
  [[nodiscard]] int motionCount() const;
  /// All items that wait, of whatever kind, and the points of PVT.
  [[nodiscard]] std::size_t size() const;
  [[nodiscard]] const motion::Setting& setting() const { return setting_; }
  [[nodiscard]] const std::string& baseName() const { return base_name_; }
  [[nodiscard]] const std::string& tcpName() const { return tcp_name_; }
  [[nodiscard]] double tcpMass() const { return tcp_mass_; }
  [[nodiscard]] const script::ToolInertia& tcpInertia() const { return tcp_inertia_; }
  [[nodiscard]] double load() const { return load_; }
  /// Why the last motion was not made; until the next one is queued.
  [[nodiscard]] const std::optional<RobotError>& error() const { return error_; }

 private:
  struct Active {
    motion::TrajectoryPtr path;          // as the arm makes it
    motion::TrajectoryPtr planned;       // the same without the blend into it
    std::optional<motion::Blend> blend;  // into the motion behind it
    Duration start{};                    // path time; it runs on through blends
    bool looked_ahead = false;           // whether it blends is settled
    double speed_override = 1.0;         // as planned
    std::optional<RobotError> obstacle;  // why a velocity ends there
    bool is_pvt = false;
  };
  /// The motion that will take over from the active one.
  struct Next {
    motion::Passage passage;
    std::optional<Instant> takes_over_at;  // nothing while a pause holds the arm before
  };

  struct OpenPvt {
    planning::PvtBlock block;
    std::vector<QueueItem> between;  // each behind its mark
    double time = 0.0;               // of the last point
  };
  struct Velocities {
    VelocityMode mode;
    Instant ends_at;  // once the arm is at rest
  };

  void begin(const MotionRequest& request, motion::Passage passage, Instant now);
  void lookAhead(Instant now);
  void takeOver(Instant now);
  void schedule(Instant now);
  [[nodiscard]] bool& heldBy(Holder holder);
  [[nodiscard]] Duration pathEnd() const { return active_->start + active_->planned->duration(); }
  void settleStaleTags();
  [[nodiscard]] std::optional<RobotError> overloadBy(double load) const;
  void endActive();
  /// What is to be done at a place within the PVT that is under way.
  [[nodiscard]] std::optional<Instant> markAt() const;
  void passMark(Instant now);
  void drive(const Velocity& velocity, Instant now);
  void dropPvt();
  void apply(const MotionRequest& request, Instant now);
  void apply(const BaseChange& change, Instant now);
  void apply(const TcpChange& change, Instant now);
  void apply(const LoadChange& change, Instant now);
  void apply(const QueuedTag& tag, Instant now);
  void apply(const PvtMark&, Instant) {}  // the PVT is over
  void apply(const VelocityMode& mode, Instant now);
  void apply(const script::WriteOutput& write, Instant now);
  void apply(const script::WriteAnalogOutput& write, Instant now);
  void fail(RobotError error);
  void dropQueue();
  void brake(Instant now);
  [[nodiscard]] bool held() const { return paused_ || safeguarded_ || pvt_paused_; }
  void settle(const QueuedTag& tag, bool complete) { events_.emplace_back(TagSettled{tag, complete}); }

  const arm::ArmModel& arm_;
  Options options_;
  FaultSwitch& stale_tag_;
  motion::Setting setting_;
  std::string base_name_, tcp_name_;
  double tcp_mass_ = 0.0;
  script::ToolInertia tcp_inertia_;
  double load_ = 0.0;

  arm::JointVector posture_;  // where the arm stands, while nothing is active
  std::optional<Active> active_;
  std::optional<Next> next_;
  PathClock clock_;
  std::optional<Instant> end_at_;  // of the active motion; nothing while a pause holds it
  bool stopping_ = false;
  bool paused_ = false;
  bool safeguarded_ = false;
  bool pvt_paused_ = false;

  std::deque<QueueItem> items_;
  std::optional<OpenPvt> pvt_;
  std::optional<Velocities> velocity_;
  std::vector<QueuedTag> stale_tags_;
  std::vector<QueueEvent> events_;
  std::optional<RobotError> error_;
  bool error_stands_ = false;  // until clearError()
};

}  // namespace cobot_command::simulator
