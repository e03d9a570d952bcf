// The distances of the bodies of robots, as FCL finds them (cell.md, section 3).
//
// FCL is known to be wrong at times, so that a third opinion decides where it differs: a search along the
// segment.
#include <algorithm>
#include <fstream>
#include <memory>
#include <sstream>

#include "cell_test_support.h"
#include "source_tree.h"
#include <fcl/geometry/shape/capsule.h>
#include <fcl/narrowphase/distance.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "cobot_command/cell/program/cell_file.h"

namespace cobot_command::cell {
namespace {

/// Above that the two differ [m].
constexpr double kSame = 1e-4;

using Placed = fcl::CollisionObject<double>;

/// FCL's capsules are along z, and their middle is the origin.
Placed placedOf(const Capsule& capsule) {
  const Eigen::Vector3d axis = capsule.to - capsule.from;
  fcl::Transform3<double> pose = fcl::Transform3<double>::Identity();
  if (axis.norm() > 0.0) {
    pose.linear() = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis).toRotationMatrix();
  }
  pose.translation() = 0.5 * (capsule.from + capsule.to);
  return {std::make_shared<fcl::Capsule<double>>(capsule.radius, axis.norm()), pose};
}

double distanceByFcl(const Placed& one, const Placed& other) {
  // Not the signed distance: where capsules reach into each other that asks for contacts, and this does not
  // find any. The plain one is negative there without.
  const fcl::DistanceRequest<double> request(false, false, 0.0, 0.0, 1e-6, fcl::GST_INDEP);
  fcl::DistanceResult<double> result;
  fcl::distance(&one, &other, request, result);
  return result.min_distance;
}

/// The distance to a segment has one minimum along another: thirds of it are left out until it is found.
double distanceBySearch(const Capsule& one, const Capsule& other) {
  const auto at = [&](double share) {
    return distanceToSegment(one.from + share * (one.to - one.from), other.from, other.to);
  };
  double lower = 0.0;
  double upper = 1.0;
  for (int i = 0; i < 100; ++i) {
    const double third = (upper - lower) / 3.0;
    const bool is_below = at(lower + third) < at(upper - third);
    (is_below ? upper : lower) += is_below ? -third : third;
  }
  return at(0.5 * (lower + upper)) - one.radius - other.radius;
}

struct Opinions {
  int asked = 0;
  int fcl_differs = 0;    ///< from ours
  int we_are_wrong = 0;   ///< by the search, where it does
  double greatest = 0.0;  ///< difference of ours and FCL's [m]

  void ask(const Capsule& one, const Placed& placed_one, const Capsule& other, const Placed& placed_other) {
    const double ours = distanceBetween(one, other);
    const double difference = std::abs(ours - distanceByFcl(placed_one, placed_other));
    ++asked;
    greatest = std::max(greatest, difference);
    if (difference <= kSame) return;
    ++fcl_differs;
    if (std::abs(ours - distanceBySearch(one, other)) > 1e-6) ++we_are_wrong;
  }
};

Cell cellNamed(const std::string& name) {
  std::stringstream text;
  text << std::ifstream(test_support::inSourceTree("config/cells/" + name + ".yaml")).rdbuf();
  const auto cell = parseCell(
      text.str(), name, [](const std::string&) { return refuse(std::string("there are no other files")); });
  if (!cell) throw std::runtime_error(describe(cell.error().front()));
  return *cell;
}

std::vector<RobotBodies> robotsOf(const Cell& cell) {
  std::vector<RobotBodies> robots;
  for (const Robot& robot : cell.robots) {
    robots.push_back(*RobotBodies::fromUrdf(arm::ArmModel::urdfOf(robot.model), robot.base, robot.tool,
                                            cell.parameters.body_cell));
  }
  return robots;
}

std::vector<Placed> placedOf(const Capsules& capsules) {
  std::vector<Placed> placed;
  for (const Capsule& capsule : capsules) placed.push_back(placedOf(capsule));
  return placed;
}

/// Each body of one with each of the other, and the nearest of all.
void compare(const Capsules& here, const Capsules& there, Opinions& opinions) {
  const auto placed_here = placedOf(here);
  const auto placed_there = placedOf(there);
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t one = 0; one < here.size(); ++one) {
    for (std::size_t other = 0; other < there.size(); ++other) {
      opinions.ask(here[one], placed_here[one], there[other], placed_there[other]);
      least = std::min(least, distanceByFcl(placed_here[one], placed_there[other]));
    }
  }
  EXPECT_NEAR(nearestOf(here, there).distance, least, kSame);
}

class DistancesInADemoCell : public testing::TestWithParam<const char*> {};

/// Anywhere; or near a station, where robots come close to each other.
arm::JointVector jointsOf(const Robot& robot, RandomNumbers& random) {
  if (random.coin()) return random.joints(2.5);
  const auto stations = static_cast<double>(robot.stations.size());
  const auto station = static_cast<std::size_t>(random.within(0.0, stations));
  return robot.stations[station].joints + random.joints(0.3);
}

TEST_P(DistancesInADemoCell, areThoseOfFclAtRandomJoints) {
  const Cell cell = cellNamed(GetParam());
  const std::vector<RobotBodies> robots = robotsOf(cell);
  RandomNumbers random(19);
  Opinions opinions;
  int into_each_other = 0;
  for (int posture = 0; posture < 500; ++posture) {
    std::vector<Capsules> bodies;
    for (std::size_t robot = 0; robot < robots.size(); ++robot) {
      bodies.push_back(robots[robot].at(jointsOf(cell.robots[robot], random)).capsules);
    }
    for (std::size_t one = 0; one < bodies.size(); ++one) {
      for (std::size_t other = one + 1; other < bodies.size(); ++other) {
        compare(bodies[one], bodies[other], opinions);
        if (nearestOf(bodies[one], bodies[other]).distance < 0.0) ++into_each_other;
      }
    }
  }
  EXPECT_GT(opinions.asked, 10000);
  EXPECT_GT(into_each_other, 0) << "else this says nothing of bodies that touch";
  EXPECT_EQ(opinions.fcl_differs, 0);
  EXPECT_EQ(opinions.we_are_wrong, 0);
  RecordProperty("asked", opinions.asked);
  RecordProperty("greatest_difference_m", fmt::format("{}", opinions.greatest));
}

INSTANTIATE_TEST_SUITE_P(Each, DistancesInADemoCell,
                         testing::Values("handover", "head_on", "iris", "corridor"));

/// Parallel, crossing, on one line, points, touching: where closed forms divide by what is nearly zero.
Capsule oddNeighbour(RandomNumbers& random, const Capsule& capsule) {
  const Eigen::Vector3d axis = capsule.to - capsule.from;
  const double tilt = random.coin() ? 0.0 : std::pow(10.0, random.within(-12, -2));
  const Eigen::Vector3d aside =
      random.coin() ? random.point(0.3) : Eigen::Vector3d(random.within(-2, 2) * axis);
  Capsule other;
  other.from = capsule.from + aside;
  other.to = other.from + random.within(-1.5, 1.5) * axis + tilt * random.point(1.0);
  if (random.within(0, 1) < 0.1) other.to = other.from;
  other.radius = random.within(0.01, 0.1);
  return other;
}

TEST(DistancesOfOddCapsules, areThoseOfFclUnlessThatIsWrong) {
  RandomNumbers random(20);
  Opinions opinions;
  for (int i = 0; i < 100000; ++i) {
    Capsule one{random.point(0.5), random.point(0.5), random.within(0.01, 0.1)};
    if (random.within(0, 1) < 0.1) one.to = one.from;
    const Capsule other = oddNeighbour(random, one);
    opinions.ask(one, placedOf(one), other, placedOf(other));
  }
  EXPECT_EQ(opinions.we_are_wrong, 0);
  EXPECT_LE(opinions.fcl_differs, opinions.asked / 1000);
  RecordProperty("fcl_differs", opinions.fcl_differs);
  RecordProperty("greatest_difference_m", fmt::format("{}", opinions.greatest));
}

/// The third opinion can tell: it is not ours, and finds what is wrong by a millimetre.
TEST(TheSearch, findsTheDistancesThatTheClosedFormDoes) {
  RandomNumbers random(21);
  for (int i = 0; i < 5000; ++i) {
    const Capsule one{random.point(0.5), random.point(0.5), 0.05};
    const Capsule other{random.point(0.5), random.point(0.5), 0.03};
    const Capsule thicker{other.from, other.to, other.radius + 0.001};
    EXPECT_NEAR(distanceBetween(one, other), distanceBySearch(one, other), 1e-9);
    EXPECT_GT(std::abs(distanceBetween(one, other) - distanceBySearch(one, thicker)), 1e-4);
  }
}

}  // namespace
}  // namespace cobot_command::cell
