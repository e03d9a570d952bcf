// The services that only calculate: joints into poses and back, frames and tools of what was touched.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <ros/node_handle.h>
#include <ros/service_server.h>

#include "cobot_command/CalculateFrame.h"
#include "cobot_command/CalculateTool.h"
#include "cobot_command/ForwardKinematics.h"
#include "cobot_command/InverseKinematics.h"
#include "cobot_command/arm/arm_model.h"
#include "cobot_command/tables/data_tables.h"

namespace cobot_command::ros_adapter {

class KinematicsServices {
 public:
  /// Asked for at each call; neither may wait for the core.
  struct Sources {
    std::function<std::shared_ptr<const arm::ArmModel>()> arm;  ///< gives nullptr without a model
    std::function<tables::DataTables()> tables;
  };

  KinematicsServices(const ros::NodeHandle& node, Sources sources);

 private:
  bool forward(cobot_command::ForwardKinematics::Request& request,
               cobot_command::ForwardKinematics::Response& response);
  bool inverse(cobot_command::InverseKinematics::Request& request,
               cobot_command::InverseKinematics::Response& response);
  bool frame(cobot_command::CalculateFrame::Request& request,
             cobot_command::CalculateFrame::Response& response);

  Sources sources_;
  std::vector<ros::ServiceServer> services_;
};

}  // namespace cobot_command::ros_adapter
