// On the state space of the verification, which knows nothing of how rules are found.
#include <algorithm>
#include <deque>
#include <set>

#include "verification_model.h"
#include <fmt/format.h>

#include "cobot_command/automata/frontier_rules.h"

namespace cobot_command::automata {
namespace {

/// One mistake is seen from many states.
constexpr std::size_t kDifferencesShown = 5;

class Comparison {
 public:
  Comparison(const CompiledSupervisor& supervisor, const std::vector<FrontierRule>& rules)
      : rules_(rules),
        problem_(supervisor.problem),
        frontier_(supervisor.frontier.begin(), supervisor.frontier.end()),
        model_(supervisor.problem) {}

  RuleComparison run(std::size_t max_states) {
    if (!model_.explore(max_states)) {
      found_.faults.push_back(fmt::format(
          "there are more than {} states: rules cannot be compared with the frontier. Raise max_states",
          max_states));
      return std::move(found_);
    }
    before_.resize(model_.states().size());
    is_reached_.resize(model_.states().size(), false);
    std::deque<std::uint32_t> open = {0};
    is_reached_[0] = true;
    for (; !open.empty(); open.pop_front()) {
      ++found_.states;
      for (const auto& edge : model_.states()[open.front()].edges) {
        if (isRefused(open.front(), edge) || is_reached_[edge.to]) continue;
        is_reached_[edge.to] = true;
        before_[edge.to] = {open.front(), edge.event};
        open.push_back(edge.to);
      }
    }
    if (differences_ > kDifferencesShown) {
      found_.faults.push_back(fmt::format("and {} more differences", differences_ - kDifferencesShown));
    }
    return std::move(found_);
  }

 private:
  struct Before {
    std::uint32_t state = 0;
    EventIndex event = 0;
  };

  /// By the frontier; that the rules say something else is written down.
  bool isRefused(std::uint32_t from, const verification::Edge& edge) {
    const Tuple& to = model_.states()[edge.to].tuple;
    const bool can_be = problem_.events[edge.event].controllable;
    const bool by_frontier = can_be && frontier_.count(to) != 0;
    const auto rule = std::find_if(rules_.begin(), rules_.end(),
                                   [&](const FrontierRule& one) { return can_be && one.matches(to); });
    const bool by_rules = rule != rules_.end();
    if (by_frontier && by_rules) ++found_.refused;
    if (by_frontier != by_rules && ++differences_ <= kDifferencesShown) {
      const std::string& name = problem_.events[edge.event].name;
      found_.faults.push_back(
          by_rules
              ? fmt::format("a rule is too wide: \"{}\" refuses {} after {}, which the supervisor grants",
                            toString(*rule, problem_), name, wayTo(from))
              : fmt::format(
                    "the rules are too narrow: none refuses {} after {}, which the supervisor refuses", name,
                    wayTo(from)));
    }
    return by_frontier;
  }

  [[nodiscard]] std::string wayTo(std::uint32_t state) const {
    std::vector<std::string> events;
    for (; state != 0; state = before_[state].state) {
      events.push_back(problem_.events[before_[state].event].name);
    }
    std::reverse(events.begin(), events.end());
    return events.empty() ? "the start" : fmt::format("{}", fmt::join(events, " "));
  }

  const std::vector<FrontierRule>& rules_;
  const Problem& problem_;
  std::set<Tuple> frontier_;
  verification::Model model_;
  std::vector<Before> before_;
  std::vector<bool> is_reached_;
  std::size_t differences_ = 0;
  RuleComparison found_;
};

}  // namespace

RuleComparison compareRules(const CompiledSupervisor& supervisor, const std::vector<FrontierRule>& rules,
                            std::size_t max_states) {
  return Comparison(supervisor, rules).run(max_states);
}

}  // namespace cobot_command::automata
