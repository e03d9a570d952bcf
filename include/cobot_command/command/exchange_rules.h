// The node's rules for the interface of SRCI, independent of a goal.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "cobot_command/common/time.h"
#include "cobot_command/tables/entries.h"

namespace cobot_command::command {

/// Which side takes precedence if this layer and the controller's project have different values of an entry.
enum class SyncMode : int {
  None = 0,            ///< none: the difference is only reported
  ClientToServer = 1,  ///< this layer: its value is written to the controller
  ServerToClient = 2,  ///< the controller: its value is copied into the table of this layer
  Automatic = 3        ///< the side that has changed the value
};

/// Of one set. The integers are values of SyncMode as given in the parameters; any value may be given.
struct SyncModes {
  /// For the first comparison after enabling; 0..2, because it is not known yet which side has changed a
  /// value.
  int start = 0;
  int run = 0;  ///< for all later comparisons; 0..3
};

/// One value for each data set that both sides have, by the kinds of its entries.
template <class Of>
struct BySet {
  Of tools{};
  Of frames{};
  Of loads{};

  [[nodiscard]] Of& of(tables::Kind kind) { return this->*memberOf(kind); }
  [[nodiscard]] const Of& of(tables::Kind kind) const { return this->*memberOf(kind); }

 private:
  [[nodiscard]] static constexpr Of BySet::*memberOf(tables::Kind kind) {
    switch (kind) {
      case tables::Kind::Tool:
        return &BySet::tools;
      case tables::Kind::Frame:
        return &BySet::frames;
      default:
        return &BySet::loads;
    }
  }
};

struct ExchangeRules {
  bool required = false;                           ///< motions are refused while the interface is not enabled
  Duration sync_period = std::chrono::seconds(1);  ///< between two reads of the controller's values
  BySet<SyncModes> sync;
};

/// The first mode that does not exist, or that is invalid at the start; in words.
[[nodiscard]] std::optional<std::string> faultIn(const ExchangeRules& rules);

}  // namespace cobot_command::command
