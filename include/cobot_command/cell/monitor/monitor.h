// Watches how far the robots and mechanisms of a cell are from each other, by their measured joints and
// positions alone, and stops all when they come too close (cell.md, M35).
//
// It is no safety function: it runs on an ordinary computer, hears of them by an ordinary network, and
// stops them by ordinary commands. It finds faults of the cell's programs, its supervisor and its data; it
// protects no people, and nothing that a risk assessment would count.
//
// It knows nothing of zones, claims or the supervisor, so that their faults are not its own: what it is told
// of permits takes back a part of what old data is uncertain by, and nothing of what was measured. Pure: an
// event and the time in, what to do out. One thread owns it. All instants are of that thread's clock; no
// stamp of a message, and so no jump of another clock, matters.
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
  RobotBodies bodies;  ///< its links and its tool, in the world
  /// All that it may ever carry. As long as nobody has told what it does carry, it is taken to carry all of
  /// it: that can only make distances less.
  std::vector<FlangeCapsules> may_carry;
  /// By joint, how fast its arm is at most [rad/s]: what seems to be faster was heard late. Empty: nobody
  /// knows.
  std::vector<double> most_speeds = {};
};

struct WatchedMechanism {
  std::string name;
  MechanismBodies bodies;  ///< in the world, by the position of its axis
};

struct WatchedObstacle {
  std::string name;
  Capsules capsules;  ///< in the world [m]
};

struct MonitorSettings {
  enum class Mode { Stop, Warn };  ///< Warn: what would stop all is only told

  double margin = 0.020;                ///< closer than this is a breach [m]
  std::optional<double> stop_distance;  ///< closer than this stops all [m]; none: half of the margin
  Mode mode = Mode::Stop;
  /// Older data is none: of what moved by it, a reason to stop all.
  Duration stale_after = std::chrono::milliseconds(500);
  /// A robot stands when no joint is faster [rad/s], a mechanism when its axis is not [m/s or rad/s].
  double standing_speed = 0.005;
  /// What data of that age may hide counts, whatever is permitted; see Monitor::setPermit().
  Duration prompt = std::chrono::milliseconds(50);
  double exact_within = 1.0;                        ///< farther pairs are told by a lower bound [m]
  Duration period = std::chrono::milliseconds(20);  ///< between two looks, while there is something to see
};

/// What a robot or mechanism may do by its program, from where it was measured.
struct Permit {
  /// Numbers of what it holds there, and nobody else may at the same time; ascending. The program was proved
  /// to keep those who do not hold the same at least the margin apart, and all from obstacles.
  std::vector<std::size_t> holds;
  std::vector<double> most_speeds;  ///< by axis [rad/s, or m/s]; empty: nobody knows
};

/// Why there is no monitor: what was found, what is allowed.
struct MonitorRefusal {
  std::string message;
};

class Monitor {
 public:
  /// Refused when two things have the same name, one has no bodies, and when a setting is not finite or
  /// negative, the stop distance is above the margin, a time is not above 0.
  [[nodiscard]] static Result<Monitor, MonitorRefusal> of(std::vector<WatchedRobot> robots,
                                                          const std::vector<WatchedObstacle>& obstacles,
                                                          const MonitorSettings& settings = {},
                                                          std::vector<WatchedMechanism> mechanisms = {});
  Monitor(Monitor&& other) noexcept;
  Monitor& operator=(Monitor&& other) noexcept;
  ~Monitor();

  // --- What happens.
  /// Measured joints [rad] and their velocities [rad/s], `age` before `now`. Velocities are not relied on:
  /// what the joints did since the data before counts where it is more. A robot of which neither is known yet
  /// counts as one that moves, and its data as certain. What is malformed or old is dropped and counted, so
  /// that what is known becomes stale in the end.
  void take(const std::string& robot, const arm::JointVector& joints,
            const std::optional<arm::JointVector>& velocities, Duration age, Instant now);
  /// Where a mechanism was measured on or about its axis [m, or rad of one that turns]. All else is as of the
  /// joints of a robot whose velocities nobody tells.
  void takePosition(const std::string& mechanism, double position, Duration age, Instant now);
  /// From now on the robot carries just these of what it may carry; nothing: nobody can tell, so all of it.
  /// False, and nothing changes, when there is no such robot or part.
  bool setCarried(const std::string& robot, const std::optional<Carried>& parts);
  /// Nothing: nobody can tell, so it may go anywhere. Of two that may do what they do at the same time, and
  /// of one and an obstacle, data that is older than `prompt` makes the distance uncertain by no more than
  /// down to the margin; but by what they may have moved within `prompt` it does. What is measured to be
  /// closer counts as ever. False, and nothing changes, when there is no such robot or mechanism.
  bool setPermit(const std::string& mover, const std::optional<Permit>& permit);
  /// Looks at all pairs.
  void tick(Instant now);
  /// Looks at all pairs, and ends the latch; refused while what it was for lasts, or anything else that stops
  /// all. What is too close is so until it is 1 mm farther than the limit, here and in breaches.
  ResetAnswer reset(Instant now);

  // --- What to do, and how things stand as of the last tick.
  /// Since the last call, in their order.
  [[nodiscard]] std::vector<MonitorAction> takeActions();
  [[nodiscard]] MonitorStatus status() const;
  /// Of robots, then mechanisms, then obstacles.
  [[nodiscard]] std::vector<SeenBodies> bodies() const;
  [[nodiscard]] bool latched() const;
  /// The newest ones, in the order of their ends, and those that last.
  [[nodiscard]] std::vector<Breach> breaches() const;
  /// When tick() has something to do, if nothing else happens before. None while all stand, and nothing new
  /// was heard.
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

 private:
  class Parts;
  explicit Monitor(std::unique_ptr<Parts> parts);

  std::unique_ptr<Parts> parts_;
};

}  // namespace cobot_command::cell
