// The list of the function blocks. Each block has two lines in this file and is listed nowhere else.
// Everything that follows from the list (Block, the error catalogue, the action servers, the sources to
// build) is derived from it.
//
// A block is a goal with its name, errors and rules, in a header and a source file of the block's name.
#pragma once

#include <cstddef>
#include <variant>

#include "cobot_command/blocks/change_base.h"
#include "cobot_command/blocks/change_load.h"
#include "cobot_command/blocks/change_tcp.h"
#include "cobot_command/blocks/check_sequence.h"
#include "cobot_command/blocks/connect.h"
#include "cobot_command/blocks/exchange_configuration.h"
#include "cobot_command/blocks/exit_listen_node.h"
#include "cobot_command/blocks/follow_joint_trajectory.h"
#include "cobot_command/blocks/jog.h"
#include "cobot_command/blocks/load_path.h"
#include "cobot_command/blocks/move_absolute.h"
#include "cobot_command/blocks/move_circle.h"
#include "cobot_command/blocks/move_relative.h"
#include "cobot_command/blocks/pick_and_place.h"
#include "cobot_command/blocks/program_control.h"
#include "cobot_command/blocks/run_program.h"
#include "cobot_command/blocks/run_script.h"
#include "cobot_command/blocks/set_output.h"
#include "cobot_command/blocks/shared/block.h"
#include "cobot_command/blocks/stop.h"
#include "cobot_command/blocks/waits/wait_for_input.h"
#include "cobot_command/blocks/waits/wait_time.h"
#include "cobot_command/blocks/ways_back/retrace.h"
#include "cobot_command/blocks/ways_back/return_to_primary.h"

namespace cobot_command::blocks {

// clang-format off
using Goal = std::variant<
    ConnectGoal,
    MoveAbsoluteGoal,
    MoveRelativeGoal,
    MoveCircleGoal,
    ChangeBaseGoal,
    ChangeTcpGoal,
    ProgramControlGoal,
    StopGoal,
    ExitListenNodeGoal,
    RunScriptGoal,
    CheckSequenceGoal,
    PickAndPlaceGoal,
    ChangeLoadGoal,
    SetOutputGoal,
    WaitForInputGoal,
    WaitTimeGoal,
    LoadPathGoal,
    FollowJointTrajectoryGoal,
    ExchangeConfigurationGoal,
    JogGoal,
    ReturnToPrimaryGoal,
    RetraceGoal,
    RunProgramGoal
    >;
// clang-format on

inline constexpr std::size_t kBlockCount = std::variant_size_v<Goal>;

namespace detail {
template <class Kind, class... Kinds>
constexpr std::size_t placeIn(const std::variant<Kinds...>* /*list*/) {
  std::size_t place = 0;
  static_cast<void>(((std::is_same_v<Kind, Kinds> || (++place, false)) || ...));
  return place;
}
}  // namespace detail

/// The block of a goal type.
template <class Kind>
inline constexpr Block kBlock = static_cast<Block>(detail::placeIn<Kind>(static_cast<Goal*>(nullptr)));

[[nodiscard]] inline Block blockOf(const Goal& goal) {
  return static_cast<Block>(goal.index());
}

}  // namespace cobot_command::blocks
