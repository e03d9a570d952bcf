// One arm of the TM family: geometry, joint limits and ratings, read from its URDF.
//
// An immutable value; safe to share between threads.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include <kdl/chain.hpp>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/units.h"

namespace cobot_command::arm {

/// Classic DH lengths of the TM family [m]; see doc/kinematics.md for the frames.
struct DhLengths {
  double d1 = 0, a2 = 0, a3 = 0, d4 = 0, d5 = 0, d6 = 0;
};

struct JointLimit {
  double lower = 0;         ///< [rad]
  double upper = 0;         ///< [rad]
  double max_velocity = 0;  ///< [rad/s]
};

/// Angular speed of the TCP on Line and Circle at 100 % [rad/s]. Chosen by this package because no source
/// documents it; see doc/motion.md.
inline constexpr double kUsualTurnSpeed = kPi;

/// Data sheet values of a model.
struct Ratings {
  double payload = 0;        ///< [kg]
  double reach = 0;          ///< [m]
  double max_tcp_speed = 0;  ///< typical maximum speed of the TCP [m/s]; 100 % of Line and Circle
  /// 100 % of their angular speed [rad/s]; the TCP never turns faster on them.
  double turn_speed = kUsualTurnSpeed;
};

/// Why a model cannot be created: what was found, what is allowed, what to do.
struct ModelError {
  std::string message;
};

class ArmModel {
 public:
  /// A model of the family by name ("tm5-700", "tm5-900", "tm12", "tm14", "tm12s", "tm14s"), from the URDF
  /// built into the library. An unknown name is refused with the list of known names.
  [[nodiscard]] static Result<ArmModel, ModelError> named(std::string_view name);

  /// From a URDF with other lengths or limits. The robot's name must be a known model, because it selects the
  /// ratings. Links and joints may share one prefix ("left_"). Refused if the chain base -> flange_link does
  /// not have the six joints and the parallel and crossing axes of the TM family (tolerance 1e-6 m and rad),
  /// because the closed-form kinematics would be wrong.
  [[nodiscard]] static Result<ArmModel, ModelError> fromUrdf(const std::string& urdf);

  /// The same arm with another angular speed of the TCP at 100 % [rad/s, above 0].
  [[nodiscard]] ArmModel turning(double turn_speed) const;

  /// The same arm with the joint limits `lower` and `upper` [rad]. Precondition: lower <= upper, within the
  /// limits of this arm.
  [[nodiscard]] ArmModel limitedTo(const JointVector& lower, const JointVector& upper) const;

  [[nodiscard]] static const std::vector<std::string>& knownNames();
  /// The built-in URDF of a known model. Precondition: the name is known.
  [[nodiscard]] static const std::string& urdfOf(std::string_view name);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const DhLengths& lengths() const { return lengths_; }
  [[nodiscard]] const std::array<JointLimit, kJointCount>& limits() const { return limits_; }
  [[nodiscard]] const Ratings& ratings() const { return ratings_; }
  /// base -> flange as a KDL chain: an independent description of the same arm.
  [[nodiscard]] const KDL::Chain& chain() const { return chain_; }
  [[nodiscard]] const std::array<std::string, kJointCount>& jointNames() const { return joint_names_; }

  /// The first joint (0..5) that is outside its limits by more than a rounding tolerance of 1e-9 rad; -1 if
  /// all are inside.
  [[nodiscard]] int firstJointOutsideLimits(const JointVector& joints) const;

 private:
  ArmModel() = default;

  std::string name_;
  DhLengths lengths_;
  std::array<JointLimit, kJointCount> limits_;
  Ratings ratings_;
  KDL::Chain chain_;
  std::array<std::string, kJointCount> joint_names_;
};

}  // namespace cobot_command::arm
