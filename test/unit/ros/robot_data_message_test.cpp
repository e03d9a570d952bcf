// What the robot is and what this interface can do, as it is told.

#include "robot_data/robot_data_message.h"

#include <algorithm>

#include <gmock/gmock.h>

#include "cobot_command/capabilities/functions.h"
#include "cobot_command/capabilities/layer_version.h"

namespace cobot_command::ros_adapter {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

const link::ControllerIdentity kIdentity{"TM5-900", "SN1", "1.84.1200"};

class RobotDataMessage : public ::testing::Test {
 protected:
  static cobot_command::RobotData told(const arm::ArmModel* arm, const link::ControllerIdentity& identity) {
    return toMessage(arm, jointNames("left_"), identity, ros::Time(12));
  }
  static const cobot_command::RobotFunction* find(const std::vector<cobot_command::RobotFunction>& functions,
                                                  const std::string& name) {
    const auto found = std::find_if(functions.begin(), functions.end(),
                                    [&name](const auto& function) { return function.name == name; });
    return found == functions.end() ? nullptr : &*found;
  }

  const arm::ArmModel arm = *arm::ArmModel::named("tm5-900");
};

TEST_F(RobotDataMessage, tellsArmControllerAndLayer) {
  const auto message = told(&arm, kIdentity);
  EXPECT_EQ(message.header.stamp, ros::Time(12));
  EXPECT_EQ(message.maker, "Techman Robot");
  EXPECT_EQ(message.model, "tm5-900");
  EXPECT_EQ(message.controller_model, "TM5-900");
  EXPECT_EQ(message.control_box_sn, "SN1");
  EXPECT_EQ(message.tmflow_version, "1.84.1200");
  EXPECT_EQ(message.layer_version, capabilities::layerVersion());
  EXPECT_THAT(message.unknown, IsEmpty());
}

TEST_F(RobotDataMessage, tellsTheAxesInDegrees) {
  const auto message = told(&arm, kIdentity);
  ASSERT_EQ(message.axes.size(), 6U);
  EXPECT_EQ(message.axes[2].name, jointNames("left_")[2]);
  EXPECT_EQ(message.axes[2].lower_limit, -155);
  EXPECT_EQ(message.axes[2].upper_limit, 155);
  EXPECT_EQ(message.axes[0].upper_limit, 270);
  EXPECT_EQ(message.axes[0].rated_speed, 180);
}

TEST_F(RobotDataMessage, tellsEveryFunctionOnce) {
  const auto message = told(&arm, kIdentity);
  EXPECT_EQ(message.supported.size() + message.unsupported.size(), capabilities::functions().size());
  const auto* read = find(message.supported, "ReadMessages");
  ASSERT_NE(read, nullptr);
  EXPECT_THAT(read->interfaces,
              ElementsAre("topic messages", "topic pending_messages", "service read_messages"));
  EXPECT_TRUE(read->reason.empty());
  const auto* brakes = find(message.unsupported, "brake test");
  ASSERT_NE(brakes, nullptr);
  EXPECT_THAT(brakes->interfaces, IsEmpty());
  EXPECT_FALSE(brakes->reason.empty());
}

TEST_F(RobotDataMessage, namesWhatNobodyHasTold) {
  const auto message = told(&arm, {std::nullopt, std::nullopt, "1.84"});
  EXPECT_EQ(message.control_box_sn, "");
  EXPECT_EQ(message.tmflow_version, "1.84");
  EXPECT_THAT(message.unknown, ElementsAre(HasSubstr("controller_model: "), HasSubstr("ControlBox_SN")));
}

TEST_F(RobotDataMessage, withoutAModelOffersNoKinematicsAndSaysWhatToDo) {
  const auto message = told(nullptr, kIdentity);
  EXPECT_EQ(message.model, "");
  EXPECT_THAT(message.axes, IsEmpty());
  EXPECT_THAT(message.unknown, Contains(HasSubstr("~robot_model")));
  EXPECT_EQ(find(message.supported, "CalculateForwardKinematic"), nullptr);
  const auto* forward = find(message.unsupported, "CalculateForwardKinematic");
  ASSERT_NE(forward, nullptr);
  EXPECT_THAT(forward->reason, HasSubstr("~robot_model"));
}

}  // namespace
}  // namespace cobot_command::ros_adapter
