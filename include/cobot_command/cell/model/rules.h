// Decides which event may happen next in a cell: combines the supervisors of all its parts.
//
// A state is the tuple of the whole problem. Immutable; safe to share between threads.
#pragma once

#include <memory>
#include <vector>

#include "cobot_command/automata/composition.h"
#include "cobot_command/automata/supervisor.h"
#include "cobot_command/automata/undo.h"
#include "cobot_command/cell/model/cell_model.h"
#include "cobot_command/cell/model/supervisors.h"

namespace cobot_command::cell {

class Rules {
 public:
  /// Precondition: `parts` belong to that model. `policy` None: zones are ignored.
  Rules(CellModel model, const std::vector<PartSupervisor>& parts, Policy policy);
  ~Rules();
  Rules(Rules&&) noexcept;

  [[nodiscard]] automata::Decision decide(const automata::Tuple& state, automata::EventIndex event) const;
  [[nodiscard]] const automata::Tuple& initial() const { return composition_.initial(); }
  /// True if all robots are at home.
  [[nodiscard]] bool isHome(const automata::Tuple& state) const {
    return composition_.isMarked(state.data());
  }
  /// The state before an unused booking or go; std::nullopt: it is not the last event of its robot.
  [[nodiscard]] std::optional<automata::Tuple> undone(const automata::Tuple& state,
                                                      automata::EventIndex event) const;

  /// True if they share zones, directly or through others.
  [[nodiscard]] bool haveToDoWithEachOther(RobotIndex one, RobotIndex other) const {
    return part_of_robot_[one] == part_of_robot_[other];
  }
  /// The robots that cannot reach home from that state one after the other; empty: all can.
  [[nodiscard]] std::vector<RobotIndex> stuckIn(const automata::Tuple& state) const;
  /// A zone held by another robot, and the mechanism that could enter it automatically; std::nullopt: there
  /// is none.
  struct Intrusion {
    RobotIndex mechanism = 0;
    ZoneIndex zone = 0;
    RobotIndex holder = 0;
  };
  [[nodiscard]] std::optional<Intrusion> intrusionIn(const automata::Tuple& state) const;
  /// The robots that must continue before `robot` can reach home, in the order in which they do.
  [[nodiscard]] std::vector<RobotIndex> aheadOf(const automata::Tuple& state, RobotIndex robot) const;

  [[nodiscard]] const CellModel& model() const { return model_; }
  [[nodiscard]] Policy policy() const { return policy_; }

 private:
  struct Part;

  [[nodiscard]] std::optional<Intrusion> intrusionOf(RobotIndex robot, const automata::Tuple& state) const;

  CellModel model_;
  Policy policy_;
  automata::Composition composition_;
  automata::Undo undo_;
  std::vector<std::unique_ptr<Part>> parts_;
  std::vector<std::size_t> part_of_event_;
  std::vector<std::size_t> part_of_robot_;
};

}  // namespace cobot_command::cell
