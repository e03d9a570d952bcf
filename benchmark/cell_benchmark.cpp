// What the claims of a cell are made of, and all of them together: the sweep of a program of six steps in
// joints.
#include <algorithm>
#include <cstddef>
#include <vector>

#include <benchmark/benchmark.h>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/cell/bodies/part_tree.h"
#include "cobot_command/cell/bodies/robot_bodies.h"
#include "cobot_command/cell/sweep/capsule_claim.h"
#include "cobot_command/cell/sweep/displacement.h"
#include "cobot_command/cell/sweep/robot_claim.h"
#include "cobot_command/cell/sweep/voxel_set.h"

namespace {

using namespace cobot_command;
using cell::Capsule;

constexpr double kMargin = 0.020;
const arm::JointVector tracking = arm::JointVector::Constant(0.1 * 3.14159265358979 / 180);

/// Of cell.md, A3.
const arm::JointVector home = arm::toJointVector({0, -60, 140, 10, 90, 0});
const arm::JointVector ready = arm::toJointVector({0, 0, 115, -85, 90, 0});
const arm::JointVector work = arm::toJointVector({0, 60, 30, -60, 90, 0});
const arm::JointVector aside = arm::toJointVector({60, 30, 60, -60, 90, 0});

const std::vector<arm::JointVector> places = {home, ready, work, aside, work, ready, home};

cell::RobotBodies robot() {
  const std::vector<cell::Shape> tool = {{Capsule{{0, 0, 0}, {0, 0, 0.120}, 0.050}, arm::Pose::Identity()}};
  return cell::RobotBodies::fromUrdf(arm::ArmModel::urdfOf("tm5-900"), arm::Pose::Identity(), tool).value();
}

/// A TM5-900 that carries a sheet by a frame.
cell::RobotBodies loadedRobot() {
  cell::Part frame;
  frame.name = "frame";
  frame.shapes = {{cell::BoxShape{{0.3, 0.04, 0.04}}, arm::toPose({0, 0, 130, 0, 0, 0})}};
  cell::Part sheet;
  sheet.name = "sheet";
  sheet.shapes = {{cell::BoxShape{{0.4, 0.3, 0.005}}, arm::toPose({0, 0, 160, 0, 0, 0})}};
  sheet.on = frame.name;
  const cell::PartTree tree = cell::PartTree::of({frame, sheet}).value();
  return robot().carrying(tree.bodiesOf(tree.attached({}, "frame").value()));
}

struct Sweep {
  const cell::RobotBodies& robot;
  double edge = 0;
  double step_bound = 0;
  cell::PlacedRobot placed;
  std::vector<cell::VoxelSet> pieces;

  void add(const arm::JointVector& from, const arm::JointVector& to) {
    const arm::JointVector middle = 0.5 * (from + to);
    const arm::JointVector widths = 0.5 * (to - from).cwiseAbs();
    robot.place(middle, placed);
    if (cell::largestDisplacement(robot, placed, widths) > step_bound) {
      add(from, middle);
      add(middle, to);
      return;
    }
    cell::VoxelSet claim;
    cell::claimRobot(claim, robot, placed, widths + tracking, 0.5 * kMargin + 1e-6, edge);
    pieces.push_back(std::move(claim));
  }
};

void claimOfAProgram(benchmark::State& state, const cell::RobotBodies& robot) {
  const double edge = 1e-3 * static_cast<double>(state.range(0));
  std::size_t bytes = 0;
  for (auto _ : state) {
    Sweep sweep{robot, edge, edge / 2, {}, {}};
    for (std::size_t i = 1; i < places.size(); ++i) sweep.add(places[i - 1], places[i]);
    cell::VoxelSet all;
    for (const cell::VoxelSet& piece : sweep.pieces) all |= piece;
    bytes = all.memory();
    for (const cell::VoxelSet& piece : sweep.pieces) bytes += piece.memory();
    state.counters["pieces"] = static_cast<double>(sweep.pieces.size());
    state.counters["litres"] = 1e3 * static_cast<double>(all.count()) * edge * edge * edge;
  }
  state.counters["capsules"] = static_cast<double>(robot.bodies().size());
  state.counters["MiB"] = static_cast<double>(bytes) / (1 << 20);
}

void claimOfAProgramWithATool(benchmark::State& state) {
  claimOfAProgram(state, robot());
}
void claimOfAProgramWithASheet(benchmark::State& state) {
  claimOfAProgram(state, loadedRobot());
}

/// Of the tubes, the elbow and so on, as they are claimed in a program.
void claimOfACapsule(benchmark::State& state) {
  const double edge = 1e-3 * static_cast<double>(state.range(0));
  cell::Capsules capsules = robot().at(aside).capsules;
  for (Capsule& capsule : capsules) capsule.radius += 0.025;
  cell::VoxelSet set;
  std::size_t next = 0;
  for (auto _ : state) {
    cell::claimCapsule(set, capsules[next], edge);
    next = (next + 1) % capsules.size();
  }
}

/// All that a program claims, as one component.
cell::VoxelSet claimOf(double edge) {
  const cell::RobotBodies one = robot();
  Sweep sweep{one, edge, edge / 2, {}, {}};
  for (std::size_t i = 1; i < places.size(); ++i) sweep.add(places[i - 1], places[i]);
  cell::VoxelSet all;
  for (const cell::VoxelSet& piece : sweep.pieces) all |= piece;
  return all;
}

void componentsOfAClaim(benchmark::State& state) {
  const cell::VoxelSet claim = claimOf(1e-3 * static_cast<double>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(claim.components());
  state.counters["voxels"] = static_cast<double>(claim.count());
}

void intersectionOfClaims(benchmark::State& state) {
  const cell::VoxelSet claim = claimOf(1e-3 * static_cast<double>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(claim & claim);
}

void placeOfARobot(benchmark::State& state) {
  const cell::RobotBodies one = robot();
  cell::PlacedRobot placed;
  for (auto _ : state) {
    one.place(aside, placed);
    benchmark::DoNotOptimize(placed);
  }
}

void displacementOfARobot(benchmark::State& state) {
  const cell::RobotBodies one = robot();
  const cell::PlacedRobot placed = one.at(aside);
  for (auto _ : state) benchmark::DoNotOptimize(cell::largestDisplacement(one, placed, tracking));
}

void distanceOfTwoRobots(benchmark::State& state) {
  const cell::RobotBodies one = robot();
  const cell::Capsules here = one.at(work).capsules;
  cell::Capsules there = one.at(aside).capsules;
  for (Capsule& capsule : there) {
    capsule = placed(arm::toPose({1440, -244.6, 0, 0, 0, 180}), capsule);
  }
  for (auto _ : state) benchmark::DoNotOptimize(cell::nearestOf(here, there));
}

void distanceOfTwoCapsules(benchmark::State& state) {
  const cell::Capsules capsules = robot().at(aside).capsules;
  std::size_t next = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(cell::distanceBetween(capsules[next], capsules[capsules.size() - 1 - next]));
    next = (next + 1) % capsules.size();
  }
}

BENCHMARK(claimOfAProgramWithATool)->Arg(20)->Arg(10)->Unit(benchmark::kMillisecond);
BENCHMARK(claimOfAProgramWithASheet)->Arg(20)->Unit(benchmark::kMillisecond);
BENCHMARK(claimOfACapsule)->Arg(20)->Arg(10)->Unit(benchmark::kMicrosecond);
BENCHMARK(componentsOfAClaim)->Arg(20)->Arg(10)->Unit(benchmark::kMillisecond);
BENCHMARK(intersectionOfClaims)->Arg(20)->Arg(10)->Unit(benchmark::kMicrosecond);
BENCHMARK(placeOfARobot);
BENCHMARK(displacementOfARobot);
BENCHMARK(distanceOfTwoRobots);
BENCHMARK(distanceOfTwoCapsules);

}  // namespace
