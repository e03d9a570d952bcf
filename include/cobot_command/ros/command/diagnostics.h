// The state of one robot on /diagnostics: Link, Listen node, Queue, Robot, Status stream, Exchange.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/steady_timer.h>

#include "cobot_command/command/command_status.h"
#include "cobot_command/command/group_state.h"
#include "cobot_command/common/time.h"
#include "cobot_command/link/robot_status.h"

namespace cobot_command::ros_adapter {

/// All data that the tasks use.
struct DiagnosticsView {
  command::CommandStatus command;
  command::GroupState group;
  link::RobotStatus robot;           ///< of the last status frame
  bool status_wanted = true;         ///< a status stream is requested
  double status_rate = 0;            ///< frames per second, over the last period
  std::optional<double> status_age;  ///< since the last frame [s]; nullopt: no frame yet
};

/// The text of each task. The level is STALE if the state cannot be known.
void describeLink(diagnostic_updater::DiagnosticStatusWrapper& status, const DiagnosticsView& view);
void describeListenNode(diagnostic_updater::DiagnosticStatusWrapper& status, const DiagnosticsView& view);
void describeQueue(diagnostic_updater::DiagnosticStatusWrapper& status, const DiagnosticsView& view);
void describeRobot(diagnostic_updater::DiagnosticStatusWrapper& status, const DiagnosticsView& view);
void describeStatusStream(diagnostic_updater::DiagnosticStatusWrapper& status, const DiagnosticsView& view);
void describeExchange(diagnostic_updater::DiagnosticStatusWrapper& status, const DiagnosticsView& view);

/// Publishes once per period, and within a tenth of a second after a change of data that people look at.
/// take() is called on the core's thread and costs a copy; everything else runs on ROS's spinner.
class Diagnostics {
 public:
  /// `status_wanted`: a status stream is requested, so that its absence causes a warning. `period`: [s].
  Diagnostics(const ros::NodeHandle& node, const ros::NodeHandle& self, double period, bool status_wanted);
  ~Diagnostics();
  Diagnostics(const Diagnostics&) = delete;
  Diagnostics& operator=(const Diagnostics&) = delete;

  void take(const command::CommandStatus& status);
  void take(const link::RobotStatus& status);
  void take(const command::GroupState& state);

 private:
  using Describe = void (*)(diagnostic_updater::DiagnosticStatusWrapper&, const DiagnosticsView&);

  void add(const char* task, Describe describe);
  void noteChange();
  void publish(bool due);

  std::mutex mutex_;  // guards the next six
  command::CommandStatus command_;
  command::GroupState group_;
  link::RobotStatus robot_;
  std::uint64_t frames_ = 0;
  std::optional<ros::SteadyTime> last_frame_;
  bool changed_ = true;  ///< since the last publication

  DiagnosticsView view_;  // what is being published
  ros::SteadyTime rate_since_;
  std::uint64_t rate_frames_ = 0;
  diagnostic_updater::Updater updater_;
  ros::SteadyTimer periodic_;
  ros::SteadyTimer soon_;  ///< once, after a change
};

}  // namespace cobot_command::ros_adapter
