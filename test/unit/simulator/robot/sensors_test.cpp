// What the robot tells of itself: torques from its weight, and the noise that its sensors are set to have.
#include <cmath>
#include <vector>

#include "simulated_robot.h"
#include "streamed_items.h"
#include <gtest/gtest.h>

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/arm/gravity.h"
#include "cobot_command/common/units.h"

namespace cobot_command::simulator::test {
namespace {

using protocol::StatusFrame;

/// A robot and somebody who reads its items.
class Read {
 public:
  explicit Read(const Settings& settings = {}) : robot(settings), client_(robot.connect(Port::Status)) {}

  std::vector<float> floats(const std::string& name) {
    robot.heard(client_);
    robot.send(client_, protocol::encode(StatusFrame{"q", 11, readRequest({name})}), Port::Status);
    const auto items = itemsOf(framesIn(robot.heard(client_)).at(0));
    return protocol::item::asFloats(items.at(0)).value();
  }
  arm::JointVector six(const std::string& name) {
    const std::vector<float> found = floats(name);
    arm::JointVector values;
    for (Eigen::Index i = 0; i < 6; ++i) values[i] = found.at(static_cast<std::size_t>(i));
    return values;
  }
  /// The frames that are streamed meanwhile.
  std::vector<StatusFrame> stream(Duration duration) {
    robot.heard(client_);
    robot.wait(duration);
    return framesIn(robot.heard(client_));
  }
  void script(const std::string& text) { robot.script(robot.connect(), "1", text); }

  SimulatedRobot robot;

 private:
  ClientId client_;
};

/// [Nm], of the arm that holds `carried`.
arm::JointVector holding(SimulatedRobot& robot, const arm::PointMass& carried = {}) {
  return arm::holdingTorques(robot.controller().arm(), robot.state().joints, carried);
}

/// The items have 24 bits.
void expectNear(const arm::JointVector& found, const arm::JointVector& expected, double tolerance) {
  EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), tolerance) << found.transpose() << "\ninstead of\n"
                                                                 << expected.transpose();
}

TEST(JointTorque, holdsTheArmAgainstItsWeight) {
  Read read;
  const arm::JointVector torques = read.six("Joint_Torque");
  expectNear(torques, 1e3 * holding(read.robot), 0.01);
  EXPECT_LT(torques[1], -10e3) << "mNm";
  read.script("PTP(\"JPP\",0,0,0,0,0,0,100,200,0,false)");
  read.robot.wait(3s);
  expectNear(read.six("Joint_Torque"), 1e3 * holding(read.robot), 0.01);
  EXPECT_GT(read.six("Joint_Torque")[1], -5e3) << "upright it holds less";
}

TEST(JointTorque, holdsTheToolAtItsMassCentreAndTheLoadAtTheTcp) {
  Read read;
  read.script("ChangeTCP(0,0,100,0,0,90,2,0,0,0,50,0,30,0,0,0)\r\nChangeLoad(1.5)");
  // The tool is turned by 90 degrees: the X of its mass centre is the Y of the flange.
  const arm::PointMass tool{2.0, {0.0, 0.05, 0.13}};
  const arm::PointMass load{1.5, {0.0, 0.0, 0.1}};
  expectNear(read.six("Joint_Torque"), 1e3 * holding(read.robot, tool + load), 0.01);
}

TEST(JointTorque, hasAnAverageALeastAndAMostOfTheLastMoments) {
  Settings settings;
  settings.tmflow_version = "1.84";
  Read read(settings);
  for (const char* item : {"Joint_Torque_Average", "Joint_Torque_Min", "Joint_Torque_Max"}) {
    expectNear(read.six(item), read.six("Joint_Torque"), 0.01);
  }
  read.script("PTP(\"JPP\",0,30,90,0,90,0,100,200,0,false)");
  read.robot.wait(300ms);
  const arm::JointVector least = read.six("Joint_Torque_Min"), most = read.six("Joint_Torque_Max"),
                         average = read.six("Joint_Torque_Average"), now = read.six("Joint_Torque");
  EXPECT_LT(least[1], average[1]);
  EXPECT_LT(average[1], most[1]);
  EXPECT_FLOAT_EQ(static_cast<float>(least[1]), static_cast<float>(now[1])) << "it leans out further";
}

TEST(ElectricItems, followTheTorquesAndAreNotZero) {
  Read read;
  expectNear(read.six("Joint_Current"), 0.1 * read.six("Joint_Torque"), 0.01);
  const double current = read.floats("Manipulator_Current").at(0);
  EXPECT_NEAR(current, 1.0 + 1e-3 * read.six("Joint_Current").cwiseAbs().sum(), 1e-5);
  EXPECT_NEAR(read.floats("Manipulator_Consumption").at(0), 48.0 * current, 1e-3);
  EXPECT_EQ(read.floats("Manipulator_Voltage").at(0), 48.0F);
  EXPECT_EQ(read.floats("Controller_Temperature").at(0), 40.0F);
  EXPECT_EQ(read.six("Joint_Temperature"), arm::JointVector::Constant(35.0));
  EXPECT_EQ(read.floats("TCP_Force"), std::vector<float>(3, 0.0F)) << "nothing touches it";
}

TEST(HandCamera, isBesideTheFlange) {
  EXPECT_EQ(Read().floats("HandCamera_Value"), (std::vector<float>{0, 80, 40, 0, 0, 0}));
}

Settings noisy(int seed = 1) {
  Settings settings;
  settings.joint_noise = degToRad(0.002);
  settings.speed_noise = degToRad(0.01);
  settings.torque_noise = 0.3;
  settings.force_noise = 2.0;
  settings.noise_seed = seed;
  settings.stream_items = {"Joint_Angle", "Joint_Speed", "Joint_Torque", "TCP_Force", "Coord_Robot_Flange"};
  return settings;
}

/// Of all numbers of an item in all frames, from what is true.
double deviation(const std::vector<StatusFrame>& frames, const std::string& name,
                 const std::vector<double>& truth) {
  double sum = 0;
  for (const StatusFrame& frame : frames) {
    const auto floats = protocol::item::asFloats(itemNamed(frame, name)).value();
    for (std::size_t i = 0; i < truth.size(); ++i) sum += std::pow(floats.at(i) - truth[i], 2);
  }
  return std::sqrt(sum / static_cast<double>(frames.size() * truth.size()));
}

TEST(SensorNoise, hasTheDeviationThatItIsSetTo) {
  Read read(noisy());
  const auto frames = read.stream(15s);
  ASSERT_EQ(frames.size(), 1000U);
  const arm::JointVector held = 1e3 * holding(read.robot);
  EXPECT_NEAR(deviation(frames, "Joint_Angle", {0, 0, 90, 0, 90, 0}), 0.002, 1e-4);
  EXPECT_NEAR(deviation(frames, "Joint_Speed", {0, 0, 0, 0, 0, 0}), 0.01, 5e-4);
  EXPECT_NEAR(deviation(frames, "Joint_Torque", {held.data(), held.data() + 6}), 300, 15);
  EXPECT_NEAR(deviation(frames, "TCP_Force", {0, 0, 0}), 2.0, 0.1);
}

TEST(SensorNoise, putsTheFlangeWhereTheMeasuredJointsAre) {
  Read read(noisy());
  const StatusFrame frame = read.stream(15ms).at(0);
  const auto joints = protocol::item::asFloats(itemNamed(frame, "Joint_Angle")).value();
  const auto flange = protocol::item::asFloats(itemNamed(frame, "Coord_Robot_Flange")).value();
  arm::ControllerJoints degrees{};
  std::copy(joints.begin(), joints.end(), degrees.begin());
  const auto expected = arm::toControllerPose(
      arm::forwardKinematics(read.robot.controller().arm(), arm::toJointVector(degrees)));
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(flange.at(i), expected.at(i), 1e-3);
  EXPECT_NE(flange.at(0), 417.5F);
}

TEST(SensorNoise, leavesTheArmItselfAlone) {
  SimulatedRobot still, shaken(noisy());
  for (SimulatedRobot* robot : {&still, &shaken}) {
    robot->script(robot->connect(), "1", "Move_Line(\"CAP\",0,50,-20,0,0,30,100,200,0,false)");
    robot->waitUntilIdle();
  }
  EXPECT_EQ(still.state().joints, shaken.state().joints);
  EXPECT_EQ(still.now(), shaken.now());
}

std::string heard(int seed, Duration step) {
  SimulatedRobot robot(noisy(seed));
  const ClientId client = robot.connect(Port::Status);
  std::string bytes;
  for (Duration t{}; t < 300ms; t += step) {
    robot.wait(step);
    bytes += robot.heard(client);
  }
  return bytes;
}

TEST(SensorNoise, isTheSameOnEveryRunAndAnotherForEachSeed) {
  EXPECT_EQ(heard(1, 300ms), heard(1, 1ms));
  EXPECT_NE(heard(1, 300ms), heard(2, 300ms));
}

/// What a script is told of J3, as it sends it on.
std::string toldToAScript(const Settings& settings) {
  SimulatedRobot robot(settings);
  const ClientId client = robot.connect();
  robot.heard(client);
  robot.script(client, "1", "ListenSend(90,Robot[0].Joint[2])");
  return robot.heard(client);
}

TEST(SensorNoise, isSeenByScriptsToo) {
  EXPECT_EQ(toldToAScript(noisy()), toldToAScript(noisy()));
  EXPECT_NE(toldToAScript(noisy()), toldToAScript({}));
}

TEST(TurnSpeed, isThatOfTheSettings) {
  Settings settings;
  settings.turn_speed = 0.5;
  SimulatedRobot robot(settings);
  robot.script(robot.connect(), "1", "Move_Line(\"TAP\",0,0,0,0,0,45,250,200,0,false)");
  robot.waitUntilIdle();
  EXPECT_NEAR(toSeconds(robot.now() - Instant{}), degToRad(45.0) / 0.5 + 0.2, 1e-6);
}

}  // namespace
}  // namespace cobot_command::simulator::test
