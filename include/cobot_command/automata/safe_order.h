// Decisions without a table of states: a booking is granted where all robots can be brought home one after
// the other behind it (cell.md, M26).
//
// For problems of robots and zones: each plant is a robot, each spec a zone that one robot holds at a time.
// What a robot holds follows from its place, as it does in the model of a cell.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "cobot_command/automata/composition.h"
#include "cobot_command/automata/problem.h"
#include "cobot_command/automata/supervisor.h"

namespace cobot_command::automata {

class SafeOrder {
 public:
  /// What a robot on its way is taken to need.
  enum class Claim {
    StepByStep,  ///< one zone after the other, as its program does, giving back on the way
    WholeCycle   ///< all zones of its program at once, as bankers do; refuses more
  };

  /// Why it cannot decide for a problem: an uncontrollable event takes a zone, or two plants share an event.
  /// Empty: it can.
  [[nodiscard]] static std::vector<std::string> objectionsTo(const Problem& problem);

  /// Precondition: faultsOf(problem) and objectionsTo(problem) are empty.
  explicit SafeOrder(Problem problem, Claim claim = Claim::StepByStep);

  /// The robots in an order in which they can come home; fewer than all: after those, none of the others can.
  [[nodiscard]] std::vector<std::size_t> orderHome(const Tuple& state) const;
  [[nodiscard]] bool isSafe(const Tuple& state) const { return orderHome(state).size() == robots_.size(); }

  /// Those that have to come home before one can, in an order in which they can; without any of them it
  /// cannot. Empty, too, where nothing helps. `robot`: an automaton, as in orderHome().
  [[nodiscard]] std::vector<std::size_t> aheadOf(const Tuple& state, std::size_t robot) const;

  /// Precondition: `state` is the initial one, or granted events have led to it.
  [[nodiscard]] Decision decide(const Tuple& state, EventIndex event) const;
  [[nodiscard]] const Tuple& initial() const { return composition_.initial(); }
  [[nodiscard]] const Problem& problem() const { return problem_; }

 private:
  struct Way {
    EventIndex event = 0;
    StateIndex to = 0;
  };
  struct Robot {
    std::size_t automaton = 0;
    std::vector<std::vector<Way>> ways;  ///< by place
    std::vector<bool> is_home;           ///< by place
    std::vector<std::size_t> zones;      ///< the specs that it shares events with
  };
  struct Scratch;

  /// False: it cannot come home, and the state is as before.
  [[nodiscard]] bool bringHome(const Robot& robot, Tuple& state, Scratch& scratch) const;
  [[nodiscard]] bool bringHomeAtOnce(const Robot& robot, Tuple& state) const;
  [[nodiscard]] bool comesHomeBehind(const Tuple& state, std::size_t robot,
                                     const std::vector<std::size_t>& others) const;
  [[nodiscard]] const Robot& robotOf(std::size_t automaton) const;
  [[nodiscard]] bool needsDecision(EventIndex event, const Tuple& state) const;

  Problem problem_;
  Claim claim_;
  Composition composition_;
  std::vector<Robot> robots_;
  std::vector<bool> takes_zone_;  ///< by event
  std::vector<std::vector<std::size_t>>
      holder_of_state_;  ///< by automaton and local state: the robot; that of no zone: none
};

}  // namespace cobot_command::automata
