#include "cobot_command/automata/verification.h"

#include <algorithm>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "verification_model.h"
#include <fmt/format.h>

#include "cobot_command/common/sha256.h"

namespace cobot_command::automata {
namespace {

using verification::Model;
using verification::State;
using Number = std::uint32_t;

/// Of each kind: one mistake is seen from many states.
constexpr std::size_t kFaultsShown = 3;
constexpr Number kNobody = ~Number{0};

/// The largest set of states without one that breaks a spec, that no uncontrollable event leaves, and in
/// which a marked state is reachable from each: taken away by going over all states until nothing changes.
std::vector<bool> largestSolution(const Model& model) {
  const auto& states = model.states();
  const auto& events = model.problem().events;
  std::vector<bool> good(states.size(), true);
  const auto take_out = [&](Number number) {
    const bool was_good = good[number];
    good[number] = false;
    return was_good;
  };
  for (bool changed = true; changed;) {
    changed = false;
    for (Number number = 0; number < states.size(); ++number) {
      const State& state = states[number];
      const bool is_left = std::any_of(state.edges.begin(), state.edges.end(), [&](const auto& edge) {
        return !events[edge.event].controllable && !good[edge.to];
      });
      if (state.breaks_spec || is_left) changed = take_out(number) || changed;
    }
    std::vector<bool> comes_home(states.size(), false);
    for (bool found = true; found;) {
      found = false;
      for (Number number = static_cast<Number>(states.size()); number-- > 0;) {
        if (!good[number] || comes_home[number]) continue;
        const State& state = states[number];
        if (state.is_marked || std::any_of(state.edges.begin(), state.edges.end(), [&](const auto& edge) {
              return good[edge.to] && comes_home[edge.to];
            })) {
          comes_home[number] = found = true;
        }
      }
    }
    for (Number number = 0; number < states.size(); ++number) {
      if (!comes_home[number]) changed = take_out(number) || changed;
    }
  }
  return good;
}

class Verifier {
 public:
  Verifier(const CompiledSupervisor& supervisor, const Holds& holds)
      : holds_(holds),
        frontier_(supervisor.frontier.begin(), supervisor.frontier.end()),
        model_(supervisor.problem) {}

  Verification verify(const std::string& fingerprint, VerificationLimits limits) {
    if (!model_.explore(limits.max_states)) {
      fault("there are more than {} states: raise max_states, or use the policy safe_order",
            limits.max_states);
      return finish();
    }
    countTroubles();
    runSupervised(fingerprint);
    checkWayHome();
    checkLargest();
    checkUndo();
    return finish();
  }

 private:
  struct Before {
    Number state = kNobody;
    EventIndex event = 0;
  };

  void countTroubles() {
    const auto& states = model_.states();
    found_.counts.plant_and_spec = states.size();
    for (const State& state : states) {
      if (state.edges.empty() && !state.is_marked) ++found_.counts.dead;
    }
    found_.counts.blocking = states.size() - homeward(std::vector<bool>(states.size(), true)).second;
  }

  /// Which of `within` reach a marked state inside of it, and how many.
  [[nodiscard]] std::pair<std::vector<bool>, std::size_t> homeward(const std::vector<bool>& within) const {
    const auto& states = model_.states();
    std::vector<bool> reaches(states.size(), false);
    std::size_t count = 0;
    for (bool found = true; found;) {
      found = false;
      for (Number number = static_cast<Number>(states.size()); number-- > 0;) {
        if (!within[number] || reaches[number]) continue;
        bool can = states[number].is_marked;
        for (const auto& edge : states[number].edges) {
          can = can || (within[edge.to] && reaches[edge.to] && !isRefused(edge));
        }
        if (!can) continue;
        reaches[number] = found = true;
        ++count;
      }
    }
    return {std::move(reaches), count};
  }

  [[nodiscard]] bool isFrontier(Number number) const {
    return frontier_.count(model_.states()[number].tuple) != 0;
  }
  [[nodiscard]] bool isRefused(const verification::Edge& edge) const {
    return is_supervised_ && model_.problem().events[edge.event].controllable && isFrontier(edge.to);
  }

  /// All that can be reached under the supervisor, in canonical order: events by name, states breadth first.
  void runSupervised(const std::string& fingerprint) {
    is_supervised_ = true;
    const auto& states = model_.states();
    before_.assign(states.size(), {});
    std::vector<Number> index(states.size(), kNobody);
    order_ = {0};
    index[0] = 0;
    Sha256 hash;
    for (std::size_t at = 0; at < order_.size(); ++at) {
      const Number number = order_[at];
      checkState(number);
      for (const auto& edge : states[number].edges) {
        if (isRefused(edge)) {
          ++found_.counts.refused_beyond_spec;
          continue;
        }
        if (index[edge.to] == kNobody) {
          index[edge.to] = static_cast<Number>(order_.size());
          order_.push_back(edge.to);
          before_[edge.to] = {number, edge.event};
        }
        ++found_.counts.transitions;
        hash.update(fmt::format("{} {} {}\n", at, nameOf(edge.event), index[edge.to]));
      }
    }
    found_.counts.states = order_.size();
    hash.update("marked");
    for (std::size_t at = 0; at < order_.size(); ++at) {
      if (states[order_[at]].is_marked) hash.update(fmt::format(" {}", at));
    }
    hash.update("\n");
    const std::string found = hash.hex();
    if (!fingerprint.empty() && found != fingerprint) {
      fault("it is not the supervisor that was synthesized: its fingerprint is {}, expected {}", found,
            fingerprint);
    }
  }

  void checkState(Number number) {
    const State& state = model_.states()[number];
    found_.counts.refused_by_spec += state.refused_by_spec;
    if (state.breaks_spec) {
      fault("not controllable: a spec blocks an event that cannot be refused, after {}", wayTo(number));
    }
    for (const auto& edge : state.edges) {
      if (!model_.problem().events[edge.event].controllable && isFrontier(edge.to)) {
        fault("not controllable: {} cannot be refused, and leads to a forbidden state, after {}",
              nameOf(edge.event), wayTo(number));
      }
    }
    checkHolders(number);
  }

  void checkHolders(Number number) {
    if (holds_.empty()) return;
    const Tuple& tuple = model_.states()[number].tuple;
    std::vector<std::pair<std::size_t, std::size_t>> held;  // zone and robot
    for (std::size_t robot = 0; robot < tuple.size(); ++robot) {
      if (holds_[robot].empty()) continue;
      for (const std::size_t zone : holds_[robot][tuple[robot]]) held.emplace_back(zone, robot);
    }
    std::sort(held.begin(), held.end());
    for (std::size_t one = 1; one < held.size(); ++one) {
      if (held[one].first != held[one - 1].first) continue;
      fault("no mutual exclusion: {} and {} both hold zone {} after {}",
            model_.problem().automata[held[one - 1].second].name,
            model_.problem().automata[held[one].second].name, held[one].first, wayTo(number));
    }
  }

  void checkWayHome() {
    std::vector<bool> within(model_.states().size(), false);
    for (const Number number : order_) within[number] = true;
    const std::vector<bool> reaches = homeward(within).first;
    for (const Number number : order_) {
      if (!reaches[number]) fault("it blocks: no sequence leads home after {}", wayTo(number));
    }
  }

  void checkLargest() {
    const std::vector<bool> good = largestSolution(model_);
    for (const Number number : order_) {
      if (!good[number]) fault("it allows a sequence after which not all can return home: {}", wayTo(number));
      for (const auto& edge : model_.states()[number].edges) {
        if (!isRefused(edge) || !good[edge.to]) continue;
        fault("not maximally permissive: it refuses {} after {}, although all could return home from there",
              nameOf(edge.event), wayTo(number));
      }
    }
  }

  /// What a robot booked and has done nothing with it can take back (M33): where the supervisor may be. Only
  /// cells do that.
  void checkUndo() {
    if (holds_.empty()) return;
    std::vector<bool> reached(model_.states().size(), false);
    for (const Number number : order_) reached[number] = true;
    for (EventIndex event = 0; event < model_.problem().events.size(); ++event) {
      if (!model_.isBooking(event)) continue;
      for (const Number number : order_) {
        const auto before = model_.before(model_.states()[number].tuple, event);
        if (!before) continue;
        const auto at = model_.find(*before);
        if (at && reached[*at]) continue;
        fault("withdrawn, {} leads to a state that the supervisor never reaches, after {}", nameOf(event),
              wayTo(number));
      }
    }
  }

  [[nodiscard]] const std::string& nameOf(EventIndex event) const {
    return model_.problem().events[event].name;
  }

  [[nodiscard]] std::string wayTo(Number number) const {
    std::vector<std::string> events;
    for (Number at = number; before_[at].state != kNobody; at = before_[at].state) {
      events.push_back(nameOf(before_[at].event));
    }
    std::reverse(events.begin(), events.end());
    return events.empty() ? "the start" : fmt::format("{}", fmt::join(events, " "));
  }

  template <class... Values>
  void fault(fmt::format_string<Values...> text, Values&&... values) {
    const fmt::string_view kind = text;
    if (++faults_[{kind.data(), kind.size()}] > kFaultsShown) return;
    found_.faults.push_back(fmt::format(text, std::forward<Values>(values)...));
  }

  Verification finish() {
    for (const auto& [kind, count] : faults_) {
      const std::string beginning(kind.substr(0, kind.find_first_of(":{")));
      if (count > kFaultsShown) {
        found_.faults.push_back(fmt::format("and {} more: {}", count - kFaultsShown, beginning));
      }
    }
    return std::move(found_);
  }

  const Holds& holds_;
  std::set<Tuple> frontier_;
  Model model_;
  bool is_supervised_ = false;
  std::vector<Before> before_;
  std::vector<Number> order_;                       ///< what is reached under the supervisor
  std::map<std::string_view, std::size_t> faults_;  ///< by the words that they are told with
  Verification found_;
};

std::vector<std::string> formFaults(const CompiledSupervisor& supervisor, const Holds& holds) {
  std::vector<std::string> faults = faultsOf(supervisor.problem);
  if (!faults.empty()) return faults;
  const auto& automata = supervisor.problem.automata;
  for (const Tuple& tuple : supervisor.frontier) {
    bool fits = tuple.size() == automata.size();
    for (std::size_t index = 0; fits && index < tuple.size(); ++index) {
      fits = tuple[index] < automata[index].states.size();
    }
    if (!fits) faults.emplace_back("a state of the frontier does not belong to the automata");
  }
  bool fits = holds.empty() || holds.size() == automata.size();
  for (std::size_t index = 0; fits && index < holds.size(); ++index) {
    fits = holds[index].empty() || holds[index].size() == automata[index].states.size();
  }
  if (!fits) faults.emplace_back("held zones are given for states that the robots do not have");
  return faults;
}

}  // namespace

Verification verify(const CompiledSupervisor& supervisor, const std::string& fingerprint, const Holds& holds,
                    VerificationLimits limits) {
  auto faults = formFaults(supervisor, holds);
  if (!faults.empty()) return {std::move(faults), {}};
  return Verifier(supervisor, holds).verify(fingerprint, limits);
}

}  // namespace cobot_command::automata
