// A status stream with all that every data table should have.
#pragma once

#include <vector>

#include "cobot_command/protocol/status_items.h"

namespace cobot_command::testing {

/// Of a robot that stands at J = 0 0 90 0 90 0 degrees, without errors, its project running.
inline std::vector<protocol::StatusItem> wholeStream() {
  namespace item = protocol::item;
  return {item::ofByte("Robot_Link", 1),
          item::ofBool("Robot_Error", false),
          item::ofBool("Project_Run", true),
          item::ofBool("Project_Pause", false),
          item::ofBool("ESTOP", false),
          item::ofInt("Error_Code", 0),
          item::ofBool("Safeguard_A", false),
          item::ofFloats("Joint_Angle", {0, 0, 90, 0, 90, 0}),
          item::ofFloats("Joint_Speed", {0, 0, 0, 0, 0, 0}),
          item::ofFloats("Joint_Torque", {0, 0, 0, 0, 0, 0}),
          item::ofFloats("Coord_Robot_Flange", {417.5F, -122.25F, 361, 180, 0, 90}),
          item::ofFloats("Coord_Robot_Tool", {417.5F, -122.25F, 361, 180, 0, 90}),
          item::ofFloats("TCP_Value", {0, 0, 0, 0, 0, 0}),
          item::ofString("TCP_Name", "NOTOOL"),
          item::ofFloats("Base_Value", {0, 0, 0, 0, 0, 0}),
          item::ofString("Base_Name", "RobotBase"),
          item::ofInt("Project_Speed", 100),
          item::ofInt("MA_Mode", 1)};
}

}  // namespace cobot_command::testing
