// What waits behind the motion that is under way, in order; and the PVT that is being recorded.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>
#include <vector>

#include "queue/pvt_recorder.h"
#include "queue/queue_entry.h"
#include "queue/tool_and_base.h"

namespace cobot_command::simulator {

class WaitingEntries {
 public:
  /// Behind all others; while a PVT is open, between its points.
  void push(QueueEntry entry);
  [[nodiscard]] PvtRecorder& pvt() { return pvt_; }

  [[nodiscard]] bool empty() const { return entries_.empty(); }
  [[nodiscard]] const QueueEntry& front() const { return entries_.front(); }
  QueueEntry take();
  /// The mark in front, if there is one.
  [[nodiscard]] const PvtMark* mark() const;

  /// The next motion, as far as it can be known what it will refer to.
  struct Ahead {
    const MotionRequest* motion =
        nullptr;  ///< none: at a change of the TCP, and for velocities, the arm stops
    ToolAndBase setting;
  };
  /// `setting`: of now. Nothing when no motion, and nothing else at which the arm stops, waits.
  [[nodiscard]] std::optional<Ahead> lookAhead(const ToolAndBase& setting) const;

  /// To the mode of its kind that waits. False: none does.
  bool giveVelocity(const Velocity& velocity, bool of_tcp);
  void removeVelocityModes();

  /// Gives all up, the open PVT too; what is left of them are tags.
  [[nodiscard]] std::vector<QueuedTag> giveUp();
  /// Gives up the open PVT alone.
  [[nodiscard]] std::vector<QueuedTag> giveUpPvt();

  [[nodiscard]] int motionCount() const;
  /// Entries of whatever kind; a whole PVT is one.
  [[nodiscard]] std::size_t size() const { return entries_.size() + pvt_.size(); }
  /// Of all PVT, the open one too.
  [[nodiscard]] std::size_t pvtPoints() const;

 private:
  std::deque<QueueEntry> entries_;
  PvtRecorder pvt_;
};

}  // namespace cobot_command::simulator
