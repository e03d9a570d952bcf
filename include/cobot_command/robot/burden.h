// The payload of the arm: the tool, and the load in the tool.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/robot/active_frames.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::robot {

/// A payload above that of the arm.
struct TooMuch {
  std::string text;    ///< "the active tool has 8 kg, tm5-900 carries 4 kg"
  double payload = 0;  ///< largest allowed payload [kg]
};

class Burden {
 public:
  /// Stores the tool or the load that the command sets; false: it sets neither. `behind_motion`: the robot
  /// may still have to finish other motions before the change.
  bool accepted(const script::ScriptCommand& command, bool behind_motion);
  /// The changes that waited for a motion have taken effect.
  void queueDone() { tool_.behind_motion = load_.behind_motion = false; }
  /// The queue was emptied, or may have been: it is unknown whether a queued change has taken effect.
  void stopped();
  /// Another client may have changed it.
  void forget() { *this = {}; }

  /// Load in the tool, as commanded [kg]; nullopt: not commanded, or unknown.
  [[nodiscard]] std::optional<double> load() const { return load_.mass; }

  /// nullopt: the arm can carry the known payload. `active`: used if it has the mass of the tool, which not
  /// every stream has.
  [[nodiscard]] std::optional<TooMuch> tooMuchFor(const arm::ArmModel& arm, const ActiveFrames& active) const;

 private:
  struct Commanded {
    std::optional<double> mass;  // [kg]; nullopt: set by a name, or not at all
    bool behind_motion = false;
  };
  Commanded tool_;
  Commanded load_;
};

}  // namespace cobot_command::robot
