#include "cobot_command/blocks/load_path.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "action_parts/goal_parts.h"
#include "action_parts/outcome_parts.h"
#include "action_parts/serve.h"

#include "cobot_command/LoadPathAction.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/path/path_planner.h"

namespace cobot_command::ros_adapter {
namespace {

path::PathPoint toPoint(const cobot_command::PathPoint& message) {
  path::PathPoint point;
  point.move_id = message.move_id;
  point.move_type = message.move_type;
  point.target_type = message.target_point_type;
  point.interpolation = message.interpolation_type;
  point.pose = toSix(message.pose);
  point.pose_type = message.pose_type;
  point.pose_id = message.pose_id;
  point.ref_frame_type = message.ref_frame_type;
  point.ref_frame_id = message.ref_frame_id;
  std::copy(message.joints.begin(), message.joints.end(), point.joints.begin());
  point.via_pose = toSix(message.via_pose);
  point.termination_type = message.termination_type;
  point.command_tolerance = message.command_tolerance;
  point.robot_configuration = message.robot_configuration;
  point.profile_type = message.profile_type;
  point.speed = message.speed;
  point.acceleration = message.acceleration;
  point.deceleration = message.deceleration;
  point.acceleration_jerk = message.acceleration_jerk;
  point.deceleration_jerk = message.deceleration_jerk;
  point.orientation_speed = message.orientation_speed;
  point.orientation_acceleration = message.orientation_acceleration;
  point.orientation_deceleration = message.orientation_deceleration;
  point.tracking_axis_position = message.tracking_axis_position;
  return point;
}

/// More than there may be: they are counted, and nothing more.
std::vector<path::PathPoint> toPoints(const std::vector<cobot_command::PathPoint>& message) {
  std::vector<path::PathPoint> points;
  if (message.size() > path::kMostPoints) {
    points.resize(message.size());
    return points;
  }
  points.reserve(message.size());
  for (const cobot_command::PathPoint& point : message) points.push_back(toPoint(point));
  return points;
}

void readFile(blocks::LoadPathGoal& goal, const std::string& file, const Lookups& lookups) {
  auto points = lookups.points(file);
  if (!points) {
    goal.path_fault = foreignText(file) + ": the file was not read within the time limit";
  } else if (*points) {
    goal.path = std::move(**points);
  } else {
    goal.path_fault = points->error();
  }
}

/// Those of a goal are mostly in one frame, and are to be where it was at one moment: each frame and stamp is
/// looked up once. In the robot base without a name.
class PosesOf {
 public:
  PosesOf(const std::vector<geometry_msgs::PoseStamped>& poses, const FrameLookup& frames)
      : poses_(poses), frames_(frames) {}

  blocks::FramedPose operator()(std::size_t index) {
    const geometry_msgs::PoseStamped& pose = poses_[index];
    return toFramedPose(pose, placeOf(pose.header));
  }

 private:
  FramePlace placeOf(const std_msgs::Header& header) {
    if (header.frame_id.empty()) return {arm::Pose(arm::Pose::Identity()), ""};
    const auto [known, is_new] = places_.try_emplace({header.frame_id, header.stamp});
    if (is_new) known->second = frames_(header);
    return known->second;
  }

  const std::vector<geometry_msgs::PoseStamped>& poses_;
  const FrameLookup& frames_;
  std::map<std::pair<std::string, ros::Time>, FramePlace> places_;
};

bool isInWorld(const path::PathPoint& point) {
  return path::is(point.ref_frame_type, path::Reference::World) &&
         !path::is(point.target_type, path::TargetType::Joint);
}

/// As the goal comes, as every frame of a goal is.
void findTheWorld(blocks::LoadPathGoal& goal, const Lookups& lookups) {
  if (!std::any_of(goal.path.begin(), goal.path.end(), isInWorld)) return;
  std_msgs::Header header;
  header.frame_id = lookups.world_frame;
  FramePlace place = lookups.frames(header);
  goal.world = std::move(place.in_robot_base);
  goal.world_fault = std::move(place.fault);
}

}  // namespace

blocks::LoadPathGoal toGoal(const cobot_command::LoadPathGoal& message, const Lookups& lookups) {
  blocks::LoadPathGoal goal;
  goal.start_index = message.start_index;
  goal.number_of_moves = message.number_of_moves;
  goal.enable_tracking = {message.enable_tracking_0 != 0, message.enable_tracking_1 != 0};
  goal.execution = message.execution;
  goal.allow_approximation = message.allow_approximation != 0;
  goal.buffer_mode = message.buffer_mode;
  goal.max_deviation = message.max_deviation;
  goal.check_only = message.check_only != 0;
  if (message.path_file.empty()) {
    goal.path = toPoints(message.path);
    if (!message.poses.empty()) {
      blocks::placeAtPoses(goal, message.poses.size(), PosesOf(message.poses, lookups.frames));
    }
  } else if (!message.poses.empty()) {
    goal.path_fault = "both path_file and poses are given; give the template of the poses in path";
  } else if (!message.path.empty()) {
    goal.path_fault = "both path_file and path are given; give one of them";
  } else {
    readFile(goal, message.path_file, lookups);
  }
  findTheWorld(goal, lookups);
  return goal;
}

void fill(cobot_command::LoadPathResult& message, const blocks::Outcome& outcome, const FillSite& site) {
  fillEnd(message, outcome);
  const auto& report = outcome.detail.as<blocks::PathReport>();
  message.error_index = report.error_index;
  message.error_joint = report.error_joint;
  message.method_id = report.method_id;
  message.execution = static_cast<std::uint8_t>(report.execution);
  message.execution_reason = report.execution_reason;
  message.approximations = report.approximations;
  message.blends_lost.assign(report.blends_lost.begin(), report.blends_lost.end());
  message.planned_duration = toRos(outcome.planned);
  message.actual_duration = toRos(outcome.actual);
  message.max_joint_deviation = report.max_joint_deviation;
  message.max_path_deviation = report.max_path_deviation;
  message.lag = toRos(report.lag);
  for (const blocks::StepReport& point : report.points) {
    message.points.push_back(toMessage(point, site.joint_names));
  }
  message.joint_path = toMessage(report.joint_path, site.joint_names);
  message.final_joints_valid = outcome.final_joints_deg.has_value();
  if (outcome.final_joints_deg) {
    std::copy(outcome.final_joints_deg->begin(), outcome.final_joints_deg->end(),
              message.final_joints.begin());
  }
  message.final_pose_valid = outcome.final_pose_mm_deg.has_value();
  if (outcome.final_pose_mm_deg) message.final_pose = toTransformation(*outcome.final_pose_mm_deg);
}

void fill(cobot_command::LoadPathFeedback& message, const blocks::Progress& progress,
          const FillSite& /*site*/) {
  fillTurn(message, progress);
  message.progress = progress.fraction;
  message.remaining = toRos(progress.remaining);
  message.planned_duration = toRos(progress.planned);
  const auto& place = progress.detail.as<blocks::PathPlace>();
  message.method_id = place.method_id;
  message.loaded = place.loaded;
  message.active = place.active;
  message.active_path_point = place.active_path_point;
  message.active_move_id = place.active_move_id;
  message.pending_path_points = place.pending_path_points;
  message.queued_path_points = place.queued_path_points;
  message.done_path_points = place.done_path_points;
  message.progress_source = static_cast<std::uint8_t>(place.source);
}

template <>
struct ActionOf<blocks::LoadPathGoal> {
  using Type = cobot_command::LoadPathAction;
};
template std::unique_ptr<GoalListener> serve<blocks::LoadPathGoal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter
