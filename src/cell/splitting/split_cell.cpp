#include "cobot_command/cell/splitting/split_cell.h"

#include <optional>
#include <utility>

#include "splitting/path_cuts.h"

namespace cobot_command::cell {
namespace {

/// One for each zone that a step enters, and some for zones that change with what was cut.
constexpr int kMostRounds = 8;

class Splitter {
 public:
  explicit Splitter(SplitCell stages) : stages_(std::move(stages)) {
    for (RobotIndex robot = 0; robot < stages_.planned.size(); ++robot) {
      for (std::size_t path = 0; path < stages_.planned[robot].paths.size(); ++path) {
        paths_.emplace_back(stages_, robot, path);
      }
    }
  }

  /// Nothing: there is no cell that can be held.
  std::optional<SplitCell> split() {
    for (int round = 0; round < kMostRounds; ++round) {
      const bool is_last = round + 1 == kMostRounds;
      bool changed = false;
      for (PathCuts& path : paths_) changed = path.cut(stages_) || changed;
      if (!changed) break;
      if (!settle(is_last)) return std::nullopt;
    }
    for (const PathCuts& path : paths_) path.report(stages_);
    return std::move(stages_);
  }

 private:
  /// Zones and holds anew, and cuts taken back that are worth nothing with these: until all that are left
  /// pay. It ends, as each time a path has none. False: there is no cell that can be held.
  bool settle(bool for_good) {
    while (true) {
      if (!findHolds(stages_).empty()) return false;
      bool reverted = false;
      for (PathCuts& path : paths_) {
        if (path.pay(stages_)) continue;
        path.revert(stages_, for_good);
        reverted = true;
      }
      if (!reverted) return true;
    }
  }

  SplitCell stages_;
  std::vector<PathCuts> paths_;
};

}  // namespace

Result<SplitCell, std::vector<std::string>> splitCell(const Cell& cell, unsigned threads) {
  auto stages = stagesOf(cell, threads);
  if (!stages) return stages;
  return splitCell(std::move(*stages), threads);
}

Result<SplitCell, std::vector<std::string>> splitCell(SplitCell whole, unsigned threads) {
  if (whole.cell.parameters.split == Split::Never) return whole;
  const Cell given = whole.cell;
  auto split = Splitter(std::move(whole)).split();
  if (split) return *std::move(split);
  return stagesOf(given, threads);
}

}  // namespace cobot_command::cell
