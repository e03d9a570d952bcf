// PLines of scripts.
#include <algorithm>

#include "zoned_cell.h"
#include <fmt/format.h>
#include <gmock/gmock.h>

namespace cobot_command::cell {
namespace {

using ::testing::HasSubstr;

/// Two PLines down and up again, from home; each blends by so many percent.
Cell cellWithPLines(int blend) {
  return readCell(fmt::format(R"(cell: plines
robots:
  RA: {{model: tm5-900, base: [0, 0, 0, 0, 0, 0], home: HOME}}
stations:
  RA: {{HOME: [0, -30, 120, 0, 90, 0]}}
programs:
  RA:
    - path: ROUND
      from: HOME
      to: HOME
      steps:
        - block: script
          script: |
            Move_PLine("CAP",0,0,-100,0,0,0,50,300,{0})
            Move_PLine("CAP",50,0,0,0,0,0,50,300,{0})
        - {{movement_command: PTP, data_format: JPP, target_position: HOME, speed: 30, accel_time: 300}}
)",
                              blend));
}

TEST(PLinesOfACell, thatStopAreClaimedAsTheLinesThatTheyAre) {
  const Cell cell = cellWithPLines(0);
  const auto planned = planCell(cell);
  ASSERT_TRUE(planned) << describe(planned.error().front());
  const PlannedFrame& frame = planned->front().paths.front().frames.front();
  ASSERT_EQ(frame.motions.size(), 2U);
  EXPECT_NEAR(frame.motions.front().trajectory->tcpWay(), 0.1, 1e-9);
  const auto claims = claimCell(cell, *planned);
  ASSERT_TRUE(claims) << describe(claims.error().front());
  for (const PlannedMotion& motion : frame.motions) {
    for (int part = 0; part <= 10; ++part) {
      const arm::JointVector joints =
          motion.trajectory->at(part * motion.trajectory->duration() / 10).position;
      const auto& pieces = claims->front().paths.front().pieces;
      EXPECT_TRUE(std::any_of(pieces.begin(), pieces.end(), [&](const Piece& piece) {
        return std::get<ArmPosture>(piece.posture).range.contains(joints, 1e-9);
      })) << part;
    }
  }
}

TEST(PLinesOfACell, thatBlendAreRefused) {
  const auto planned = planCell(cellWithPLines(50));
  ASSERT_FALSE(planned);
  EXPECT_THAT(describe(planned.error().front()),
              HasSubstr("programs.RA[0].steps[0] has a PLine that blends"));
}

}  // namespace
}  // namespace cobot_command::cell
