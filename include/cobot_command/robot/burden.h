// What the arm carries: the tool, and what that holds.
#pragma once

#include <optional>
#include <string>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/robot/active_frames.h"
#include "cobot_command/script/script_command.h"

namespace cobot_command::robot {

/// More than the arm carries.
struct TooMuch {
  std::string text;    ///< "the active tool has 8 kg, tm5-900 carries 4 kg"
  double payload = 0;  ///< [kg]
};

class Burden {
 public:
  /// Takes what the command says of tool or load, if it does. `behind_motion`: the robot may still have to
  /// finish others first.
  bool accepted(const script::ScriptCommand& command, bool behind_motion);
  /// What waited behind a motion has come.
  void queueDone() { tool_.behind_motion = load_.behind_motion = false; }
  /// The queue was emptied, or may be: of a change that waited in it nobody knows whether it came.
  void stopped();
  /// Somebody else may have changed it.
  void forget() { *this = {}; }

  /// Of what the tool holds, as it was commanded [kg]; nothing: it was not, or nobody knows.
  [[nodiscard]] std::optional<double> load() const { return load_.mass; }

  /// Nothing when it can carry what is known of. `active` counts where it tells the mass of the tool; not
  /// every stream does.
  [[nodiscard]] std::optional<TooMuch> tooMuchFor(const arm::ArmModel& arm, const ActiveFrames& active) const;

 private:
  struct Commanded {
    std::optional<double> mass;  // [kg]; absent: by a name, or not at all
    bool behind_motion = false;
  };
  Commanded tool_;
  Commanded load_;
};

}  // namespace cobot_command::robot
