// What planning a path costs. 1,000 points must be checked in at most 1/1,000 of the time that they take; the
// counter moved_per_planned shows the inverse. With the pieces that are sent for it, each checked as its PVT;
// in one goal, and as a chain. And what it costs to make the lines of its PVT.
#include <benchmark/benchmark.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/path/path_pieces.h"
#include "cobot_command/path/path_planner.h"
#include "cobot_command/path/pvt_block.h"

namespace cobot_command::path {
namespace {

const PathScene& scene() {
  static const PathScene made{*arm::ArmModel::named("tm5-900"), arm::toJointVector({0, 0, 90, 0, 90, 0})};
  return made;
}

/// Rows of lines of 10 mm at 100 mm/s, all blended.
PathSection thousandPoints() {
  const arm::ControllerPose from = arm::toControllerPose(arm::forwardKinematics(scene().arm, scene().start));
  PathSection section;
  for (int i = 0; i < static_cast<int>(kMostPoints); ++i) {
    const int row = i / 20;
    const int column = i % 20;
    PathPoint point;
    point.target_type = static_cast<int>(TargetType::Cartesian);
    point.interpolation = static_cast<int>(Interpolation::Linear);
    point.pose = from;
    point.pose[1] += 10.0 * (row % 2 == 0 ? column : 19 - column) - 95.0;
    point.pose[2] += 10.0 * (row % 25) - 100.0;
    point.termination_type = static_cast<int>(Termination::Blend);
    point.command_tolerance = 2;
    point.speed = 100;
    point.acceleration = point.deceleration = 500;
    point.orientation_speed = 90;
    point.orientation_acceleration = point.orientation_deceleration = 360;
    section.points.push_back(point);
  }
  section.number_of_moves = static_cast<int>(kMostPoints);
  return section;
}

void planThousandPoints(benchmark::State& state) {
  const PathSection section = thousandPoints();
  double moved = 0.0;
  for (auto _ : state) {
    PathPlanner planner(scene());
    if (const auto refusal = planner.append(section)) state.SkipWithError(refusal->found.c_str());
    moved += toSeconds(planner.plan().duration());
  }
  state.counters["moved_per_planned"] = benchmark::Counter(moved, benchmark::Counter::kIsRate);
}
BENCHMARK(planThousandPoints)->Unit(benchmark::kMillisecond);

/// Up to what is sent: planned, sampled, and the PVT planned as whoever makes it does.
void planThousandPointsInPieces(benchmark::State& state) {
  const PathSection section = thousandPoints();
  double moved = 0.0;
  for (auto _ : state) {
    PathPlanner planner(scene());
    if (const auto refusal = planner.append(section)) state.SkipWithError(refusal->found.c_str());
    const auto pieces = piecesOf(planner.plan(), scene(), {motion::kLeastSegment, 20000});
    if (!pieces) state.SkipWithError(pieces.error().found.c_str());
    moved += toSeconds(planner.plan().duration());
  }
  state.counters["moved_per_planned"] = benchmark::Counter(moved, benchmark::Counter::kIsRate);
}
BENCHMARK(planThousandPointsInPieces)->Unit(benchmark::kMillisecond);

/// Goals of 10 points, of which the last one stops; each is tried in a copy, as a run does.
void planThousandPointsAsAChain(benchmark::State& state) {
  PathSection section = thousandPoints();
  for (std::size_t i = 9; i < kMostPoints; i += 10) {
    section.points[i].termination_type = static_cast<int>(Termination::Stop);
  }
  section.number_of_moves = 10;
  double moved = 0.0;
  for (auto _ : state) {
    PathPlanner planner(scene());
    for (section.start_index = 0; section.start_index < static_cast<int>(kMostPoints);
         section.start_index += section.number_of_moves) {
      PathPlanner tried = planner;
      if (const auto refusal = tried.append(section)) state.SkipWithError(refusal->found.c_str());
      const PathPlan rested = tried.takeRested();
      if (!piecesOf(rested, scene())) state.SkipWithError("refused");
      moved += toSeconds(rested.duration());
      planner = tried;
    }
  }
  state.counters["moved_per_planned"] = benchmark::Counter(moved, benchmark::Counter::kIsRate);
}
BENCHMARK(planThousandPointsAsAChain)->Unit(benchmark::kMillisecond);

void writeThousandPoints(benchmark::State& state) {
  PathPlanner planner(scene());
  if (const auto refusal = planner.append(thousandPoints())) state.SkipWithError(refusal->found.c_str());
  for (auto _ : state) {
    const PvtBlock block = sampleBlock(planner.plan(), 0, kMostPoints - 1);
    benchmark::DoNotOptimize(script::toText(scriptOf(block, {})));
  }
}
BENCHMARK(writeThousandPoints)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace cobot_command::path
