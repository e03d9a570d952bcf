// The one action whose messages are another package's: without that, when this is built, there is no server.
#include "cobot_command/blocks/follow_joint_trajectory.h"

#include "action_parts/serve.h"

#ifdef COBOT_HAS_CONTROL_MSGS

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <control_msgs/FollowJointTrajectoryAction.h>
#include <fmt/format.h>

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/blocks/shared/error_catalogue.h"
#include "cobot_command/blocks/shared/error_ids.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {
namespace {

using Goal = blocks::FollowJointTrajectoryGoal;
/// Where each joint of the robot stands in the message.
using Order = std::array<std::size_t, arm::kJointCount>;

std::optional<std::size_t> jointOf(const JointNames& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

std::string allowed(const JointNames& names) {
  return fmt::format("; allowed: each of {} once", fmt::join(names, ", "));
}

/// Sets `fault` where the names are not those of the robot.
Order orderOf(const std::vector<std::string>& given, const JointNames& names, std::string& fault) {
  Order order{};
  std::array<bool, arm::kJointCount> is_named{};
  for (std::size_t i = 0; i < given.size() && fault.empty(); ++i) {
    const auto joint = jointOf(names, given[i]);
    if (!joint) {
      fault = foreignText(given[i]) + " is not a joint of this robot" + allowed(names);
    } else if (std::exchange(is_named[*joint], true)) {
      fault = names[*joint] + " is listed twice" + allowed(names);
    } else {
      order[*joint] = i;
    }
  }
  const auto lacking = std::find(is_named.begin(), is_named.end(), false);
  if (fault.empty() && lacking != is_named.end()) {
    fault = names[static_cast<std::size_t>(lacking - is_named.begin())] + " is missing" + allowed(names);
  }
  return order;
}

/// In the robot's order; as they are when they are not six, for the core to refuse.
std::vector<double> sorted(const std::vector<double>& values, const Order& order) {
  if (values.size() != order.size()) return values;
  std::vector<double> in_order;
  in_order.reserve(order.size());
  for (const std::size_t from : order) in_order.push_back(values[from]);
  return in_order;
}

blocks::SixValues toTolerances(const std::vector<control_msgs::JointTolerance>& message,
                               const JointNames& names, std::string& fault) {
  blocks::SixValues tolerances{};
  for (const control_msgs::JointTolerance& tolerance : message) {
    if (const auto joint = jointOf(names, tolerance.name)) {
      tolerances[*joint] = tolerance.position;
    } else if (fault.empty()) {
      fault = "a tolerance is given for " + foreignText(tolerance.name) +
              ", which is not a joint of this robot" + allowed(names);
    }
  }
  return tolerances;
}

double untilNow(const ros::Time& stamp) {
  return stamp.isZero() ? 0.0 : (stamp - ros::Time::now()).toSec();
}

int codeOf(const blocks::Outcome& outcome) {
  using Result = control_msgs::FollowJointTrajectoryResult;
  switch (outcome.error_id) {
    case 0:
      return Result::SUCCESSFUL;
    case blocks::own_error::kJointNames:
      return Result::INVALID_JOINTS;
    case blocks::own_error::kStampOld:
      return Result::OLD_HEADER_TIMESTAMP;
    case blocks::own_error::kPathTolerance:
      return Result::PATH_TOLERANCE_VIOLATED;
    case blocks::own_error::kGoalTolerance:
      return Result::GOAL_TOLERANCE_VIOLATED;
    default:
      // There is no code for what fails on its way for another reason: none that says something else.
      return outcome.ending == blocks::Ending::Rejected ? Result::INVALID_GOAL : outcome.error_id;
  }
}

trajectory_msgs::JointTrajectoryPoint toMessage(const blocks::SixValues& positions, Duration time) {
  trajectory_msgs::JointTrajectoryPoint point;
  point.positions.assign(positions.begin(), positions.end());
  point.time_from_start = toRos(time);
  return point;
}

}  // namespace

Goal readGoal(const control_msgs::FollowJointTrajectoryGoal& message, const Lookups& /*lookups*/,
              const JointNames& names) {
  Goal goal;
  const auto& trajectory = message.trajectory;
  Order order{};
  const bool stops_only = trajectory.points.empty() && trajectory.joint_names.empty();
  if (!stops_only) order = orderOf(trajectory.joint_names, names, goal.names_fault);
  goal.points.reserve(trajectory.points.size());
  for (const trajectory_msgs::JointTrajectoryPoint& point : trajectory.points) {
    goal.points.push_back(
        {point.time_from_start.toSec(), sorted(point.positions, order), sorted(point.velocities, order)});
  }
  goal.path_tolerance = toTolerances(message.path_tolerance, names, goal.names_fault);
  goal.goal_tolerance = toTolerances(message.goal_tolerance, names, goal.names_fault);
  goal.goal_time_tolerance = message.goal_time_tolerance.toSec();
  goal.starts_in = untilNow(trajectory.header.stamp);
  return goal;
}

void fill(control_msgs::FollowJointTrajectoryResult& message, const blocks::Outcome& outcome,
          const FillSite& /*site*/) {
  message.error_code = codeOf(outcome);
  message.error_string = forPeople(outcome.error_description);
  if (outcome.error_id == 0) return;
  message.error_string = forPeople(fmt::format("{} {}; {}", blocks::errorNumber(outcome.error_id),
                                               outcome.error_description, outcome.remedy));
}

/// Before it moves, names alone.
void fill(control_msgs::FollowJointTrajectoryFeedback& message, const blocks::Progress& progress,
          const FillSite& site) {
  message.header.stamp = site.clocks.ros_now;
  message.joint_names.assign(site.joint_names.begin(), site.joint_names.end());
  const auto* const place = progress.detail.find<blocks::TrajectoryPlace>();
  if (place == nullptr) return;
  message.desired = toMessage(place->desired, place->time);
  message.desired.velocities.assign(place->desired_velocities.begin(), place->desired_velocities.end());
  if (!place->actual) return;
  message.actual = toMessage(*place->actual, place->time);
  blocks::SixValues error{};
  std::transform(place->desired.begin(), place->desired.end(), place->actual->begin(), error.begin(),
                 [](double desired, double actual) { return desired - actual; });
  message.error = toMessage(error, place->time);
}

template <>
bool saysNothing(const control_msgs::FollowJointTrajectoryResult& result) {
  return result.error_string.empty();
}
template <>
void say(control_msgs::FollowJointTrajectoryResult& result, const char* description, const char* remedy) {
  result.error_string = forPeople(fmt::format("{}; {}", description, remedy));
}

template <>
struct ActionOf<Goal> {
  using Type = control_msgs::FollowJointTrajectoryAction;
};
template std::unique_ptr<GoalListener> serve<Goal>(const ActionSite& site);

}  // namespace cobot_command::ros_adapter

#else

namespace cobot_command::ros_adapter {

template <>
std::unique_ptr<GoalListener> serve<blocks::FollowJointTrajectoryGoal>(const ActionSite& /*site*/) {
  return serveNobody();
}

}  // namespace cobot_command::ros_adapter

#endif
