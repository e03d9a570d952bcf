// What may happen next in a cell: the supervisors of all its parts, asked as one.
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
  /// Precondition: `parts` are of that model. `policy` None: zones are not looked at.
  Rules(CellModel model, const std::vector<PartSupervisor>& parts, Policy policy);
  ~Rules();
  Rules(Rules&&) noexcept;

  [[nodiscard]] automata::Decision decide(const automata::Tuple& state, automata::EventIndex event) const;
  [[nodiscard]] const automata::Tuple& initial() const { return composition_.initial(); }
  /// All are at home.
  [[nodiscard]] bool isHome(const automata::Tuple& state) const {
    return composition_.isMarked(state.data());
  }
  /// Where all were before a booking, or a go, that nothing was done with; none: it is not the last thing
  /// that its robot did.
  [[nodiscard]] std::optional<automata::Tuple> undone(const automata::Tuple& state,
                                                      automata::EventIndex event) const;

  /// They share zones, directly or through others.
  [[nodiscard]] bool haveToDoWithEachOther(RobotIndex one, RobotIndex other) const {
    return part_of_robot_[one] == part_of_robot_[other];
  }
  /// The robots that could not come home from there, one after the other; empty: all could.
  [[nodiscard]] std::vector<RobotIndex> stuckIn(const automata::Tuple& state) const;
  /// A zone that another holds there, and the mechanism that could enter it by itself; none: nobody could.
  struct Intrusion {
    RobotIndex mechanism = 0;
    ZoneIndex zone = 0;
    RobotIndex holder = 0;
  };
  [[nodiscard]] std::optional<Intrusion> intrusionIn(const automata::Tuple& state) const;
  /// The robots that have to go on before `robot` can come home, in the order in which they do.
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
