// The kinematics side by side with KDL and with the bare cost of the functions of libm that they cannot
// avoid. Only the ratios within one run mean anything; doc/kinematics.md lists them.
#include <cmath>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainjnttojacsolver.hpp>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/arm/inverse_kinematics.h"
#include "cobot_command/arm/wrist_inverse.h"

namespace {

using namespace cobot_command::arm;

constexpr std::size_t kSamples = 3000;

/// Random postures inside the limits of a TM5-900, the poses they reach, and random seeds for KDL.
struct Samples {
  ArmModel arm = ArmModel::named("tm5-900").value();
  std::vector<JointVector> joints;
  std::vector<Pose> poses;
  std::vector<KDL::JntArray> kdl_joints;
  std::vector<KDL::JntArray> kdl_seeds;
  std::vector<KDL::Frame> kdl_frames;

  Samples() {
    std::mt19937_64 generator(21);
    KDL::ChainFkSolverPos_recursive fk(arm.chain());
    for (std::size_t i = 0; i < kSamples; ++i) {
      joints.push_back(randomJoints(generator));
      poses.push_back(forwardKinematics(arm, joints.back()));
      kdl_joints.push_back(toKdl(joints.back()));
      kdl_seeds.push_back(toKdl(randomJoints(generator)));
      KDL::Frame frame;
      fk.JntToCart(kdl_joints.back(), frame);
      kdl_frames.push_back(frame);
    }
  }

  [[nodiscard]] JointVector randomJoints(std::mt19937_64& generator) const {
    JointVector result;
    for (Eigen::Index i = 0; i < result.size(); ++i) {
      const JointLimit& limit = arm.limits()[static_cast<std::size_t>(i)];
      result[i] = std::uniform_real_distribution<double>(limit.lower, limit.upper)(generator);
    }
    return result;
  }
  [[nodiscard]] static KDL::JntArray toKdl(const JointVector& joints) {
    KDL::JntArray result(6);
    result.data = joints;
    return result;
  }
};

const Samples& samples() {
  static const Samples instance;
  return instance;
}

void allBranchesOfAPose(benchmark::State& state) {
  const Samples& s = samples();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(allBranches(s.arm, s.poses[i]));
    i = (i + 1) % kSamples;
  }
}
BENCHMARK(allBranchesOfAPose);

/// The transcendental functions that all eight branches need: 17 atan2, 4 acos, 7 sqrt.
void allBranchesLibmFloor(benchmark::State& state) {
  volatile double x = 0.3;
  volatile double y = 0.4;
  for (auto _ : state) {
    double sum = 0;
    for (int k = 0; k < 17; ++k) sum += std::atan2(x, y);
    for (int k = 0; k < 4; ++k) sum += std::acos(x);
    for (int k = 0; k < 7; ++k) sum += std::sqrt(x);
    benchmark::DoNotOptimize(sum);
  }
}
BENCHMARK(allBranchesLibmFloor);

void oneSolutionByKdlLma(benchmark::State& state) {
  const Samples& s = samples();
  KDL::ChainIkSolverPos_LMA solver(s.arm.chain(), Eigen::Matrix<double, 6, 1>::Ones(), 1e-6, 500);
  KDL::JntArray result(6);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(solver.CartToJnt(s.kdl_seeds[i], s.kdl_frames[i], result));
    i = (i + 1) % kSamples;
  }
}
BENCHMARK(oneSolutionByKdlLma);

void onePostureByItsBits(benchmark::State& state) {
  const Samples& s = samples();
  std::vector<PoseBits> bits;
  for (const JointVector& joints : s.joints) bits.push_back(poseBitsOf(s.arm, joints));
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(postureFor(s.arm, s.poses[i], bits[i], s.joints[i]));
    i = (i + 1) % kSamples;
  }
}
BENCHMARK(onePostureByItsBits);

void onePostureWithItsWristGiven(benchmark::State& state) {
  const Samples& s = samples();
  const WristArm wrist_arm(s.arm, Pose::Identity());
  std::vector<WristBranch> branches;
  for (const JointVector& joints : s.joints) branches.push_back(wrist_arm.branchOf(joints));
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        wrist_arm.solve(s.joints[i].tail<3>(), s.poses[i].translation(), branches[i], s.joints[i]));
    i = (i + 1) % kSamples;
  }
}
BENCHMARK(onePostureWithItsWristGiven);

void forwardKinematicsOfAPosture(benchmark::State& state) {
  const Samples& s = samples();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(forwardKinematics(s.arm, s.joints[i]));
    i = (i + 1) % kSamples;
  }
}
BENCHMARK(forwardKinematicsOfAPosture);

void forwardKinematicsByKdl(benchmark::State& state) {
  const Samples& s = samples();
  KDL::ChainFkSolverPos_recursive solver(s.arm.chain());
  KDL::Frame frame;
  std::size_t i = 0;
  for (auto _ : state) {
    solver.JntToCart(s.kdl_joints[i], frame);
    benchmark::DoNotOptimize(frame);
    i = (i + 1) % kSamples;
  }
}
BENCHMARK(forwardKinematicsByKdl);

void jacobianOfAPosture(benchmark::State& state) {
  const Samples& s = samples();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(jacobianAt(s.arm, s.joints[i]));
    i = (i + 1) % kSamples;
  }
}
BENCHMARK(jacobianOfAPosture);

void jacobianByKdl(benchmark::State& state) {
  const Samples& s = samples();
  KDL::ChainJntToJacSolver solver(s.arm.chain());
  KDL::Jacobian jacobian(6);
  std::size_t i = 0;
  for (auto _ : state) {
    solver.JntToJac(s.kdl_joints[i], jacobian);
    benchmark::DoNotOptimize(jacobian.data.data());
    i = (i + 1) % kSamples;
  }
}
BENCHMARK(jacobianByKdl);

}  // namespace
