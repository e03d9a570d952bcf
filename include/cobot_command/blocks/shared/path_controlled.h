// The side of a run that paths are controlled by from outside of its goals.
#pragma once

#include <optional>

#include "cobot_command/common/time.h"
#include "cobot_command/path/path_controls.h"

namespace cobot_command::blocks {

class PathControlled {
 public:
  /// They are so now; first when its turn comes.
  virtual void use(const path::PathControls& controls, Instant now) = 0;
  /// What automatic tracking objects are to be switched to now, so that the next goal can load its points;
  /// nothing: they stay as they are.
  [[nodiscard]] virtual std::optional<path::TrackingFlags> wantedTracking() const = 0;

 protected:
  ~PathControlled() = default;
};

}  // namespace cobot_command::blocks
