// Lines that end at stations.
#include "zoned_cell.h"
#include <gtest/gtest.h>

namespace cobot_command::cell {
namespace {

TEST(ALineToAStation, endsWithItsJoints) {
  const Cell cell = readCell(R"(cell: line
robots:
  RA: {model: tm5-900, base: [0, 0, 0, 0, 0, 0], home: HOME, tcp: [0, 0, 120, 0, 0, 0]}
stations:
  RA: {HOME: [0, -30, 120, 0, 90, 0], PLACE: [10, 0, 110, -25, 85, 20]}
programs:
  RA:
    - path: OUT
      from: HOME
      to: PLACE
      steps:
        - {block: change_base, base: [100, 200, 300, 0, 0, 90]}
        - {movement_command: LINE, data_format: CPP, target_position: PLACE, speed: 20, accel_time: 300}
        - {block: change_base, base: [0, 0, 0, 0, 0, 0]}
    - path: BACK
      from: PLACE
      to: HOME
      steps: [{movement_command: LINE, data_format: CPP, target_position: HOME, speed: 20, accel_time: 300}]
)");
  const auto planned = planCell(cell);
  ASSERT_TRUE(planned) << describe(planned.error().front());
  const auto& motion = planned->front().paths.front().frames[1].motions.back();
  const arm::JointVector end = motion.trajectory->end().position;
  EXPECT_TRUE(end.isApprox(find(cell.robots.front().stations, "PLACE")->joints, 1e-7));
}

}  // namespace
}  // namespace cobot_command::cell
