// Steps cut in two on the same path (oracle 31).
#include "cobot_command/cell/plan/step_cut.h"

#include "planned_step.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace cobot_command::cell {
namespace {

using Make = Step (RandomSteps::*)(const Scene&);

struct Figures {
  int made = 0;
  int refused = 0;
  int long_ones = 0;  ///< both halves longer than their ramps
  double deviation = 0;
  double turn = 0;
  double corner = 0;
  Duration longer{};      ///< the most, of the long ones
  Duration any_longer{};  ///< of all
};

/// Of one that does not come to its top speed both ramps are all there is.
bool isLongerThanItsRamps(const Step& step, const Scene& scene) {
  const auto planned = plannedStep(step, scene);
  if (!planned) return false;
  const motion::Trajectory& motion = *planned->trajectory;
  return motion.duration() > motion.timeUp() + motion.timeDown() + std::chrono::microseconds(1);
}

/// The same scene, with the arm at the end of a step.
Scene behind(const Step& step, Scene scene) {
  scene.joints = plannedStep(step, scene)->trajectory->end().position;
  return scene;
}

void addCut(RandomSteps& random, Make make, Figures& figures) {
  const Scene scene = random.scene();
  const Step step = (random.*make)(scene);
  const auto planned = plannedStep(step, scene);
  if (!planned) return;
  const double share = random.within(0.05, 0.95);
  const Duration time = fromSeconds(share * toSeconds(planned->trajectory->duration()));
  const auto cut = cutStep(tm5(), step, *planned, 1.0, time);
  if (!cut) {
    ++figures.refused;
    return;
  }
  ++figures.made;
  figures.deviation = std::max(figures.deviation, cut->measure.deviation);
  figures.turn = std::max(figures.turn, cut->measure.turn);
  figures.corner = std::max(figures.corner, cut->measure.corner);
  figures.any_longer = std::max(figures.any_longer, cut->measure.longer);
  if (!isLongerThanItsRamps(cut->before, scene) ||
      !isLongerThanItsRamps(cut->behind, behind(cut->before, scene))) {
    return;
  }
  ++figures.long_ones;
  figures.longer = std::max(figures.longer, cut->measure.longer);
}

Figures figuresOf(const char* kind, Make make, int count) {
  RandomSteps random(31);
  Figures figures;
  while (figures.made + figures.refused < count) addCut(random, make, figures);
  const auto ms = [](Duration time) { return 1000 * toSeconds(time); };
  fmt::print(
      "{}: {} cut, {} not; deviation {:.2e} m, {:.2e} rad; at most {:.4f} ms longer in {} with long "
      "halves, {:.1f} ms in any; passed at speed {:.2f} mm beside the path\n",
      kind, figures.made, figures.refused, figures.deviation, figures.turn, ms(figures.longer),
      figures.long_ones, ms(figures.any_longer), 1000 * figures.corner);
  return figures;
}

void expectOracle31(const Figures& figures) {
  EXPECT_LE(figures.deviation, 1e-6);
  EXPECT_LE(figures.turn, 1e-6);
  EXPECT_LE(figures.longer, std::chrono::milliseconds(1));
  EXPECT_GT(figures.long_ones, 10);
}

TEST(RandomPtps, keepTheirPathAndTimeWhenTheyAreCut) {
  const Figures figures = figuresOf("PTP", &RandomSteps::ptp, 200);
  expectOracle31(figures);
  EXPECT_EQ(figures.refused, 0);
  EXPECT_LT(figures.corner, 1e-6) << "both halves are on one straight line of the joints";
}
TEST(RandomLines, keepTheirPathAndTimeWhenTheyAreCut) {
  const Figures figures = figuresOf("Line", &RandomSteps::line, 200);
  expectOracle31(figures);
  EXPECT_EQ(figures.refused, 0);
}
TEST(RandomRelativeMoves, keepTheirPathAndTimeWhenTheyAreCut) {
  const Figures figures = figuresOf("relative", &RandomSteps::relative, 200);
  expectOracle31(figures);
  EXPECT_EQ(figures.refused, 0);
}
TEST(RandomCircles, keepTheirPathAndTimeWhenTheyAreCut) {
  const Figures figures = figuresOf("Circle", &RandomSteps::circle, 200);
  expectOracle31(figures);
  EXPECT_LT(figures.refused, figures.made / 10);
}

Step lineOf120Mm() {
  blocks::MoveRelativeGoal goal;
  goal.movement_command = static_cast<int>(blocks::Movement::Line);
  goal.data_format = static_cast<int>(blocks::RelativeFormat::Car);
  goal.target = {0, 0, 120, 0, 0, 0};
  goal.speed = 100;
  goal.accel_time = 200;
  goal.blending_enable = true;
  goal.blending_value = 30;
  Step step;
  step.goal = goal;
  return step;
}

TEST(AStepThatIsCut, keepsItsBlendBehindTheCutAndBlendsFullyAtIt) {
  const auto cut = cutStep(tm5(), lineOf120Mm(), *plannedStep(lineOf120Mm(), Scene()), 1.0,
                           std::chrono::milliseconds(700));
  ASSERT_TRUE(cut);
  const auto& before = std::get<blocks::MoveAbsoluteGoal>(cut->before.goal);
  const auto& behind = std::get<blocks::MoveAbsoluteGoal>(cut->behind.goal);
  EXPECT_EQ(before.data_format, static_cast<int>(blocks::AbsoluteFormat::Cap)) << "radii know no 100 %";
  EXPECT_TRUE(before.blending_enable);
  EXPECT_EQ(before.blending_value, 100);
  EXPECT_EQ(behind.data_format, static_cast<int>(blocks::AbsoluteFormat::Car));
  EXPECT_TRUE(behind.blending_enable);
  EXPECT_EQ(behind.blending_value, 30);
  EXPECT_NEAR(cut->progress, 0.5, 1e-6);
}

TEST(AStepThatIsCut, doesWhatFollowsItOnlyBehindTheCut) {
  Step step = lineOf120Mm();
  std::get<blocks::MoveRelativeGoal>(step.goal).blending_enable = false;
  step.attach = "sheet";
  step.dwell = 0.5;
  step.output.emplace();
  step.input.emplace();
  const auto cut = cutStep(tm5(), step, *plannedStep(step, Scene()), 1.0, std::chrono::milliseconds(700));
  ASSERT_TRUE(cut);
  EXPECT_TRUE(cut->before.attach.empty());
  EXPECT_EQ(cut->before.dwell, 0);
  EXPECT_FALSE(cut->before.output || cut->before.input);
  EXPECT_EQ(cut->behind.attach, "sheet");
  EXPECT_EQ(cut->behind.dwell, 0.5);
  EXPECT_TRUE(cut->behind.output && cut->behind.input);
}

TEST(AStep, isNotCutAtItsBeginningOrEnd) {
  const auto planned = *plannedStep(lineOf120Mm(), Scene());
  EXPECT_FALSE(cutStep(tm5(), lineOf120Mm(), planned, 1.0, Duration::zero()));
  EXPECT_FALSE(cutStep(tm5(), lineOf120Mm(), planned, 1.0, planned.trajectory->duration()));
}

TEST(AnArc, isNotCutWhereAHalfIsTooShortToBeKnownByThreePoints) {
  blocks::MoveCircleGoal goal;
  const arm::Pose start = Scene().start();
  goal.arc_point = arm::toControllerPose(start * arm::toPose({50, 50, 0, 0, 0, 0}));
  goal.end_point = arm::toControllerPose(start * arm::toPose({100, 0, 0, 0, 0, 0}));
  goal.speed = 10;
  goal.accel_time = 200;
  Step step;
  step.goal = goal;
  const auto planned = *plannedStep(step, Scene());
  EXPECT_FALSE(cutStep(tm5(), step, planned, 1.0, std::chrono::milliseconds(10)));
  EXPECT_TRUE(cutStep(tm5(), step, planned, 1.0, planned.trajectory->duration() / 2));
}

TEST(AScript, isLeftWhole) {
  Step step = lineOf120Mm();
  const auto planned = *plannedStep(step, Scene());
  step.goal = blocks::RunScriptGoal();
  EXPECT_FALSE(cutStep(tm5(), step, planned, 1.0, std::chrono::milliseconds(700)));
}

}  // namespace
}  // namespace cobot_command::cell
