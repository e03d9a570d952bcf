// The pick-and-place cycle as an operator edits it: the six moves of the thesis (6.3.8), each a form of its
// own.
#pragma once

#include <array>

#include "forms/form.h"

namespace cobot_command::rviz_plugin {

struct Cycle {
  static constexpr std::size_t kMoves = 6;
  static constexpr std::array<const char*, kMoves> kNames{"above pick",  "pick",  "up with the part",
                                                          "above place", "place", "up, empty"};

  std::array<Form, kMoves> moves;  ///< as moveAbsoluteForm(), and what follows: an output, a dwell
  Form general;                    ///< how often, and what becomes of it while another command is busy
};

/// With the preset values: those of config/pick_and_place.yaml, for a TM5-900.
[[nodiscard]] Cycle presetCycle();

}  // namespace cobot_command::rviz_plugin
