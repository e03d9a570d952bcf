// Path loading, the instruction raM_Robot_Opr_LoadPath of Rockwell. Points of an array go to the robot
// through a bounded buffer. Consecutive goals move the robot as if they were one goal. doc/path.md.
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

/// How a path is sent: the values of the field. A caller may have sent any other value.
enum class Execution { Auto = 0, Script = 1, Pvt = 2 };
[[nodiscard]] const char* toString(Execution execution);

struct LoadPathGoal {
  static constexpr const char* kName = "load_path";
  [[nodiscard]] static ErrorTable errors();

  std::vector<path::PathPoint> path;             ///< 1..1000; only the points to load are checked
  std::string path_fault;                        ///< why the points could not be read; empty: they were read
  std::optional<path::PathRefusal> poses_fault;  ///< why placeAtPoses() could not create the points
  int start_index = 0;                           ///< first point to load
  int number_of_moves = 0;                       ///< number of points to load
  path::TrackingFlags enable_tracking{};  ///< the goal waits until the tracking objects have these states
  int execution = static_cast<int>(Execution::Auto);
  bool allow_approximation = false;  ///< SCRIPT may round values that a script cannot express
  int buffer_mode = 0;               ///< for other blocks; after another load_path the goal joins its chain
  double max_deviation = 0;          ///< limit [mm]; 0: none
  std::optional<arm::Pose> world;    ///< in the robot base [m], for targets in WORLD; nullopt: unknown
  std::string world_fault;           ///< why it is unknown
  bool check_only = false;
};

/// Creates the points of a goal from poses. `goal.path` holds a template, which has all values except the
/// position. It becomes one point for each of the `count` poses: absolute, Cartesian, in the robot base. If
/// the move_id of the template is not 0, each point gets this move_id plus its index, so that receivers of
/// the move_id alone (PathStatus) can distinguish the points. `pose_at` is called for the poses that
/// start_index and number_of_moves select, in order, up to the first invalid one. The error is stored in
/// `goal.poses_fault`, for check().
void placeAtPoses(LoadPathGoal& goal, std::size_t count,
                  const std::function<FramedPose(std::size_t index)>& pose_at);

struct LoadedPath;

/// Detail of the outcome, also if the goal was refused.
struct PathReport {
  int error_index = -1;                   ///< index in the array of the point that caused the error; -1: none
  int error_joint = -1;                   ///< 0..8: joint that caused the error; -1: none
  int method_id = 0;                      ///< number of the accepted goal: 1, 2, 3 ...; 0: not accepted
  Execution execution = Execution::Auto;  ///< the chosen one; AUTO: none was chosen
  std::string execution_reason;           ///< why it was chosen
  std::vector<std::string> approximations;  ///< differences between the script and the goal
  std::vector<int> blends_lost;             ///< points with blending at which the robot stopped
  double max_joint_deviation = 0;           ///< largest difference between measured and planned [deg]
  double max_path_deviation = 0;            ///< largest distance from the planned path [mm]
  Duration lag{};                           ///< delay with which the plan fits the measured motion best
  std::vector<StepReport> points;           ///< of the points that were checked, in order
  std::vector<JointPathPoint> joint_path;   ///< of the whole path, if it was only checked
  std::shared_ptr<const path::PathPreview> preview = nullptr;  ///< set by plan(), for display
  std::shared_ptr<const LoadedPath> loaded = nullptr;          ///< set by plan(), for the run
};

/// How the progress of a path is found.
enum class ProgressSource {
  Tag = 0,     ///< all progress was reported by queue tags
  Stream = 1,  ///< by the joints of the status stream
  Plan = 2     ///< by time
};

/// Detail of the progress: the states of the points that the goal loads, in the terms of the instruction.
/// Pending, queued, active and done points add up to number_of_moves.
struct PathPlace {
  bool loaded = false;          ///< the last point is in the buffer
  bool active = false;          ///< one of its points moves the robot
  int method_id = 0;            ///< as in PathReport
  int active_path_point = -1;   ///< index in the array; -1: none
  int active_move_id = 0;       ///< 0: none
  int pending_path_points = 0;  ///< not in the buffer yet
  int queued_path_points = 0;   ///< in the buffer and not active
  int done_path_points = 0;
  bool waits_for_tracking = false;  ///< the buffer has room for its first point, but its gate is closed
  ProgressSource source = ProgressSource::Plan;
};

/// Published by the run for all clients: the planned values of a chain's path, at its present progress.
/// Values of a point or of a motion are 0 while none moves the robot.
struct PathStatus {
  bool path_planner_active = false;  ///< a path is running, from its first motion to its end
  int active_move_id = 0;            ///< while two points blend, the first one; 0: none
  int active_interpolation = 0;      ///< of that point, as are the next values
  int active_type = 0;               ///< pose_type
  int active_type_id = 0;
  int active_ref_frame_type = 0;
  int active_ref_frame_id = 0;
  double active_move_percent = 0;    ///< completed share of its motion
  int blending_move_id = 0;          ///< point that the active one blends into; 0: none
  double blending_move_percent = 0;  ///< completed share of the motion of that point
  double linear_velocity = 0;        ///< of the flange [mm/s]
  double linear_acceleration = 0;    ///< [mm/s^2]
  double angular_velocity = 0;       ///< [deg/s]
  double angular_acceleration = 0;   ///< [deg/s^2]
  double feedrate = 100;             ///< [%]
  double feedrate_effective = 100;   ///< [%]
  bool gate_waits = false;           ///< a path waits for a tracking object
  ProgressSource source = ProgressSource::Plan;
};

[[nodiscard]] GoalTraits traitsOf(const LoadPathGoal& goal);
[[nodiscard]] std::vector<Failure> check(const LoadPathGoal& goal);
/// The tools and frames of its poses, as far as the tables have them.
[[nodiscard]] tables::Use usesOf(const LoadPathGoal& goal);
/// Plans all points of the goal, after the preceding chain if there is one.
[[nodiscard]] Outcome plan(const LoadPathGoal& goal, const PlanningScene& scene);
/// path::PathPreview, also of refused points; none: nothing was planned.
[[nodiscard]] Detail previewOf(const LoadPathGoal& goal, const Outcome& planned);
[[nodiscard]] std::unique_ptr<Run> runOf(const LoadPathGoal& goal, GoalId id, const Outcome& planned,
                                         Instant now);

}  // namespace cobot_command::blocks
