// The node that supervises a cell. It receives the reports of the robots, publishes the state of the cell,
// and offers services and actions for operators.
//
// All its names are relative to the node's namespace, which is that of the cell. It must be spun by one
// thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/steady_timer.h>
#include <ros/subscriber.h>

#include "cobot_command/CellDistances.h"
#include "cobot_command/CellReport.h"
#include "cobot_command/CellState.h"
#include "cobot_command/cell/supervision/cell_state.h"
#include "cobot_command/common/time.h"
#include "cobot_command/ros/shared/receipts.h"
#include "cobot_command/runtime/cell/cell_supervisor.h"

namespace cobot_command::ros_adapter {

class CellBuilder;
class PeopleServices;
class ProgramRuns;
class RobotContact;
class SupervisorDiagnostics;

class SupervisorNode {
 public:
  /// `self`: the node's private namespace.
  SupervisorNode(const ros::NodeHandle& node, const ros::NodeHandle& self,
                 std::unique_ptr<runtime::CellSupervisor> supervisor);
  ~SupervisorNode();
  SupervisorNode(const SupervisorNode&) = delete;
  SupervisorNode& operator=(const SupervisorNode&) = delete;

 private:
  using ReportEvent = ros::MessageEvent<const cobot_command::CellReport>;
  using StateEvent = ros::MessageEvent<const cobot_command::CellState>;

  void takeReport(const ReportEvent& event);
  void takeState(const StateEvent& event);
  void takeDistances(const cobot_command::CellDistances& message);
  [[nodiscard]] bool isMonitorLost(Instant now) const;
  /// What is to be reported about the monitor; empty: nothing.
  [[nodiscard]] std::string diagnosisOfMonitor(Instant now) const;
  /// Makes the due decisions, stops robots if necessary, and publishes the state, if it is new or due.
  void settle(Instant now);
  void tell(const cell::CellStatus& status, Instant now);

  Receipts receipts_;
  NumberedQueue spinner_;
  std::unique_ptr<runtime::CellSupervisor> supervisor_;
  std::vector<std::unique_ptr<RobotContact>> contacts_;  ///< in the order of the robots
  std::unique_ptr<PeopleServices> people_;
  std::unique_ptr<ProgramRuns> runs_;
  std::unique_ptr<CellBuilder> builder_;
  std::unique_ptr<SupervisorDiagnostics> diagnostics_;
  std::string alarm_;                     ///< why the monitor has stopped all robots; empty: it has not
  std::optional<Instant> monitor_heard_;  ///< last message of the monitor
  std::optional<cell::CellStatus> told_;
  Instant told_at_;
  std::uint64_t number_ = 0;
  ros::Publisher state_;
  ros::Subscriber reports_;
  ros::Subscriber states_;
  ros::Subscriber distances_;
  ros::SteadyTimer timer_;
};

}  // namespace cobot_command::ros_adapter
