// What planning costs. A line or circle must be checked, at 1 kHz, in at most 1/1000 of the time that it
// takes; the counter moved_per_planned shows the inverse.
#include <chrono>

#include <benchmark/benchmark.h>
#include <kdl/velocityprofile_trap.hpp>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/motion/planner.h"

namespace cobot_command::motion {
namespace {

using std::chrono::milliseconds;

const arm::ArmModel& tm5() {
  static const arm::ArmModel model = *arm::ArmModel::named("tm5-900");
  return model;
}

arm::JointVector start() {
  return arm::toJointVector({10, 15, 80, -5, 85, 20});
}

arm::Pose shifted(double x, double y, double z, double turn) {
  arm::Pose pose = arm::forwardKinematics(tm5(), start());
  pose.translation() += Eigen::Vector3d(x, y, z);
  pose.linear() = Eigen::AngleAxisd(turn, Eigen::Vector3d(1, 2, 3).normalized()) * pose.linear();
  return pose;
}

Command line() {
  return Line{shifted(0.05, 0.25, -0.12, 0.3), TcpSpeed{0.25}, milliseconds(250)};
}

Command circle() {
  return Circle{shifted(0.05, 0.05, 0.0, 0.0), shifted(0.0, 0.1, 0.0, 0.3), std::nullopt, TcpSpeed{0.1},
                milliseconds(250)};
}

Command ptp() {
  return Ptp{arm::toJointVector({-60, 40, 30, 50, -20, 200}), 0.5, milliseconds(250)};
}

void planPath(benchmark::State& state, Command (*make)()) {
  const Command command = make();
  double moved = 0.0;
  for (auto _ : state) {
    const auto motion = plan(tm5(), start(), command, Setting{});
    moved += toSeconds((*motion)->duration());
  }
  state.counters["moved_per_planned"] = benchmark::Counter(moved, benchmark::Counter::kIsRate);
}

void sampleMotion(benchmark::State& state, Command (*make)()) {
  const TrajectoryPtr motion = *plan(tm5(), start(), make(), Setting{});
  Duration time{};
  for (auto _ : state) {
    time = (time + milliseconds(8)) % motion->duration();
    benchmark::DoNotOptimize(motion->at(time));
  }
}

/// Of pieces of 40 ms, as those are whose claims are small.
void rangeOfPiece(benchmark::State& state, Command (*make)()) {
  const TrajectoryPtr motion = *plan(tm5(), start(), make(), Setting{});
  Duration time{};
  for (auto _ : state) {
    time = (time + milliseconds(8)) % motion->duration();
    benchmark::DoNotOptimize(motion->jointRange(time, time + milliseconds(40)));
  }
}

/// What six synchronised profiles cost in KDL: the measure for planning a PTP.
void kdlProfiles(benchmark::State& state) {
  const arm::JointVector way = std::get<arm::JointVector>(std::get<Ptp>(ptp()).target) - start();
  for (auto _ : state) {
    double longest = 0.0;
    KDL::VelocityProfile_Trap profiles[6];
    for (int i = 0; i < 6; ++i) {
      profiles[i].SetMax(1.0, 4.0);
      profiles[i].SetProfile(0.0, way[i]);
      longest = std::max(longest, profiles[i].Duration());
    }
    for (int i = 0; i < 6; ++i) {
      profiles[i].SetProfileDuration(0.0, way[i], longest);
    }
    benchmark::DoNotOptimize(profiles);
  }
}

BENCHMARK_CAPTURE(planPath, line, &line);
BENCHMARK_CAPTURE(planPath, circle, &circle);
BENCHMARK_CAPTURE(planPath, ptp, &ptp);
BENCHMARK(kdlProfiles);
BENCHMARK_CAPTURE(sampleMotion, line, &line);
BENCHMARK_CAPTURE(sampleMotion, ptp, &ptp);
BENCHMARK_CAPTURE(rangeOfPiece, line, &line);
BENCHMARK_CAPTURE(rangeOfPiece, circle, &circle);
BENCHMARK_CAPTURE(rangeOfPiece, ptp, &ptp);

}  // namespace
}  // namespace cobot_command::motion
