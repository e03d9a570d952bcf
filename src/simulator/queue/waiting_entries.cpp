#include "queue/waiting_entries.h"

#include <algorithm>
#include <utility>

namespace cobot_command::simulator {

namespace {

template <class Entries>
std::vector<QueuedTag> tagsIn(const Entries& entries) {
  std::vector<QueuedTag> tags;
  for (const QueueEntry& entry : entries) {
    if (const auto* tag = std::get_if<QueuedTag>(&entry)) tags.push_back(*tag);
  }
  return tags;
}

std::size_t pointsIn(const QueueEntry& entry) {
  const auto* request = std::get_if<MotionRequest>(&entry);
  const auto* pvt = request == nullptr ? nullptr : std::get_if<planning::PvtBlock>(request);
  return pvt == nullptr ? 0 : pvt->points.size();
}

bool movesOrChangesTcp(const QueueEntry& entry) {
  return moves(entry) || std::holds_alternative<TcpChange>(entry);
}

}  // namespace

void WaitingEntries::push(QueueEntry entry) {
  if (pvt_.isOpen()) return pvt_.add(std::move(entry));
  entries_.push_back(std::move(entry));
}

QueueEntry WaitingEntries::take() {
  QueueEntry entry = std::move(entries_.front());
  entries_.pop_front();
  return entry;
}

const PvtMark* WaitingEntries::mark() const {
  return empty() ? nullptr : std::get_if<PvtMark>(&front());
}

std::optional<WaitingEntries::Ahead> WaitingEntries::lookAhead(const ToolAndBase& setting) const {
  const auto behind = std::find_if(entries_.begin(), entries_.end(), movesOrChangesTcp);
  if (behind == entries_.end()) return std::nullopt;
  Ahead ahead{std::get_if<MotionRequest>(&*behind), setting};
  for (auto entry = entries_.begin(); entry != behind; ++entry) {
    if (const auto* change = std::get_if<BaseChange>(&*entry)) ahead.setting.apply(*change);
    if (const auto* change = std::get_if<LoadChange>(&*entry)) ahead.setting.apply(*change);
  }
  return ahead;
}

bool WaitingEntries::giveVelocity(const Velocity& velocity, bool of_tcp) {
  for (QueueEntry& entry : entries_) {
    auto* mode = std::get_if<VelocityMode>(&entry);
    if (mode == nullptr || mode->of_tcp != of_tcp) continue;
    mode->first = velocity;
    return true;
  }
  return false;
}

void WaitingEntries::removeVelocityModes() {
  const auto waits = [](const QueueEntry& entry) { return std::holds_alternative<VelocityMode>(entry); };
  entries_.erase(std::remove_if(entries_.begin(), entries_.end(), waits), entries_.end());
}

std::vector<QueuedTag> WaitingEntries::giveUp() {
  std::vector<QueuedTag> tags = tagsIn(std::exchange(entries_, {}));
  const std::vector<QueuedTag> between = giveUpPvt();
  tags.insert(tags.end(), between.begin(), between.end());
  return tags;
}

std::vector<QueuedTag> WaitingEntries::giveUpPvt() {
  return tagsIn(pvt_.giveUp());
}

int WaitingEntries::motionCount() const {
  return static_cast<int>(std::count_if(entries_.begin(), entries_.end(), [](const QueueEntry& entry) {
    return std::holds_alternative<MotionRequest>(entry);
  }));
}

std::size_t WaitingEntries::pvtPoints() const {
  std::size_t all = pvt_.points();
  for (const QueueEntry& entry : entries_) all += pointsIn(entry);
  return all;
}

}  // namespace cobot_command::simulator
