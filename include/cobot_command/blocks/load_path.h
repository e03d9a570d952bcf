// Path loading, the instruction raM_Robot_Opr_LoadPath of Rockwell: points of an array go through a bounded
// buffer to the robot, several goals one behind the other as if they were one. doc/path.md.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/blocks/shared/block_parts.h"
#include "cobot_command/blocks/shared/goal_values.h"
#include "cobot_command/blocks/shared/run.h"
#include "cobot_command/blocks/shared/sequence_report.h"
#include "cobot_command/path/path_controls.h"
#include "cobot_command/path/path_point.h"
#include "cobot_command/path/path_preview.h"
#include "cobot_command/path/path_refusal.h"
#include "cobot_command/tables/table_store.h"

namespace cobot_command::blocks {

/// How a path is sent. The numbers of the field; a caller may have given any other.
enum class Execution { Auto = 0, Script = 1, Pvt = 2 };
[[nodiscard]] const char* toString(Execution execution);

struct LoadPathGoal {
  static constexpr const char* kName = "load_path";
  [[nodiscard]] static ErrorTable errors();

  std::vector<path::PathPoint> path;             ///< 1..1000; only those that are loaded are looked at
  std::string path_fault;                        ///< why the points could not be read; empty: they could
  std::optional<path::PathRefusal> poses_fault;  ///< why placeAtPoses() could not make them
  int start_index = 0;                           ///< the first one to load
  int number_of_moves = 0;                       ///< how many
  path::TrackingFlags enable_tracking{};         ///< it waits until the tracking objects are so
  int execution = static_cast<int>(Execution::Auto);
  bool allow_approximation = false;  ///< SCRIPT may round what a script cannot say
  int buffer_mode = 0;               ///< against other blocks; behind another load_path it joins its chain
  double max_deviation = 0;          ///< [mm]; 0: none
  std::optional<arm::Pose> world;    ///< in the robot base [m], for targets in WORLD; nothing: not known
  std::string world_fault;           ///< why it is not
  bool check_only = false;
};

/// Makes the points of poses: `goal.path` holds a template, which says all but where, and becomes one point
/// for each of `count` poses: absolute, Cartesian, in the robot base. With a template move_id that is not 0
/// each has that plus its index, so that those who are told only the move_id (PathStatus) can tell them
/// apart. `pose_at` is asked for the poses that start_index and number_of_moves load, in their order, up to
/// the first one that is wrong. What is wrong is left in `goal.poses_fault`, for check().
void placeAtPoses(LoadPathGoal& goal, std::size_t count,
                  const std::function<FramedPose(std::size_t index)>& pose_at);

struct LoadedPath;

/// Detail of its end; also where it was refused.
struct PathReport {
  int error_index = -1;                   ///< of the point to blame, in the array; -1: none
  int error_joint = -1;                   ///< 0..8; -1: none
  int method_id = 0;                      ///< 1, 2, 3 ... in the order of acceptance; 0: it was not accepted
  Execution execution = Execution::Auto;  ///< that was chosen; AUTO: none was
  std::string execution_reason;           ///< why
  std::vector<std::string> approximations;  ///< what a script says otherwise than the goal
  std::vector<int> blends_lost;             ///< points that were to be blended past, and were stopped at
  double max_joint_deviation = 0;           ///< measured against planned [deg]
  double max_path_deviation = 0;            ///< [mm]
  Duration lag{};                           ///< by which the plan fits the measured motion best
  std::vector<StepReport> points;           ///< of those that were looked at, in their order
  std::vector<JointPathPoint> joint_path;   ///< when it was checked, as a whole
  std::shared_ptr<const path::PathPreview> preview = nullptr;  ///< of a plan, for people
  std::shared_ptr<const LoadedPath> loaded = nullptr;          ///< the same, for the run that it becomes
};

/// Where the points are that a goal loads, in the words of the instruction. All add up to number_of_moves,
/// active ones included.
enum class ProgressSource {
  Tag = 0,     ///< all that is told was told by queue tags
  Stream = 1,  ///< by the joints of the status stream
  Plan = 2     ///< by time
};

/// Detail of its progress.
struct PathPlace {
  bool loaded = false;          ///< the last point was handed to the buffer
  bool active = false;          ///< one of its points moves the robot
  int method_id = 0;            ///< as in PathReport
  int active_path_point = -1;   ///< in the array; -1: none
  int active_move_id = 0;       ///< 0: none
  int pending_path_points = 0;  ///< not in the buffer yet
  int queued_path_points = 0;   ///< in the buffer, and not active
  int done_path_points = 0;
  bool waits_for_tracking = false;  ///< the buffer has a place for its first point, and its gate is closed
  ProgressSource source = ProgressSource::Plan;
};

/// Told of the run, to everyone: how the path of a chain goes, by its plan, as far as it has come. What is of
/// a point or of a motion is 0 while none moves the robot.
struct PathStatus {
  bool path_planner_active = false;  ///< a path is under way, from its first motion to its end
  int active_move_id = 0;            ///< while two blend of the outgoing one; 0: none
  int active_interpolation = 0;      ///< the numbers of that point
  int active_type = 0;               ///< pose_type
  int active_type_id = 0;
  int active_ref_frame_type = 0;
  int active_ref_frame_id = 0;
  double active_move_percent = 0;    ///< of its way
  int blending_move_id = 0;          ///< that it blends into; 0: none
  double blending_move_percent = 0;  ///< of the way of that one
  double linear_velocity = 0;        ///< of the flange [mm/s]
  double linear_acceleration = 0;    ///< [mm/s^2]
  double angular_velocity = 0;       ///< [deg/s]
  double angular_acceleration = 0;   ///< [deg/s^2]
  double feedrate = 100;             ///< [%]
  double feedrate_effective = 100;   ///< [%]
  bool gate_waits = false;           ///< for a tracking object
  ProgressSource source = ProgressSource::Plan;
};

[[nodiscard]] GoalTraits traitsOf(const LoadPathGoal& goal);
[[nodiscard]] std::vector<Failure> check(const LoadPathGoal& goal);
/// The tools and frames that its poses are given in; of those that the tables have.
[[nodiscard]] tables::Use usesOf(const LoadPathGoal& goal);
/// All its points, behind the chain in front of it where there is one.
[[nodiscard]] Outcome plan(const LoadPathGoal& goal, const PlanningScene& scene);
/// path::PathPreview, also of points that were refused; none: nothing was planned.
[[nodiscard]] Detail previewOf(const LoadPathGoal& goal, const Outcome& planned);
[[nodiscard]] std::unique_ptr<Run> runOf(const LoadPathGoal& goal, GoalId id, const Outcome& planned,
                                         Instant now);

}  // namespace cobot_command::blocks
