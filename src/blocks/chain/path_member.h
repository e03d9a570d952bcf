// One goal of a chain, and one piece that is at the controller. Points are counted from the first one of the
// chain on.
#pragma once

#include <cstddef>
#include <deque>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "chain/loaded_path.h"

#include "cobot_command/blocks/shared/command.h"
#include "cobot_command/blocks/shared/goal_values.h"
#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

struct PathMember {
  GoalId goal = 0;
  std::shared_ptr<const LoadedPath> loaded;
  std::size_t first = 0;         ///< of its points
  bool passed_gate = false;      ///< its points may be loaded, whatever the tracking objects do
  PathReport report;             ///< as planned, and as it went until now
  std::optional<Instant> began;  ///< its first point
  PathPlace told;                ///< last
  std::optional<Instant> told_at;

  [[nodiscard]] std::size_t count() const { return loaded->move_ids.size(); }
  [[nodiscard]] std::size_t behind() const { return first + count(); }
  void pointDone(std::size_t point, Instant now);
  /// Of its points from that one on: they are planned anew.
  void forgetLostBlends(std::size_t point);
  /// It is to be told: it is another one, or was told a while ago. Then it counts as told.
  [[nodiscard]] bool isNews(const PathPlace& place, Instant now);
};

struct SentPiece {
  CommandKey key = 0;
  LoadedPiecePtr piece;
  std::size_t first = 0;  ///< of its points
  [[nodiscard]] std::size_t behind() const { return first + piece->plan.points().size(); }
  /// A tag tells that this point of it is done.
  [[nodiscard]] bool isMarked(std::size_t point) const;
};

/// What is at the controller, in its order, and what was taken back from there.
class SentPieces {
 public:
  void add(SentPiece piece) { pieces_.push_back(std::move(piece)); }
  [[nodiscard]] const std::deque<SentPiece>& all() const { return pieces_; }
  [[nodiscard]] bool empty() const { return pieces_.empty(); }
  [[nodiscard]] std::size_t size() const { return pieces_.size(); }
  /// Precondition: it is not empty.
  [[nodiscard]] const SentPiece& front() const { return pieces_.front(); }
  [[nodiscard]] bool isFirst(CommandKey key) const { return !empty() && front().key == key; }
  [[nodiscard]] bool has(CommandKey key) const;
  /// That one has ended, however. Precondition: it is there.
  SentPiece take(CommandKey key);
  /// It was stopped, and is to be planned anew. Precondition: it is there.
  void takeBack(CommandKey key);
  [[nodiscard]] const std::vector<SentPiece>& takenBack() const { return taken_back_; }
  /// In the order of their points.
  [[nodiscard]] std::vector<SentPiece> forgetTakenBack();

 private:
  std::deque<SentPiece> pieces_;
  std::vector<SentPiece> taken_back_;
};

}  // namespace cobot_command::blocks
