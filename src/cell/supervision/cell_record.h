// What the supervisor has carried out, and nothing that it has only heard: the tuple, and who was
// acknowledged what. All changes go through the journal.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "cobot_command/cell/model/rules.h"
#include "cobot_command/cell/supervision/journal.h"

namespace cobot_command::cell {

class CellRecord {
 public:
  struct Robot {
    std::uint64_t session = 0;  ///< 0: none is listened to
    std::uint64_t acknowledged = 0;
    std::deque<NumberedEvent> recent;  ///< the last ones that were acknowledged in the session
    bool is_out = false;
    std::uint32_t joins = 0;  ///< how often it was let in, by itself or by a person
  };

  /// `replace`: behind `most` records; empty: never.
  CellRecord(const Rules& rules, journal::Append append, journal::Replace replace, std::size_t most);

  /// Takes over what stands in a journal; false: it does not fit the rules.
  [[nodiscard]] bool replay(const std::vector<journal::Record>& records);
  /// False: the journal could not be written; nothing has changed then, and nothing ever will any more.
  [[nodiscard]] bool start(const std::string& hash, std::uint64_t instance);
  [[nodiscard]] bool join(RobotIndex robot, std::uint64_t session, std::uint64_t acknowledged);
  /// Precondition: its number is the one behind the last, or, of a withdrawal of what was never granted, two
  /// behind; the rules let it happen.
  [[nodiscard]] bool carryOut(RobotIndex robot, const NumberedEvent& event);
  [[nodiscard]] bool recover(RobotIndex robot, automata::StateIndex place, const std::string& person);
  [[nodiscard]] bool takeOut(RobotIndex robot, const std::string& person);
  /// Here and below: what is so already is not written again.
  [[nodiscard]] bool hold(bool on, const std::string& reason);
  [[nodiscard]] bool finish(bool on);

  /// With that robot at that place, and what it holds there; nothing, where another robot holds some of that.
  [[nodiscard]] std::optional<automata::Tuple> placed(RobotIndex robot, automata::StateIndex place) const;
  [[nodiscard]] std::optional<RobotIndex> robotNamed(const std::string& name) const;
  [[nodiscard]] const Robot& robot(RobotIndex robot) const { return robots_[robot]; }
  [[nodiscard]] const automata::Tuple& tuple() const { return tuple_; }
  [[nodiscard]] std::optional<RobotIndex> holderOf(ZoneIndex zone) const;
  [[nodiscard]] std::uint64_t instance() const { return instance_; }
  [[nodiscard]] std::uint64_t epoch() const { return epoch_; }
  [[nodiscard]] std::uint64_t events() const { return events_; }
  [[nodiscard]] bool isBroken() const { return is_broken_; }
  /// Why nothing is granted; nothing: it is.
  [[nodiscard]] const std::optional<std::string>& held() const { return held_; }
  [[nodiscard]] bool isFinishing() const { return is_finishing_; }

 private:
  bool write(const journal::Record& record);
  /// False: it is of a robot that is not there, or cannot happen.
  bool apply(const journal::Record& record);
  bool apply(const journal::CarriedOut& record);
  bool apply(const journal::TakenOut& record);
  bool apply(const journal::Snapshot& snapshot);
  [[nodiscard]] journal::Snapshot snapshot() const;
  void makeAnew();
  [[nodiscard]] std::optional<automata::StateIndex> placeNamed(RobotIndex robot,
                                                               const std::string& name) const;

  const Rules& rules_;
  journal::Append append_;
  journal::Replace replace_;
  std::size_t most_;
  std::size_t records_ = 0;  ///< since the journal was made, or could not be made anew
  std::string hash_;
  automata::Tuple tuple_;
  std::vector<Robot> robots_;
  std::uint64_t instance_ = 0;
  std::uint64_t epoch_ = 0;
  std::uint64_t events_ = 0;
  bool is_broken_ = false;
  std::optional<std::string> held_;
  bool is_finishing_ = false;
};

}  // namespace cobot_command::cell
