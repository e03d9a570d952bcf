// Writes entries of the tables one after the other, each first into the file, then into the core: beside
// ROS's spinner and the core, as a disk may take its time, or hang.
//
// What hangs is left behind at the end. Thread-safe.
#pragma once

#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "cobot_command/command/table_write.h"

namespace cobot_command::ros_adapter {

class TableWriter {
 public:
  /// Asked of the core; nothing: it is closed.
  using Ask = std::function<std::optional<std::future<command::TableAnswer>>(const command::TableWrite&)>;
  struct Core {
    Ask tried;    ///< see CommandCore::tryTable()
    Ask written;  ///< see CommandCore::writeTable()
  };
  /// Keeps them for the next start; or says why not.
  using Keep = std::function<std::optional<std::string>(const tables::DataTables& tables)>;

  /// `tables`: as they are kept now.
  TableWriter(tables::DataTables tables, Core core, Keep keep);
  ~TableWriter();  ///< close()
  TableWriter(const TableWriter&) = delete;
  TableWriter& operator=(const TableWriter&) = delete;

  /// Nothing changes when the answer is a refusal.
  [[nodiscard]] std::future<command::TableAnswer> write(command::TableWrite write);
  /// `core` is not asked any more; whoever waits for an answer has one.
  void close();
  /// The core has changed them by itself: kept behind all that was to be written before.
  void keep(tables::DataTables tables);

 private:
  class Desk;
  std::shared_ptr<Desk> desk_;
};

}  // namespace cobot_command::ros_adapter
