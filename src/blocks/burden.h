// What the arm carries: the tool, and what that holds.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/blocks/active_frames.h"
#include "cobot_command/protocol/script_command.h"

namespace cobot_command::blocks {

/// More than the arm carries.
struct TooMuch {
  std::string text;    ///< "the active tool has 8 kg, tm5-900 carries 4 kg"
  double payload = 0;  ///< [kg]
};

class Burden {
 public:
  /// Takes what the command says of tool or load, if it does.
  bool accepted(const protocol::ScriptCommand& command);
  /// Somebody else may have changed it.
  void forget() { *this = {}; }

  /// Nothing when it can carry what is known of. `active` counts where it tells the mass of the tool; not
  /// every stream does.
  [[nodiscard]] std::optional<TooMuch> tooMuchFor(const arm::ArmModel& arm, const ActiveFrames& active) const;

 private:
  std::optional<double> tool_;  // [kg], commanded; absent: by a name, or not at all
  std::optional<double> load_;  // [kg]
};

}  // namespace cobot_command::blocks
