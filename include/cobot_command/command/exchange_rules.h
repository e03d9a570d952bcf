// What the node wants of the interface of SRCI, whatever a goal says.
#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "cobot_command/common/time.h"
#include "cobot_command/tables/entries.h"

namespace cobot_command::command {

/// Who wins where this layer and the controller's project have different values of an entry.
enum class SyncMode : int {
  None = 0,            ///< nobody: the difference is told
  ClientToServer = 1,  ///< ours, which is written to the controller
  ServerToClient = 2,  ///< the controller's, which is taken into our table
  Automatic = 3        ///< who has changed it
};

/// Of one set; numbers of SyncMode, as people give them.
struct SyncModes {
  int start = 0;  ///< at the first look behind the enabling; 0..2, as nobody knows then who has changed what
  int run = 0;    ///< from then on; 0..3
};

/// One for each set that both sides have, by the kinds of its entries.
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
  Duration sync_period = std::chrono::seconds(1);  ///< between two looks at the controller's values
  BySet<SyncModes> sync;
};

/// The first mode that does not exist, or that does not at the start; in words.
[[nodiscard]] std::optional<std::string> faultIn(const ExchangeRules& rules);

}  // namespace cobot_command::command
