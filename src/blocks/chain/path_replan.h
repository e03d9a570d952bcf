// That what is not sent of a chain has the feedrate that is asked for: planned anew, beside the core.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "chain/path_chain.h"

#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/blocks/shared/path_controlled.h"

namespace cobot_command::blocks {

class PathReplan {
 public:
  /// `chain`: has to live longer.
  explicit PathReplan(PathChain& chain) : chain_(chain) {}

  void ask(double feedrate);
  /// What was refused for the goals that there were may do for others.
  void goalsChanged() { refusal_.clear(); }

  /// What is next has the feedrate that is asked for, or a lower one, as it cannot have that.
  [[nodiscard]] bool isServed() const;
  /// Nothing: all that is not sent has it, cannot have it, or is being planned.
  [[nodiscard]] std::optional<PathWork> take();
  /// See PathControlled. What was rewound has to be planned: else that is a failure of its goals.
  [[nodiscard]] std::optional<std::string> answered(const Detail& found);
  [[nodiscard]] std::optional<Failure> takeFailure() { return std::exchange(failure_, std::nullopt); }
  /// Why it waits, when it is not served.
  [[nodiscard]] std::string text() const;

 private:
  /// Of which chain, and for which feedrate.
  using Wanted = std::pair<CommandKey, double>;
  [[nodiscard]] Wanted wanted() const { return {chain_.nextKey(), feedrate_}; }

  PathChain& chain_;
  double feedrate_ = 1.0;
  std::optional<Wanted> under_way_;
  std::optional<Failure> failure_;
  std::string refusal_;  ///< of the feedrate, by the goals that there are; empty: none
};

}  // namespace cobot_command::blocks
