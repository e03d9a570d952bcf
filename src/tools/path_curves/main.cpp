// Curves of planned paths as CSV, for the pictures of doc/path.md: what is drawn there is what is driven.

#include <array>
#include <iostream>
#include <stdexcept>
#include <string>

#include "../command_line.h"
#include "../written_output.h"
#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/units.h"
#include "cobot_command/path/path_planner.h"

namespace {

using namespace cobot_command;
using path::PathPlan;
using path::PathPoint;

constexpr Duration kStep = std::chrono::milliseconds(5);
constexpr Duration kHalf = std::chrono::microseconds(500);  // of what a derivative is taken over

struct Law {
  const char* name;
  path::ProfileType type;
};
constexpr std::array<Law, 4> kLaws{{{"S_CURVE", path::ProfileType::SCurve},
                                    {"MOD_SINE", path::ProfileType::ModSine},
                                    {"POLY5", path::ProfileType::Poly5},
                                    {"SINE2", path::ProfileType::SineSquared}}};

PathPlan planned(const path::PathSection& section) {
  const arm::JointVector start = arm::toJointVector({0, 0, 90, 0, 90, 0});
  path::PathPlanner planner({*arm::ArmModel::named("tm5-900"), start});
  if (const auto refusal = planner.append(section)) throw std::runtime_error(refusal->found);
  return planner.plan();
}

/// From rest to rest, and a step on both sides.
template <class Row>
void eachStep(const PathPlan& plan, Row row) {
  for (Duration time = -kStep; time < plan.duration(); time += kStep) row(time);
  row(plan.duration());
  row(plan.duration() + kStep);
}

// --- Laws: joint 1 by 90 degrees.

double speedAt(const PathPlan& plan, Duration time) {
  return radToDeg(plan.at(time).velocity[0]);
}

double accelerationAt(const PathPlan& plan, Duration time) {
  return (speedAt(plan, time + kHalf) - speedAt(plan, time - kHalf)) / toSeconds(2 * kHalf);
}

void printLaw(const Law& law, double jerk_share) {
  PathPoint point;
  point.joints = {90, 0, 90, 0, 90, 0};
  point.speed = 90;
  point.acceleration = point.deceleration = 180;
  point.acceleration_jerk = point.deceleration_jerk = jerk_share;
  point.profile_type = static_cast<int>(law.type);
  const PathPlan plan = planned({{point}, 0, 1});
  eachStep(plan, [&](Duration time) {
    const double jerk =
        (accelerationAt(plan, time + kHalf) - accelerationAt(plan, time - kHalf)) / toSeconds(2 * kHalf);
    std::cout << fmt::format("{},{},{:.3f},{:.4f},{:.3f},{:.1f}\n", law.name, jerk_share, toSeconds(time),
                             speedAt(plan, time), accelerationAt(plan, time), jerk);
  });
}

void printLaws() {
  std::cout << "law,share,time,speed,acceleration,jerk\n";
  for (const double share : {0.0, 50.0, 100.0}) {
    for (const Law& law : kLaws) printLaw(law, share);
  }
}

// --- A corner: down by 100 mm, and on to the side by as much.

PathPoint line(double y, double z, double tolerance) {
  PathPoint point;
  point.target_type = static_cast<int>(path::TargetType::Cartesian);
  point.interpolation = static_cast<int>(path::Interpolation::Linear);
  point.pose = {517.5, y, z, 180, 0, 90};
  point.termination_type =
      static_cast<int>(tolerance > 0 ? path::Termination::Blend : path::Termination::Stop);
  point.command_tolerance = tolerance;
  point.speed = 100;
  point.acceleration = point.deceleration = 500;
  point.orientation_speed = 90;
  point.orientation_acceleration = point.orientation_deceleration = 360;
  return point;
}

void printCorner(double tolerance) {
  const arm::ArmModel arm = *arm::ArmModel::named("tm5-900");
  const PathPlan plan = planned({{line(-122.3, 361.05, tolerance), line(-22.3, 361.05, 0)}, 0, 2});
  const auto place_at = [&](Duration time) -> Eigen::Vector3d {
    return arm::forwardKinematics(arm, plan.at(time).position).translation() * 1000.0;
  };
  eachStep(plan, [&](Duration time) {
    const Eigen::Vector3d place = place_at(time);
    const double speed = (place_at(time + kHalf) - place_at(time - kHalf)).norm() / toSeconds(2 * kHalf);
    std::cout << fmt::format("{},{:.3f},{:.4f},{:.4f},{:.3f}\n", tolerance, toSeconds(time),
                             place.y() + 122.3, place.z() - 361.05, speed);
  });
}

void printCorners() {
  std::cout << "tolerance,time,y,z,speed\n";
  for (const double tolerance : {0.0, 5.0, 100.0}) printCorner(tolerance);
}

int run(int argc, char** argv) {
  CLI::App app{"Curves of planned paths as CSV."};
  tools::nameProgram(app, "path_curves");
  app.add_subcommand("laws",
                     "Joint 1 by 90 deg at 90 deg/s and 180 deg/s^2, by each law and a jerk of 0, 50, 100 %");
  app.add_subcommand("corner", "Two lines of 100 mm at 100 mm/s and 500 mm/s^2, tolerance 0, 5, 100 mm");
  tools::askForSubcommand(app);
  if (const auto end = tools::readCommandLine(app, tools::wordsOf(argc, argv))) return *end;
  app.got_subcommand("laws") ? printLaws() : printCorners();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return tools::unlessOutputLost("path_curves", run(argc, argv));
  } catch (const std::exception& error) {
    std::cerr << "path_curves: " << cobot_command::forPeople(error.what()) << '\n';
    return 1;
  }
}
