// Reads a signal file: which input or output of the robot each signal name stands for. In YAML:
//
//   do_gripper: {type: do, module: EndModule, index: 0}
//   gi_part: {type: gi, module: ControlBox, bits: [4, 5, 6], inverted: true}
//   di_start: {type: di, virtual: true, initial: 1}
//
// Keys and ranges: doc/rapid.md.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/common/result.h"
#include "cobot_command/rapid/types/signal.h"

namespace cobot_command::rapid {

/// Why a signal file was refused: the finding E905.
struct SignalFileFault {
  int line = 1;      ///< from 1
  int column = 1;    ///< from 1
  std::string text;  ///< "signal file: bit 3 of do at EndModule is used twice"; one bounded line
};

/// The signals of a file, in its order. The first fault ends it.
[[nodiscard]] Result<std::vector<Signal>, SignalFileFault> readSignalFile(const std::string& text);

}  // namespace cobot_command::rapid
