#include "clients/plan.h"

namespace cobot_command::rviz_plugin {

Plan planOf(const std::vector<cobot_command::StepReport>& steps) {
  Plan plan;
  for (const cobot_command::StepReport& step : steps) {
    plan.path.joint_names = step.joint_path.joint_names;
    plan.path.points.insert(plan.path.points.end(), step.joint_path.points.begin(),
                            step.joint_path.points.end());
    if (step.error_id == 0) continue;
    plan.reason = step.error_description;
    if (step.offending_point_valid) plan.offending = step.offending_point;
    break;
  }
  return plan;
}

}  // namespace cobot_command::rviz_plugin
