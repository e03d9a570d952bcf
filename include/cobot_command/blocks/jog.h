// To move the arm by hand: for as long as somebody says so, or by a small step. GroupJog of SRCI.
// doc/actions/jog.md.
//
// Hold to run is its own dead man's switch: without the next keep-alive the arm stands within
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
  Tool = 1,   ///< of the tool
  Axes = 2    ///< of the joints
};

/// By which the controller is told.
enum class JogMeans {
  None = 0,
  Velocity = 1,  ///< continuous velocities, which need a licence
  Moves = 2      ///< short relative moves that blend into each other
};

/// Why it has come to rest.
enum class JogEnd {
  None = 0,
  Released = 1,       ///< no keep-alive came any more
  IncrementDone = 2,  ///< the step was made
  JointLimit = 3,     ///< a joint would leave its range
  Singularity = 4,    ///< of shoulder, elbow or wrist
  Reach = 5,          ///< no posture reaches further
  JointSpeed = 6,     ///< a joint would have to be faster than rated: a singularity is near
  Longest = 7         ///< ten minutes are over
};

/// From the last keep-alive until the arm stands, at the latest; how that is shared out: doc/actions/jog.md.
inline constexpr Duration kJogStandsWithin = std::chrono::milliseconds(250);
/// Of these: for what a controller, and the way to it, are late.
inline constexpr Duration kJogReserve = std::chrono::milliseconds(20);

struct JogGoal {
  static constexpr const char* kName = "jog";
  [[nodiscard]] static ErrorTable errors();
  /// Number of frame or tool: those that are active on the controller.
  static constexpr int kActive = -1;

  int mode = static_cast<int>(JogMode::Frame);
  /// -1, 0, 1: X Y Z RX RY RZ; or J1..J6.
  std::array<int, 6> directions{};
  /// Of the reference [%]: the rated speeds of the joints; or typical speed and turn speed of the TCP. 0: 10.
  double speed = 0;
  double increment_mm = 0;   ///< of the way; both 0: hold to run
  double increment_deg = 0;  ///< of the turn, or of each joint
  int frame = 0;             ///< of the tables; kActive. Not with Axes
  int tool = 0;              ///< the same
};

struct JogPlan;

/// Detail of its end.
struct JogReport {
  JogEnd ended_by = JogEnd::None;
  int joint = -1;   ///< 0..5 that has come to its limit, or names the singularity; -1: none
  std::string why;  ///< it came to rest, and the way out
  JogMeans means = JogMeans::None;
  double way_mm = 0;                              ///< that was made
  double way_deg = 0;                             ///< the same
  std::shared_ptr<const JogPlan> plan = nullptr;  ///< of a plan, for the run that it becomes
};

/// Detail of its progress.
struct JogPlace {
  JogMeans means = JogMeans::None;
  double way_mm = 0;
  double way_deg = 0;
  /// To where it would have to come to rest, as far as was looked: negative: nothing is in the way [mm, deg].
  double room_mm = -1;
  double room_deg = -1;
  std::optional<Duration> keep_alive_age;  ///< nothing: it needs none
};

[[nodiscard]] GoalTraits traitsOf(const JogGoal& goal);
[[nodiscard]] std::vector<Failure> check(const JogGoal& goal);
/// From where the robot stands, to where it would have to come to rest.
[[nodiscard]] Outcome plan(const JogGoal& goal, const PlanningScene& scene);
[[nodiscard]] std::unique_ptr<Run> runOf(const JogGoal& goal, GoalId id, const Outcome& planned, Instant now);

}  // namespace cobot_command::blocks
