// What the random events know of the moves they have sent: no Done without the report of its tag after it was
// sent, nor while the status stream shows the robot in motion.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "cobot_command/blocks/shared/goal_values.h"
#include "cobot_command/blocks/shared/outcome.h"

namespace cobot_command::testing {

class MotionLedger {
 public:
  struct Motion {
    bool needs_tag = false;
    bool exits = false;  ///< it is done later than its motion
    std::string begin;   ///< of its script, by which it is known on the wire
  };

  void add(blocks::GoalId goal, Motion motion) { entries_[goal].motion = std::move(motion); }

  // --- What has happened.
  /// `tag`: of it; 0: none.
  void sent(const std::string& id, const std::string& script, int tag) {
    for (auto& [goal, entry] : entries_) {
      if (script.find(entry.motion.begin) != 0) continue;
      EXPECT_TRUE(entry.script_id.empty() || entry.may_be_sent_again) << "goal " << goal << " was sent twice";
      entry.may_be_sent_again = entry.accepted = entry.reported = false;
      entry.script_id = id;
      entry.tag = tag;
    }
  }
  void accepted(const std::string& script_id) {
    for (auto& [goal, entry] : entries_) {
      if (entry.script_id == script_id) entry.accepted = true;
    }
  }
  void reported(int tag) {
    for (auto& [goal, entry] : entries_) {
      if (entry.tag == tag) entry.reported = true;
    }
  }
  /// What was interrupted goes on.
  void goesOn() {
    for (auto& [goal, entry] : entries_) entry.may_be_sent_again = true;
  }

  /// Of those that have ended since the last call; they are told, and forgotten. `stands`: as far as the
  /// stream shows.
  void check(const std::function<const blocks::Outcome*(blocks::GoalId)>& outcome_of, bool stands,
             const std::function<void(const blocks::Outcome&)>& tell) {
    for (auto it = entries_.begin(); it != entries_.end();) {
      const blocks::Outcome* outcome = outcome_of(it->first);
      if (outcome == nullptr) {
        ++it;
        continue;
      }
      tell(*outcome);
      if (outcome->ending == blocks::Ending::Done) checkDone(it->first, it->second, stands);
      it = entries_.erase(it);
    }
  }

 private:
  struct Entry {
    Motion motion;
    std::string script_id = {};
    int tag = 0;
    bool reported = false;
    bool accepted = false;
    bool may_be_sent_again = false;  ///< it was interrupted
  };

  static void checkDone(blocks::GoalId goal, const Entry& entry, bool stands) {
    const bool needs_tag = entry.motion.needs_tag;
    EXPECT_TRUE(entry.accepted) << "goal " << goal;
    EXPECT_EQ(needs_tag, entry.tag != 0);
    EXPECT_TRUE(entry.reported || !needs_tag) << "goal " << goal;
    EXPECT_TRUE(stands || !needs_tag || entry.motion.exits) << "goal " << goal;
  }

  std::map<blocks::GoalId, Entry> entries_;
};

}  // namespace cobot_command::testing
