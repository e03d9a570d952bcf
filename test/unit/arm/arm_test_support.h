// What the tests of the arm share.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/arm/inverse_kinematics.h"
#include "cobot_command/common/units.h"

namespace cobot_command::arm {

inline ArmModel model(const std::string& name) {
  auto found = ArmModel::named(name);
  if (!found) throw std::runtime_error(found.error().message);
  return *found;
}

/// "tm5-900" as a part of a test's name.
inline std::string modelNameForTest(const ::testing::TestParamInfo<std::string>& model) {
  std::string name = model.param;
  name.erase(std::remove(name.begin(), name.end(), '-'), name.end());
  return name;
}

/// The largest difference of any entry of the two transforms [m or 1].
inline double difference(const Pose& a, const Pose& b) {
  return (a.matrix() - b.matrix()).cwiseAbs().maxCoeff();
}

/// The largest difference of any joint [rad], whole turns aside.
inline double turnlessDifference(const JointVector& a, const JointVector& b) {
  double largest = 0;
  for (Eigen::Index i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(std::remainder(a[i] - b[i], 2 * kPi)));
  }
  return largest;
}

/// Postures all over the joint ranges of an arm, the same ones in every run.
class RandomPostures {
 public:
  explicit RandomPostures(const ArmModel& arm) : arm_(arm) {}

  JointVector next() {
    JointVector joints;
    for (Eigen::Index i = 0; i < joints.size(); ++i) {
      const JointLimit& limit = arm_.limits()[static_cast<std::size_t>(i)];
      joints[i] = std::uniform_real_distribution<double>(limit.lower, limit.upper)(generator_);
    }
    return joints;
  }

 private:
  const ArmModel& arm_;
  std::mt19937_64 generator_{20240607};
};

inline const Branch* branchWith(const Branches& branches, const PoseBits& bits) {
  const auto found =
      std::find_if(branches.begin(), branches.end(), [&bits](const Branch& b) { return b.bits == bits; });
  return found == branches.end() ? nullptr : &*found;
}

inline double worstPoseError(const ArmModel& arm, const Branches& branches, const Pose& flange) {
  double worst = 0;
  for (const Branch& branch : branches) {
    worst = std::max(worst, difference(forwardKinematics(arm, branch.joints), flange));
  }
  return worst;
}

}  // namespace cobot_command::arm
