// Whatever path the planner takes: whoever makes its PVTs takes them, too. Fast points with hard ramps, as
// these bring cubics above the rated speeds.
#include <map>

#include "path_support.h"
#include <rapidcheck/gtest.h>

#include "cobot_command/path/path_pieces.h"
#include "cobot_command/planning/script_planner.h"

namespace cobot_command::path {
namespace {

/// Of the whole range, however far the test has come.
int any(int low, int behind) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, behind));
}

double uniform(int low, int high) {
  return any(100 * low, 100 * high + 1) / 100.0;
}

/// One of both ends as often as not.
double oftenAnEnd(int low, int high) {
  return any(0, 2) == 0 ? uniform(low, high) : (any(0, 2) == 0 ? low : high);
}

void giveDynamics(PathPoint& point) {
  const bool is_ptp = is(point.interpolation, Interpolation::Ptp);
  point.speed = is_ptp ? oftenAnEnd(20, 180) : uniform(50, 1500);
  point.acceleration = is_ptp ? uniform(500, 9000) : uniform(1000, 20000);
  point.deceleration = is_ptp ? uniform(500, 9000) : uniform(1000, 20000);
  point.acceleration_jerk = oftenAnEnd(0, 100);
  point.deceleration_jerk = oftenAnEnd(0, 100);
  point.profile_type = any(0, 4);
  point.orientation_speed = uniform(50, 180);
  point.orientation_acceleration = point.orientation_deceleration = uniform(500, 5000);
}

PathPoint anyPoint() {
  PathPoint point;
  point.move_type = number(MoveType::Incremental);
  point.interpolation = any(0, 3);
  point.target_type = point.interpolation == number(Interpolation::Linear) ? number(TargetType::Cartesian)
                                                                           : number(TargetType::Joint);
  for (std::size_t i = 0; i < 6; ++i) point.joints.at(i) = uniform(-40, 40);
  if (any(0, 2) == 0) point.joints = {uniform(-60, 60)};
  for (std::size_t i = 0; i < 3; ++i) point.pose.at(i) = uniform(-80, 80);
  point.termination_type = number(any(0, 5) == 0 ? Termination::Stop : Termination::Blend);
  point.command_tolerance = uniform(0, 100);
  giveDynamics(point);
  return point;
}

struct Seen {
  std::map<int, int> refusals;
  int taken = 0;
  std::size_t blends = 0;
};

void checkPieces(const PathPlan& plan, const PathScene& scene) {
  const auto pieces = piecesOf(plan, scene);
  if (!pieces) RC_FAIL(pieces.error().found);
  planning::ScriptPlanner maker(scene.arm, scene.start, {});
  std::size_t points = 0;
  Duration duration{};
  for (const PathPiece& piece : *pieces) {
    points += piece.plan.points().size();
    duration += piece.plan.duration();
    for (const auto& line : scriptOf(piece.block, {})) {
      if (const auto step = maker.append(line); !step) RC_FAIL(step.error().message);
    }
  }
  RC_ASSERT(points == plan.points().size());
  RC_ASSERT(duration == plan.duration());
  RC_ASSERT((maker.joints() - plan.at(plan.duration()).position).cwiseAbs().maxCoeff() < 1e-6);
}

class PathPieces : public Paths {
 protected:
  void check(int count, Seen& seen) const {
    std::vector<PathPoint> points;
    points.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) points.push_back(anyPoint());
    PathPlanner planner(scene);
    if (const auto refusal = planner.append(sectionOf(points))) {
      ++seen.refusals[refusal->error_id];
      RC_ASSERT(refusal->index >= 0 && refusal->index < count);
      return;
    }
    ++seen.taken;
    for (const PlannedPoint& point : planner.plan().points()) {
      seen.blends += point.overlap > Duration::zero() ? 1U : 0U;
    }
    checkPieces(planner.plan(), scene);
  }
};

TEST_F(PathPieces, ofAPathThatIsTakenAreTaken) {
  Seen seen;
  rc::check([&] {
    for (int i = 0; i < 20; ++i) check(any(1, 6), seen);
  });
  EXPECT_GT(seen.taken, 1000);
  EXPECT_GT(seen.blends, 1000U);
  EXPECT_GT(seen.refusals[path_error::kJointSpeed], 20);
}

}  // namespace
}  // namespace cobot_command::path
