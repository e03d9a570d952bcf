// CBT_ChangeTCP (thesis 5.3.6): the TCP, weight and inertia of the tool for the motions that follow.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "cobot_command/blocks/shared/block_parts.h"

namespace cobot_command::blocks {

struct ChangeTcpGoal {
  static constexpr const char* kName = "change_tcp";
  [[nodiscard]] static ErrorTable errors();

  int command_id = 0;                         ///< 0 or 2..9; only echoed
  SixValues tcp_offset{};                     ///< the TCP in the flange
  double weight = 0;                          ///< [kg], 0..14
  std::array<double, 3> moment_of_inertia{};  ///< Ixx, Iyy, Izz [kg mm^2], not negative
  SixValues mass_center{};                    ///< frame of the mass centre in the tool (the TCP's frame)
  std::string tcp_name;  ///< replaces all of these: the name of a TCP of the project; empty: none
  bool exit_node = false;
  int buffer_mode = 0;
};

[[nodiscard]] GoalTraits traitsOf(const ChangeTcpGoal& goal);
[[nodiscard]] std::vector<Failure> check(const ChangeTcpGoal& goal);
[[nodiscard]] Order orderOf(const ChangeTcpGoal& goal, const arm::Pose& base);

}  // namespace cobot_command::blocks
