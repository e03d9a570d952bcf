// Whose turn it is on each zone, by a schedule of one cycle of all robots, again and again (cell.md, M37).
//
// It only keeps robots back: what the supervisor refuses stays refused. It counts from when all are at home;
// where somebody fails it is suspended until they are there again.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "cobot_command/cell/supervision/supervision.h"

namespace cobot_command::cell {

/// That such an event makes somebody's; none, when it books nothing.
[[nodiscard]] std::vector<ZoneIndex> zonesBookedBy(const CellEvent& event);

class ZoneTurns {
 public:
  /// Suspended at first.
  explicit ZoneTurns(ZoneOrders orders) : orders_(std::move(orders)), next_(orders_.size(), 0) {}

  [[nodiscard]] bool isUsed() const { return !orders_.empty(); }
  /// Who has to have booked one of these zones before that robot; nobody: it is its turn on all of them.
  [[nodiscard]] std::optional<RobotIndex> before(RobotIndex robot, const std::vector<ZoneIndex>& zones) const;
  /// Those in front of it, if there were any, were passed over.
  void booked(RobotIndex robot, const std::vector<ZoneIndex>& zones);
  /// Its booking, the last one on these zones, counts as never made.
  void takenBack(RobotIndex robot, const std::vector<ZoneIndex>& zones);
  void beginAnew();
  void suspend() { is_suspended_ = true; }

 private:
  ZoneOrders orders_;
  std::vector<std::size_t> next_;  ///< by zone: into its order
  bool is_suspended_ = true;
};

}  // namespace cobot_command::cell
