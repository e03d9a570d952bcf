// Commands that the arm cannot make, or of which that is not known.

#include <string>
#include <vector>

#include "block_goals.h"
#include "catalogue_scenarios.h"
#include "core_rig.h"
#include "status_frames.h"
#include "wire_faults.h"

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;

/// A straight way in the robot base that cannot be gone.
struct Way {
  std::string model;
  SixValues joints_deg;  ///< of its start
  std::array<double, 3> offset_mm;
  double speed;  ///< [mm/s]
};

constexpr SixValues kHome{0, 0, 90, 0, 90, 0};

SixValues startOf(const Way& way) {
  return arm::toControllerPose(
      arm::forwardKinematics(*arm::ArmModel::named(way.model), arm::toJointVector(way.joints_deg)));
}

SixValues endOf(const Way& way, double share = 1) {
  SixValues pose = startOf(way);
  for (std::size_t i = 0; i < 3; ++i) pose[i] += share * way.offset_mm[i];
  return pose;
}

MoveAbsoluteGoal lineAlong(const Way& way) {
  return with<MoveAbsoluteGoal>([&](auto& g) {
    g.movement_command = static_cast<int>(Movement::Line);
    g.data_format = static_cast<int>(AbsoluteFormat::Cap);
    g.target = endOf(way);
    g.speed = way.speed;
  });
}

MoveRelativeGoal relativeAlong(const Way& way) {
  return with<MoveRelativeGoal>([&](auto& g) {
    g.movement_command = static_cast<int>(Movement::Line);
    g.data_format = static_cast<int>(RelativeFormat::Cap);
    g.target = {way.offset_mm[0], way.offset_mm[1], way.offset_mm[2], 0, 0, 0};
    g.speed = way.speed;
  });
}

/// Nearly the same way, bent.
MoveCircleGoal circleAlong(const Way& way) {
  return with<MoveCircleGoal>([&](auto& g) {
    g.data_format = static_cast<int>(CircleFormat::Cap);
    g.arc_point = endOf(way, 0.5);
    g.arc_point[0] += 20;
    g.arc_point[2] += 20;
    g.end_point = endOf(way);
    g.speed = way.speed;
  });
}

RunScriptGoal scriptOf(const MoveAbsoluteGoal& move) {
  RunScriptGoal goal;
  goal.script = script::toText(commandOf(move));
  return goal;
}

Outcome plannedFrom(const std::string& model, const SixValues& joints_deg, const Goal& goal) {
  CoreRig rig(*arm::ArmModel::named(model), link::LinkSettings{});
  rig.connect();
  rig.status(StatusFrames().with(
      protocol::item::ofFloats("Joint_Angle", std::vector<float>(joints_deg.begin(), joints_deg.end()))));
  const GoalId id = rig.submit(goal);
  EXPECT_EQ(rig.scripts_sent, 0);
  return endOf(rig, id);
}

void add(Scenarios& all, int id, const std::string& model, const SixValues& joints_deg, const Goal& goal) {
  all[{static_cast<Block>(goal.index()), id}] = [=] { return plannedFrom(model, joints_deg, goal); };
}

void addAll(Scenarios& all, int id, const Way& way) {
  for (const Goal& goal : {Goal(lineAlong(way)), Goal(relativeAlong(way)), Goal(circleAlong(way)),
                           Goal(scriptOf(lineAlong(way)))}) {
    add(all, id, way.model, way.joints_deg, goal);
  }
}

/// The tool turned half round about its own axis.
void addHalfTurns(Scenarios& all) {
  const Way way{"tm5-900", kHome, {0, 0, -50}, 50};
  auto absolute = lineAlong(way);
  auto relative = relativeAlong(way);
  auto circle = circleAlong(way);
  absolute.target[5] += 180;
  relative.target[5] = 180;
  circle.end_point[5] += 180;
  for (const Goal& goal : {Goal(absolute), Goal(relative), Goal(circle), Goal(scriptOf(absolute))}) {
    add(all, own_error::kAmbiguousTurn, way.model, way.joints_deg, goal);
  }
}

void addJointLimits(Scenarios& all) {
  const auto absolute = with<MoveAbsoluteGoal>([](auto& g) {
    g.data_format = static_cast<int>(AbsoluteFormat::Jpp);
    g.target = {0, 0, 170, 0, 90, 0};
  });
  const auto relative = with<MoveRelativeGoal>([](auto& g) {
    g.data_format = static_cast<int>(RelativeFormat::Jpp);
    g.target = {0, 0, 80, 0, 0, 0};
  });
  const auto turned = [](double j1) { return startOf({"tm5-900", {j1, 0, 90, 0, 90, 0}, {}, 0}); };
  const auto circle = with<MoveCircleGoal>([&](auto& g) {  // around the base, past the end of J1
    g.arc_point = turned(265);
    g.end_point = turned(280);
  });
  add(all, own_error::kJointLimit, "tm5-900", kHome, absolute);
  add(all, own_error::kJointLimit, "tm5-900", kHome, relative);
  add(all, own_error::kJointLimit, "tm5-900", kHome, scriptOf(absolute));
  add(all, own_error::kJointLimit, "tm5-900", {260, 0, 90, 0, 90, 0}, circle);
}

/// check_only where something is not known that sending it would not need.
template <class Move>
void addUnknown(Scenarios& all) {
  const Goal goal = with<Move>([](auto& g) { g.check_only = true; });
  all[{static_cast<Block>(goal.index()), own_error::kStartUnknown}] = [=] {
    CoreRig rig(*arm::ArmModel::named("tm5-900"));
    return *rig.outcome(rig.submit(goal));
  };
  all[{static_cast<Block>(goal.index()), own_error::kNoModel}] = [=] {
    CoreRig rig;
    return *rig.outcome(rig.submit(goal));
  };
}

/// The error of the step of a sequence that fails.
template <class Move>
void addStep(Scenarios& all, int id, const std::vector<SequenceStep>& before, const Move& move) {
  all[{static_cast<Block>(Goal(move).index()), id}] = [=] {
    CoreRig rig(*arm::ArmModel::named("tm5-900"));
    CheckSequenceGoal sequence;
    sequence.steps = before;
    sequence.steps.emplace_back(move);
    sequence.start_joints.assign(kHome.begin(), kHome.end());
    const Outcome whole = *rig.outcome(rig.submit(sequence));
    Outcome outcome;
    outcome.error_id = whole.detail.as<SequenceReport>().steps.back().error_id;
    outcome.error_description = whole.detail.as<SequenceReport>().steps.back().error_description;
    outcome.remedy = whole.remedy;
    return outcome;
  };
}

/// In a base of the project that nobody has told the value of.
void addBaseUnknown(Scenarios& all) {
  const std::vector<SequenceStep> before{with<ChangeBaseGoal>([](auto& g) { g.base_name = "Table"; })};
  const auto add = [&](const auto& move) { addStep(all, own_error::kBaseUnknown, before, move); };
  add(with<MoveAbsoluteGoal>([](auto& g) { g.target_pose = framedPose(); }));
  add(good<MoveRelativeGoal>());
  add(with<MoveCircleGoal>([](auto& g) { g.end_pose = framedPose(); }));
}

/// Two metres of radius on ten centimetres of way.
void addBlends(Scenarios& all) {
  const Way way{"tm5-900", kHome, {0, 0, -100}, 100};
  auto absolute = lineAlong(way);
  absolute.data_format = static_cast<int>(AbsoluteFormat::Car);
  auto relative = relativeAlong(way);
  relative.data_format = static_cast<int>(RelativeFormat::Tar);
  absolute.blending_enable = relative.blending_enable = true;
  absolute.blending_value = relative.blending_value = 2000;
  addStep(all, own_error::kBlendingTooLarge, {}, absolute);
  addStep(all, own_error::kBlendingTooLarge, {}, relative);
}

}  // namespace

Scenarios planningScenarios() {
  Scenarios all;
  addAll(all, own_error::kUnreachable, {"tm5-900", kHome, {0, 0, -2000}, 100});
  addAll(all, own_error::kPoseBits, {"tm5-900", {10, 15, 80, -5, 85, 20}, {3000, 0, 0}, 100});
  addAll(all, own_error::kJointSpeed, {"tm12", {0, -40, 130, 0, 90, 0}, {0, 300, 0}, 1300});
  addAll(all, own_error::kSingular, {"tm5-900", {0, 0, 0, 0, 0, 0}, {100, 0, -100}, 10});
  addAll(all, own_error::kNotPlannable, {"tm5-900", kHome, {90000, 0, 0}, 1});
  addHalfTurns(all);
  addJointLimits(all);
  addUnknown<MoveAbsoluteGoal>(all);
  addUnknown<MoveRelativeGoal>(all);
  addUnknown<MoveCircleGoal>(all);
  addBaseUnknown(all);
  addBlends(all);
  return all;
}

}  // namespace cobot_command::testing
