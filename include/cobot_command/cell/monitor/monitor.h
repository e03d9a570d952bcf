// Monitors the distances between the robots and mechanisms of a cell, only from their measured joints and
// positions, and stops all when they are too close (doc/cell.md).
//
// It is not a safety function: it runs on an ordinary computer, receives data over an ordinary network, and
// stops robots by ordinary commands. It finds faults of the cell's programs, its supervisor and its data. It
// protects no people, and must not be credited in a risk assessment.
//
// It is independent of zones, claims and the supervisor, so their faults do not affect it. Permits only limit
// the uncertainty caused by old data, and never change measured distances. Pure: its inputs are events and
// the time, its outputs actions. Owned by one thread. All times are of that thread's clock; message stamps
// and jumps of other clocks have no effect.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/arm/types.h"
#include "cobot_command/cell/bodies/capsule.h"
#include "cobot_command/cell/bodies/mechanism_bodies.h"
#include "cobot_command/cell/bodies/part_tree.h"
#include "cobot_command/cell/bodies/robot_bodies.h"
#include "cobot_command/cell/monitor/monitor_state.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

struct WatchedRobot {
  std::string name;
  RobotBodies bodies;  ///< links and tool, in the world
  /// All parts that it may ever carry. While its actual parts are unknown, it is assumed to carry all of
  /// them, which can only reduce distances.
  std::vector<FlangeCapsules> may_carry;
  /// Maximum speed of each joint [rad/s]: an apparently higher speed means delayed data. Empty: unknown.
  std::vector<double> most_speeds = {};
};

struct WatchedMechanism {
  std::string name;
  MechanismBodies bodies;  ///< in the world, for each position of its axis
};

struct WatchedObstacle {
  std::string name;
  Capsules capsules;  ///< in the world [m]
};

struct MonitorSettings {
  enum class Mode { Stop, Warn };  ///< Warn: only reports what would stop all

  double margin = 0.020;                ///< closer than this is a breach [m]
  std::optional<double> stop_distance;  ///< closer than this stops all [m]; std::nullopt: half of the margin
  Mode mode = Mode::Stop;
  /// Data older than this is not used. All are stopped if it was of something that moved.
  Duration stale_after = std::chrono::milliseconds(500);
  /// A robot is at standstill if no joint is faster [rad/s], a mechanism if its axis is not faster [m/s or
  /// rad/s].
  double standing_speed = 0.005;
  /// Possible motion within this time always counts, regardless of permits; see Monitor::setPermit().
  Duration prompt = std::chrono::milliseconds(50);
  double exact_within = 1.0;                        ///< the distance of farther pairs is a lower bound [m]
  Duration period = std::chrono::milliseconds(20);  ///< between two checks while something moves or is new
};

/// What a robot or mechanism may do according to its program, from its measured position.
struct Permit {
  /// Numbers of the zones that it holds there exclusively; ascending. It is proven that programs without a
  /// common zone keep at least the margin, and that all keep it from obstacles.
  std::vector<std::size_t> holds;
  std::vector<double> most_speeds;  ///< by axis [rad/s or m/s]; empty: unknown
};

/// Why a monitor cannot be created: what was found, what is allowed.
struct MonitorRefusal {
  std::string message;
};

class Monitor {
 public:
  /// Refused if two objects have the same name, an object has no bodies, a setting is negative or not finite,
  /// the stop distance is above the margin, or a time is not above 0.
  [[nodiscard]] static Result<Monitor, MonitorRefusal> of(std::vector<WatchedRobot> robots,
                                                          const std::vector<WatchedObstacle>& obstacles,
                                                          const MonitorSettings& settings = {},
                                                          std::vector<WatchedMechanism> mechanisms = {});
  Monitor(Monitor&& other) noexcept;
  Monitor& operator=(Monitor&& other) noexcept;
  ~Monitor();

  // --- Inputs.
  /// Measured joints [rad] and their velocities [rad/s], `age` before `now`. The velocities are not trusted:
  /// the motion since the previous data is used if it is faster. If neither is known yet, the robot counts as
  /// moving and its data as exact. Malformed or old data is dropped and counted, so the last valid data
  /// eventually becomes stale.
  void take(const std::string& robot, const arm::JointVector& joints,
            const std::optional<arm::JointVector>& velocities, Duration age, Instant now);
  /// Measured position of a mechanism on or about its axis [m, or rad of a revolute axis]. Otherwise as for
  /// the joints of a robot without velocities.
  void takePosition(const std::string& mechanism, double position, Duration age, Instant now);
  /// The parts that the robot carries from now on, of those that it may carry; std::nullopt: unknown, so all
  /// of them. Returns false, without a change, if the robot or part does not exist.
  bool setCarried(const std::string& robot, const std::optional<Carried>& parts);
  /// Sets what it may do; std::nullopt: unknown, so it may move anywhere. For two movers whose permits have
  /// no common zone, and for a mover and an obstacle, data older than `prompt` reduces the distance at most
  /// to the margin. The possible motion within `prompt` is still subtracted in full. A measured distance
  /// below the margin always counts. Returns false, without a change, if the robot or mechanism does not
  /// exist.
  bool setPermit(const std::string& mover, const std::optional<Permit>& permit);
  /// Checks all pairs.
  void tick(Instant now);
  /// Checks all pairs and resets the latch. Refused while its cause, or another cause to stop all, persists.
  /// A pair counts as too close until it is 1 mm farther apart than the limit, here and for breaches.
  ResetAnswer reset(Instant now);

  // --- Outputs, and the state of the last tick.
  /// All since the last call, in order.
  [[nodiscard]] std::vector<MonitorAction> takeActions();
  [[nodiscard]] MonitorStatus status() const;
  /// Robots, then mechanisms, then obstacles.
  [[nodiscard]] std::vector<SeenBodies> bodies() const;
  [[nodiscard]] bool latched() const;
  /// The newest ones, ordered by their end, and those that still last.
  [[nodiscard]] std::vector<Breach> breaches() const;
  /// The time of the next tick(), if nothing else happens before. std::nullopt while all are at standstill
  /// and no new data was received.
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

 private:
  class Parts;
  explicit Monitor(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace cobot_command::cell
