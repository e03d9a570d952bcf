// The faults of the matrix: what each does, and how a goal may end that it meets.
#pragma once

#include <functional>
#include <ostream>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "block_cases.h"
#include "hostile_rig.h"

namespace cobot_command::hostile {

/// How goals may end. The ids are those of a motion; allowedFor() says what that means for the other blocks.
struct Ends {
  enum class Done { Must, May, Never };
  /// Whose goals meet the fault; all others must be Done.
  enum class Of { All, Motions, Stops };
  Done done = Done::Must;
  std::set<int> ids;
  Of of = Of::All;
};

/// The ids that a goal of this block may end with.
[[nodiscard]] std::set<int> allowedFor(const BlockCase& block, const Ends& ends);
[[nodiscard]] Ends::Done doneFor(const BlockCase& block, const Ends& ends);

using Random = std::mt19937;

struct Variant {
  std::string name;
  /// Before the goal is submitted.
  std::function<void(HostileRig&, Random&)> before;
  Ends ends;
  /// While the goal is Active or Held; a goal that ends sooner does not meet it.
  std::function<void(HostileRig&)> meanwhile;
  Pace pace = Pace::Quick;
  /// The controller executes what the goal failed with: the robot has to be stopped on its way.
  bool stops_robot = false;
};

struct FaultRow {
  std::string name;  ///< the number of the matrix and what it is
  std::vector<Variant> variants;
  /// Each block meets all variants, one after the other; else one for each seed.
  bool all_at_once = false;
};

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest calls
inline void PrintTo(const FaultRow& row, std::ostream* out) {
  *out << row.name;
}

[[nodiscard]] std::vector<FaultRow> faultRows();

}  // namespace cobot_command::hostile
