#include "cobot_command/motion/planner.h"

#include <utility>

#include "kinds/path_motion.h"
#include "kinds/pline_motion.h"
#include "kinds/ptp_motion.h"
#include "kinds/pvt_motion.h"
#include "kinds/ramped_motion.h"
#include "kinds/relative_motion.h"
#include "kinds/wrist_motion.h"
#include "paths/input_check.h"

namespace cobot_command::motion {
namespace {

struct Planner {
  const arm::ArmModel& arm;
  const arm::JointVector& start;
  const Setting& setting;

  auto operator()(const Ptp& ptp) const { return planPtp(arm, start, ptp, setting); }
  auto operator()(const Line& line) const { return planLine(arm, start, line, setting); }
  auto operator()(const Circle& circle) const { return planCircle(arm, start, circle, setting); }
  auto operator()(const MovePtp& move) const {
    return planPtp(arm, start, absolute(move, arm, start, setting), setting);
  }
  auto operator()(const MoveLine& move) const {
    return planLine(arm, start, absolute(move, arm, start, setting), setting);
  }
  auto operator()(const PLine& line) const { return planPLine(arm, start, line, setting); }
  auto operator()(const MovePLine& move) const {
    return planPLine(arm, start, absolute(move, arm, start, setting), setting);
  }
  auto operator()(const JointMove& move) const { return planJointMove(arm, start, move, setting); }
  auto operator()(const StraightMove& move) const { return planStraightMove(arm, start, move, setting); }
  auto operator()(const WristMove& move) const { return planWristMove(arm, start, move, setting); }
  auto operator()(const ArcMove& move) const { return planArcMove(arm, start, move, setting); }
  auto operator()(const Pvt& pvt) const { return planPvt(arm, start, pvt, setting); }
};

}  // namespace

Result<TrajectoryPtr, Refusal> plan(const arm::ArmModel& arm, const arm::JointVector& start,
                                    const Command& command, const Setting& setting) {
  if (auto wrong = checkInput(start, command, setting)) {
    return refuse(std::move(*wrong));
  }
  return std::visit(Planner{arm, start, setting}, command);
}

}  // namespace cobot_command::motion
