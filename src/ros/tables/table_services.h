// The services that read and write the tables of tools, frames and loads, and the topic that tells them.
//
// The services wait for a disk, on a thread that serves nothing else; take() may be called from the core's.
#pragma once

#include <mutex>
#include <vector>

#include "tables/table_board.h"
#include "tables/table_writer.h"
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/service_server.h>

#include "cobot_command/ros/shared/own_handle.h"

namespace cobot_command::ros_adapter {

class TableServices {
 public:
  TableServices(const ros::NodeHandle& node, const tables::DataTables& tables, TableWriter::Core core,
                TableWriter::Keep keep);

  /// They are so now; told when that is new.
  void take(const tables::DataTables& tables);
  /// Whoever waits for a write is answered, and the core is not asked any more.
  void close() { writer_.close(); }
  /// As they were told last. From any thread.
  [[nodiscard]] tables::DataTables tables() const { return board_.tables(); }

 private:
  template <class Of>
  void serve(OwnHandle node);
  template <class Of>
  bool read(typename Of::Read::Request& request, typename Of::Read::Response& response);
  template <class Of>
  bool write(typename Of::Write::Request& request, typename Of::Write::Response& response);
  [[nodiscard]] command::TableAnswer written(const command::TableWrite& write);

  TableBoard board_;
  TableWriter writer_;
  std::mutex telling_;
  ros::Publisher topic_;
  std::vector<ros::ServiceServer> services_;
};

}  // namespace cobot_command::ros_adapter
