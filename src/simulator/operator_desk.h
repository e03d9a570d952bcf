// What people do at the simulated controller, with pendant, stick and the cell around it; and what stays as
// they have left it.
#pragma once

#include <functional>

#include "pendant.h"
#include "queue/motion_queue.h"
#include "robot/io_board.h"
#include "robot/project_data.h"
#include "script_port/listen_node.h"
#include "status_port/item_write.h"
#include "status_port/status_server.h"
#include "wire/outbox.h"

#include "cobot_command/simulator/fault_switches.h"
#include "cobot_command/simulator/operator_action.h"
#include "cobot_command/simulator/operator_reply.h"
#include "cobot_command/simulator/robot_state.h"
#include "cobot_command/simulator/settings.h"

namespace cobot_command::simulator {

class OperatorDesk {
 public:
  /// What it acts on.
  struct Parts {
    Settings& settings;
    FaultSwitches& faults;
    Outbox& outbox;
    MotionQueue& queue;
    IoBoard& io;
    ProjectData& project;
    ListenNode& node;
    StatusServer& status;
  };
  /// `settle`: has everything happen that follows at this instant.
  OperatorDesk(const Parts& parts, std::function<void()> settle)
      : parts_(parts), settle_(std::move(settle)) {}

  /// What follows of it is to be settled by the caller.
  OperatorReply operate(const OperatorAction& action, Instant now);
  /// A button of the stick that cannot do what the operator does there does nothing.
  OperatorReply press(Button button, Instant now);

  [[nodiscard]] bool emergencyStop() const { return emergency_stop_; }
  [[nodiscard]] bool safeguard() const { return safeguard_; }
  [[nodiscard]] OperatingMode mode() const { return mode_; }
  /// When it was last run.
  [[nodiscard]] Instant projectStarted() const { return project_started_; }

 private:
  OperatorReply act(const RunProject& action);
  OperatorReply act(const StopProject& action);
  OperatorReply act(const PauseProject& action);
  OperatorReply act(const ResumeProject& action);
  OperatorReply act(const LeaveListenNode& action);
  OperatorReply act(const EnterListenNode& action);
  OperatorReply act(const SetEmergencyStop& action);
  OperatorReply act(const SetSafeguard& action);
  OperatorReply act(const SetOperatingMode& action);
  OperatorReply act(const SetProjectSpeed& action);
  OperatorReply act(const RaiseError& action);
  OperatorReply act(const ClearError& action);
  OperatorReply act(const SetInput& action);
  OperatorReply act(const SetTcp& action) { return teach(parts_.project, action); }
  OperatorReply act(const SetBase& action) { return teach(parts_.project, action); }
  OperatorReply act(const SetLoad& action) { return teach(parts_.project, action); }
  OperatorReply act(const SetFault& order);
  OperatorReply act(const ClearFaults& action);
  OperatorReply act(const DropConnections& action);

  Parts parts_;
  std::function<void()> settle_;
  Instant now_{};
  bool emergency_stop_ = false;
  bool safeguard_ = false;
  OperatingMode mode_ = OperatingMode::Automatic;
  Instant project_started_{};
};

}  // namespace cobot_command::simulator
