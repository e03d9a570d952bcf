// The cuts of one path.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "splitting/stages.h"

namespace cobot_command::cell {

class PathCuts {
 public:
  PathCuts(const SplitCell& stages, RobotIndex robot, std::size_t path);

  /// Cuts each step that books, once. False: there is nothing to be gained (any more).
  [[nodiscard]] bool cut(SplitCell& stages);
  /// Whether each cut still does what it was made for, with the zones as they are now.
  [[nodiscard]] bool pay(const SplitCell& stages) const;
  /// Back to the steps as they were given; cut() will keep a piece farther away from the zones, or leave them
  /// whole when that was tried often enough, or `for_good`.
  void revert(SplitCell& stages, bool for_good);
  /// What was done, and the names of the halves. Precondition: pay().
  void report(SplitCell& stages) const;

 private:
  /// What a step is of one as it was given.
  struct Part {
    std::size_t step = 0;
    double from = 0.0;  ///< its share of the way
    double to = 1.0;
    /// How it was cut from what is in front of it; nothing where it begins its step.
    std::optional<CutMeasure> cut;
    double deviation = 0.0;  ///< from the step as it was given [m]
    double turn = 0.0;       ///< [rad]
  };
  /// A zone that is booked with a frame, and the first piece that touches it.
  struct Entry {
    ZoneIndex zone = 0;
    std::size_t piece = 0;
  };

  [[nodiscard]] std::vector<Entry> entriesOf(const SplitCell& stages, std::size_t frame) const;
  [[nodiscard]] bool cutFrame(SplitCell& stages, std::size_t frame, const Entry& entry);
  [[nodiscard]] std::optional<StepCut> tryCut(const SplitCell& stages, std::size_t frame,
                                              Duration time) const;
  void note(std::size_t step, const StepCut& cut);
  [[nodiscard]] std::vector<ZoneIndex> bookedWith(const SplitCell& stages, std::size_t step) const;
  [[nodiscard]] Duration savedBy(const SplitCell& stages, std::size_t step) const;

  RobotIndex robot_;
  std::size_t path_;
  std::vector<Step> given_;
  PathStages given_stages_;
  std::vector<Part> parts_;   ///< by step as it is now
  std::size_t back_off_ = 0;  ///< so many pieces in front of the zone
  bool is_closed_ = false;
};

}  // namespace cobot_command::cell
