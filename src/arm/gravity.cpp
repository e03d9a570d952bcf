#include "cobot_command/arm/gravity.h"

#include <array>

#include <kdl/frames.hpp>

namespace cobot_command::arm {
namespace {

constexpr double kGravity = 9.80665;  ///< [m/s^2]

/// A joint, and the mass that it moves, in the robot base.
struct Held {
  KDL::Vector point;
  KDL::Vector axis;
  double mass = 0;     ///< [kg]
  KDL::Vector moment;  ///< mass times place [kg m]
};

void add(Held& held, double mass, const KDL::Vector& place) {
  held.mass += mass;
  held.moment += mass * place;
}

}  // namespace

PointMass operator+(const PointMass& one, const PointMass& other) {
  const double mass = one.mass + other.mass;
  if (mass == 0) return {};
  return {mass, (one.mass * one.centre + other.mass * other.centre) / mass};
}

JointVector holdingTorques(const ArmModel& arm, const JointVector& joints, const PointMass& carried) {
  std::array<Held, kJointCount> held;
  std::size_t count = 0;
  KDL::Frame frame;
  for (const KDL::Segment& segment : arm.chain().segments) {
    const KDL::Joint& joint = segment.getJoint();
    double angle = 0;
    if (joint.getType() != KDL::Joint::None) {
      angle = joints[static_cast<Eigen::Index>(count)];
      held[count].point = frame * joint.JointOrigin();
      held[count].axis = frame.M * joint.JointAxis();
      ++count;
    }
    frame = frame * segment.pose(angle);
    const KDL::RigidBodyInertia& body = segment.getInertia();
    if (count > 0) add(held[count - 1], body.getMass(), frame * body.getCOG());
  }
  const Eigen::Vector3d& centre = carried.centre;
  add(held.back(), carried.mass, frame * KDL::Vector(centre.x(), centre.y(), centre.z()));

  JointVector torques;
  double mass = 0;
  KDL::Vector moment = KDL::Vector::Zero();
  for (std::size_t i = kJointCount; i-- > 0;) {
    mass += held[i].mass;
    moment += held[i].moment;
    const KDL::Vector lever = moment - mass * held[i].point;
    torques[static_cast<Eigen::Index>(i)] =
        kGravity * KDL::dot(held[i].axis, lever * KDL::Vector(0, 0, 1));  // * of vectors: their cross product
  }
  return torques;
}

}  // namespace cobot_command::arm
