// Decides without a table of states: a booking is granted if afterwards all robots can still reach home one
// after the other (doc/cell.md).
//
// For problems of robots and zones: each plant is a robot, each spec a zone that one robot holds at a time.
// The zones that a robot holds follow from its place, as in the model of a cell.
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
  /// Which zones a robot on a path is assumed to need.
  enum class Claim {
    StepByStep,  ///< one zone after the other, as in its program, with releases in between
    WholeCycle   ///< all zones of its program at once, as in the banker's algorithm; refuses more
  };

  /// Why it cannot decide for a problem: an uncontrollable event takes a zone, or two plants share an event.
  /// Empty: it can decide.
  [[nodiscard]] static std::vector<std::string> objectionsTo(const Problem& problem);

  /// Precondition: faultsOf(problem) and objectionsTo(problem) are empty.
  explicit SafeOrder(Problem problem, Claim claim = Claim::StepByStep);

  /// The robots in an order in which they can reach home. If it has fewer robots than the cell, none of the
  /// others can follow.
  [[nodiscard]] std::vector<std::size_t> orderHome(const Tuple& state) const;
  [[nodiscard]] bool isSafe(const Tuple& state) const { return orderHome(state).size() == robots_.size(); }

  /// The robots that must reach home before `robot` can, in a possible order; each of them is necessary. Also
  /// empty if `robot` cannot reach home at all. `robot`: an automaton, as in orderHome().
  [[nodiscard]] std::vector<std::size_t> aheadOf(const Tuple& state, std::size_t robot) const;

  /// Precondition: `state` is the initial state, or was reached by granted events.
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
    std::vector<std::size_t> zones;      ///< the specs with which it shares events
  };
  struct Scratch;

  /// False: the robot cannot reach home, and the state is unchanged.
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
      holder_of_state_;  ///< [automaton][local state]: the robot; none for a state without an owner
};

}  // namespace cobot_command::automata
