// ErrorIDs of the supervisor's actions; those of the robots' programs are in blocks/shared/error_ids.h.
#pragma once

namespace cobot_command::ros_adapter::supervisor_error {

/// run_cell: nothing was sent, or a robot was lost.
inline constexpr int kCellNotReady = 0x28A;
/// build_cell.
inline constexpr int kCellNotBuilt = 0x28B;

}  // namespace cobot_command::ros_adapter::supervisor_error
