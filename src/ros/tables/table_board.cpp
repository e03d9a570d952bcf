#include "tables/table_board.h"

#include <utility>

namespace cobot_command::ros_adapter {
namespace {

template <class Entry, class Changes>
bool note(const tables::Table<Entry>& before, const tables::Table<Entry>& now, const ros::Time& stamp,
          Changes& changes) {
  bool any = false;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (before[i] == now[i]) continue;
    changes[i] = {stamp, true};
    any = true;
  }
  return any;
}

}  // namespace

bool TableBoard::take(const tables::DataTables& tables, const ros::Time& stamp) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (tables.revision() < tables_.revision()) return false;
  const tables::Entries& before = tables_.entries();
  const tables::Entries& now = tables.entries();
  bool any = note(before.tools, now.tools, stamp, changes_[0]);
  any = note(before.frames, now.frames, stamp, changes_[1]) || any;
  any = note(before.loads, now.loads, stamp, changes_[2]) || any;
  tables_ = tables;
  if (any) last_ = stamp;
  return any;
}

tables::DataTables TableBoard::tables() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return tables_;
}

ros::Time TableBoard::lastChange() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return last_;
}

ros::Time TableBoard::changeOf(tables::Kind kind, int index) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return of(kind, index).stamp;
}

bool TableBoard::hasChangedSinceRead(tables::Kind kind, int index) {
  const std::lock_guard<std::mutex> lock(mutex_);
  Change& change = changes_.at(static_cast<std::size_t>(kind)).at(static_cast<std::size_t>(index));
  return std::exchange(change.unread, false);
}

}  // namespace cobot_command::ros_adapter
