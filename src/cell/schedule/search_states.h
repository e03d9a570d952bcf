// The places of all robots in their cycles with the state of the supervisor, each once, and what is granted
// there.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "workload.h"

#include "cobot_command/automata/composition.h"
#include "cobot_command/automata/supervisor.h"

namespace cobot_command::cell {

using Rule = std::function<automata::Decision(const automata::Tuple&, automata::EventIndex)>;

class SearchStates {
 public:
  using Number = std::uint32_t;

  /// The work has to live longer. The initial state has number 0.
  SearchStates(const Workload& work, Rule rule, const automata::Tuple& initial);

  /// Behind the next event of a robot; none: it is not granted. Precondition: the robot has a next event.
  [[nodiscard]] std::optional<Number> behind(Number state, std::size_t robot);
  /// By robot: how many of its events have happened. Valid until behind() is called.
  [[nodiscard]] const std::uint32_t* counts(Number state) const {
    return keys_.data() + state * (robots_ + automata_);
  }
  [[nodiscard]] Number size() const { return static_cast<Number>(keys_.size() / (robots_ + automata_)); }

 private:
  static constexpr Number kUnknown = ~Number{0};
  static constexpr Number kRefused = kUnknown - 1;
  using Key = std::vector<std::uint32_t>;
  struct KeyHash {
    std::size_t operator()(const Key& key) const;
  };

  Number numberOf(const Key& key);

  const Workload& work_;
  Rule rule_;
  std::size_t robots_;
  std::size_t automata_;
  std::unordered_map<Key, Number, KeyHash> numbers_;
  std::vector<std::uint32_t> keys_;  ///< of each: the counts, then the tuple
  std::vector<Number> behind_;       ///< by state and robot
};

}  // namespace cobot_command::cell
