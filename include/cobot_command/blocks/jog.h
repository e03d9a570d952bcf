// Moves the arm by hand: while keep-alives arrive (hold to run), or by a small increment. GroupJog of SRCI.
// doc/actions/jog.md.
//
// Hold to run acts as its own dead man's switch: without a new keep-alive the arm is at standstill within
// kJogStandsWithin.
#pragma once

#include <array>
#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/blocks/shared/block_parts.h"
#include "cobot_command/blocks/shared/run.h"

namespace cobot_command::blocks {

enum class JogMode {
  Frame = 0,  ///< along and about the axes of a frame
  Tool = 1,   ///< along or about the axes of the tool
  Axes = 2    ///< about the joint axes
};

/// How the controller is commanded.
enum class JogMeans {
  None = 0,
  Velocity = 1,  ///< continuous velocities, which require a licence
  Moves = 2      ///< short relative moves that blend into each other
};

/// Why the jog ended.
enum class JogEnd {
  None = 0,
  Released = 1,  ///< no more keep-alives arrived
  IncrementDone = 2,
  JointLimit = 3,   ///< a joint would leave its range
  Singularity = 4,  ///< of shoulder, elbow or wrist
  Reach = 5,        ///< no posture reaches further
  JointSpeed = 6,   ///< a joint would exceed its rated speed: a singularity is near
  Longest = 7       ///< the maximum time of ten minutes is over
};

/// Maximum time from the last keep-alive to standstill of the arm; its parts: doc/actions/jog.md.
inline constexpr Duration kJogStandsWithin = std::chrono::milliseconds(250);
/// Part of it that is reserved for delays of the controller and of the network.
inline constexpr Duration kJogReserve = std::chrono::milliseconds(20);

struct JogGoal {
  static constexpr const char* kName = "jog";
  [[nodiscard]] static ErrorTable errors();
  /// Number of a frame or tool: the one that is active on the controller.
  static constexpr int kActive = -1;

  int mode = static_cast<int>(JogMode::Frame);
  /// -1, 0 or 1 each: X Y Z RX RY RZ, or J1..J6.
  std::array<int, 6> directions{};
  /// [%] of the reference: the rated speeds of the joints, or the typical speed and the turn speed of the
  /// TCP. 0: 10.
  double speed = 0;
  double increment_mm = 0;   ///< distance along each direction; both increments 0: hold to run
  double increment_deg = 0;  ///< angle about each axis, or of each joint
  int frame = 0;             ///< number in the tables, or kActive; not used with Axes
  int tool = 0;              ///< number in the tables, or kActive; not used with Axes
};

struct JogPlan;

/// Detail of the outcome.
struct JogReport {
  JogEnd ended_by = JogEnd::None;
  /// 0..5: joint that reached its limit or rated speed, or that identifies the singularity; -1: none.
  int joint = -1;
  std::string why;  ///< why the arm came to rest, and the remedy
  JogMeans means = JogMeans::None;
  double way_mm = 0;                              ///< distance moved
  double way_deg = 0;                             ///< angle moved
  std::shared_ptr<const JogPlan> plan = nullptr;  ///< set by plan(), for the run
};

/// Detail of the progress.
struct JogPlace {
  JogMeans means = JogMeans::None;
  double way_mm = 0;
  double way_deg = 0;
  /// Distance to the position where the arm would have to stop, as far as it was checked [mm, deg]; negative:
  /// no obstacle.
  double room_mm = -1;
  double room_deg = -1;
  std::optional<Duration> keep_alive_age;  ///< nullopt: an increment, which needs none
};

[[nodiscard]] GoalTraits traitsOf(const JogGoal& goal);
[[nodiscard]] std::vector<Failure> check(const JogGoal& goal);
/// Plans from the present position of the robot to the position where it would have to stop.
[[nodiscard]] Outcome plan(const JogGoal& goal, const PlanningScene& scene);
[[nodiscard]] std::unique_ptr<Run> runOf(const JogGoal& goal, GoalId id, const Outcome& planned, Instant now);

}  // namespace cobot_command::blocks
