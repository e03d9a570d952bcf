// The tables as the services and the topic tell them, and when each entry changed. Thread-safe.
#pragma once

#include <array>
#include <mutex>
#include <utility>

#include <ros/time.h>

#include "cobot_command/tables/data_tables.h"

namespace cobot_command::ros_adapter {

class TableBoard {
 public:
  explicit TableBoard(tables::DataTables tables) : tables_(std::move(tables)) {}

  /// True when an entry is another than before; those that are older than what was taken are left alone.
  bool take(const tables::DataTables& tables, const ros::Time& stamp);

  [[nodiscard]] tables::DataTables tables() const;
  /// Zero: none.
  [[nodiscard]] ros::Time lastChange() const;
  /// Preconditions: isIndex().
  [[nodiscard]] ros::Time changeOf(tables::Kind kind, int index) const;
  /// Whether it has changed since this was asked before.
  [[nodiscard]] bool hasChangedSinceRead(tables::Kind kind, int index);

 private:
  struct Change {
    ros::Time stamp;
    bool unread = false;
  };
  using Changes = std::array<Change, tables::kEntryCount>;
  [[nodiscard]] const Change& of(tables::Kind kind, int index) const {
    return changes_.at(static_cast<std::size_t>(kind)).at(static_cast<std::size_t>(index));
  }

  mutable std::mutex mutex_;
  tables::DataTables tables_;
  ros::Time last_;
  std::array<Changes, 3> changes_;  ///< by their kinds
};

}  // namespace cobot_command::ros_adapter
