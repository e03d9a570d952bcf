// What keeps those back who wait, found once as long as nothing changes: in a large cell many wait, each
// report of any robot asks for all of them, and a safe order is looked for behind each.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "cobot_command/automata/composition.h"
#include "cobot_command/cell/supervision/cell_state.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell {

/// Why a request is not granted.
struct Hindrance {
  WaitReason reason = WaitReason::None;
  std::vector<RobotIndex> robots;
};

/// One that has waited for long and can be helped, and who has to go on for that.
struct Helped {
  RobotIndex robot = 0;
  std::vector<RobotIndex> ahead;
};

/// All that hindrances follow from, but for schedules.
struct Situation {
  struct Robot {
    std::uint64_t number = 0;  ///< of what it waits for; 0: nothing
    Instant since;
    bool is_aged = false;
    bool is_able = false;

    bool operator==(const Robot& other) const {
      return number == other.number && since == other.since && is_aged == other.is_aged &&
             is_able == other.is_able;
    }
  };
  automata::Tuple tuple;
  std::vector<Robot> robots;
  std::vector<std::optional<RobotIndex>> intruders;  ///< by zone
  bool grants = true;
  bool is_finishing = false;

  bool operator==(const Situation& other) const {
    return grants == other.grants && is_finishing == other.is_finishing && tuple == other.tuple &&
           robots == other.robots && intruders == other.intruders;
  }
};

struct HindranceMemo {
  /// Forgets what was found in another situation.
  void follow(Situation now) {
    if (now == situation) return;
    situation = std::move(now);
    found.clear();
    helped.reset();
  }

  Situation situation;
  std::map<RobotIndex, std::optional<Hindrance>> found;
  std::optional<std::vector<Helped>> helped;  ///< the one that waits for longest first
};

}  // namespace cobot_command::cell
