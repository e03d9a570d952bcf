// The parts of the simulated controller, wired, and its time.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "operator_desk.h"
#include "queue/motion_queue.h"
#include "robot/io_board.h"
#include "robot/project_data.h"
#include "robot/sensors.h"
#include "script_port/listen_node.h"
#include "status_port/status_server.h"
#include "wire/outbox.h"
#include "wire/outgoing.h"

#include "cobot_command/simulator/simulated_controller.h"

namespace cobot_command::simulator {

class SimulatedController::Impl {
 public:
  Impl(const arm::ArmModel& arm, Settings settings, Instant now);

  void advance(Instant now);
  [[nodiscard]] Instant nextEvent() const;
  void clientConnected(Port port, ClientId client, Instant now, std::string_view address);
  void clientDisconnected(Port port, ClientId client, Instant now);
  void received(Port port, ClientId client, std::string_view bytes, Instant now);
  OperatorReply operate(const OperatorAction& action, Instant now);

  std::vector<Output> takeOutputs() { return outbox_.take(); }
  [[nodiscard]] RobotState state() const;
  /// As its sensors tell it.
  [[nodiscard]] RobotState measured() const { return simulator::measured(state(), arm_, settings_); }
  [[nodiscard]] const arm::ArmModel& arm() const { return arm_; }

 private:
  void setTime(Instant now);
  void settle();
  bool runQueue();
  void streamStatus();
  void receivedOnStatus(ClientId client, std::string_view bytes);  // status_writes.cpp
  [[nodiscard]] ItemSource source(const RobotState& robot) const {
    return {arm_, settings_, robot, faults_.hide_items, project_};
  }
  void on(const TagSettled& settled) { node_.on(settled); }
  void on(const TagDropped& dropped) { node_.on(dropped); }
  void on(const script::WriteOutput& write) { io_.write(write); }
  void on(const script::WriteAnalogOutput& write) { io_.write(write); }
  void on(const SetCameraLight& write) { io_.write(write); }
  void on(const MotionStarted& started);
  void on(const MotionFailed& failed);
  void on(const PressButton& press);
  void on(const SetProjectName& project);
  void on(const SetAutoRemote& remote);
  void on(const SetVariable& variable);
  void on(const SetProjectSpeed& speed);

  arm::ArmModel arm_;
  Settings settings_;
  Instant now_;
  FaultSwitches faults_;
  Outbox outbox_;
  Outgoing outgoing_;
  MotionQueue queue_;
  IoBoard io_;
  ProjectData project_;
  ListenNode node_;
  StatusServer status_;
  OperatorDesk operator_;
  bool stops_project_ = false;
  bool auto_remote_ = false;
  Instant started_;
  Instant error_since_{};
};

}  // namespace cobot_command::simulator
