// The node that supervises a cell. It receives the reports of the robots, publishes the state of the cell,
// and offers services and actions for operators.
//
// All its names are relative to the node's namespace, which is that of the cell. It must be spun by one
// thread, which waits for nothing: stops and cancels do not wait for the disk of the journal, because the
// decisions are made on the thread of the CellSupervisor.
#pragma once

#include <functional>
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
#include "cobot_command/cell/supervision/supervision.h"
#include "cobot_command/common/time.h"
#include "cobot_command/ros/shared/receipts.h"
#include "cobot_command/ros/shared/serving_thread.h"
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

  /// What the core has decided, for the thread of the node.
  struct Decided {
    cell::CellStatus status;
    cell::SupervisionCounts counts;
  };

  void servePeople(const ros::NodeHandle& node);

  // --- On the thread of the node.
  void takeReport(const ReportEvent& event);
  /// Stops and goals for the robot go to the node that sent its report.
  void hearFrom(const cell::CellStatus& status, const cobot_command::CellReport& report,
                const std::string& publisher);
  void takeState(const StateEvent& event);
  void takeDistances(const cobot_command::CellDistances& message);
  /// At once, and no run_cell begins until the core has decided it, too.
  void stopAll();
  void stop(const cell::StopOrder& order);
  [[nodiscard]] bool isMonitorLost(Instant now) const;
  /// What is to be reported about the monitor; empty: nothing.
  [[nodiscard]] std::string diagnosisOfMonitor(Instant now) const;
  /// Repeats stops if necessary, and lets the core look at the time.
  void tick(Instant now);
  /// Publishes the state, if it is new or due.
  void take(Decided decided);
  void tell(const Decided& decided, Instant now);
  /// Runs it on the thread of the node.
  void onNode(std::function<void()> what);

  // --- On the thread of the decisions.
  /// What follows from the time, too.
  [[nodiscard]] static Decided decided(cell::Supervision& core, Instant now);

  Receipts receipts_;
  NumberedQueue spinner_;
  ServingThread questions_;                              ///< of operators, that the core answers
  std::vector<std::unique_ptr<RobotContact>> contacts_;  ///< in the order of the robots
  std::unique_ptr<PeopleServices> people_;
  std::unique_ptr<ProgramRuns> runs_;
  std::unique_ptr<CellBuilder> builder_;
  std::unique_ptr<SupervisorDiagnostics> diagnostics_;
  std::string alarm_;                     ///< why the monitor has stopped all robots; empty: it has not
  std::optional<Instant> monitor_heard_;  ///< last message of the monitor
  std::optional<cell::CellStatus> told_;
  Instant told_at_;
  bool is_tick_asked_ = false;  ///< and not decided yet
  int stops_asked_ = 0;         ///< the same for those of stopAll()
  std::uint64_t number_ = 0;
  ros::Publisher state_;
  ros::Subscriber reports_;
  ros::Subscriber states_;
  ros::Subscriber distances_;
  ros::SteadyTimer timer_;
  std::unique_ptr<runtime::CellSupervisor> supervisor_;
};

}  // namespace cobot_command::ros_adapter
