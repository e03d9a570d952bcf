// The state of a cell on /diagnostics: its mode, its robots, its zones, and what it hears.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/steady_timer.h>

#include "cobot_command/cell/supervision/cell_state.h"
#include "cobot_command/cell/supervision/supervision.h"
#include "cobot_command/common/time.h"

namespace cobot_command::ros_adapter {

/// How long something took, the last thousand times.
class Latencies {
 public:
  void take(Duration latency);
  /// So long or less took 99 of 100; zero: there was none yet.
  [[nodiscard]] Duration p99() const;

 private:
  std::array<Duration, 1000> latest_{};
  std::size_t count_ = 0;
};

/// All that the tasks look at.
struct CellView {
  cell::CellStatus status;
  cell::SupervisionCounts counts;
  Duration wait_timeout{};  ///< a zone that is held for longer is worth a warning
  Duration p99{};           ///< from a report to the answer
  std::string other;        ///< the node of another supervisor that was heard; empty: none
};

void describeMode(diagnostic_updater::DiagnosticStatusWrapper& status, const CellView& view);
void describeRobots(diagnostic_updater::DiagnosticStatusWrapper& status, const CellView& view);
void describeZones(diagnostic_updater::DiagnosticStatusWrapper& status, const CellView& view);
void describeReports(diagnostic_updater::DiagnosticStatusWrapper& status, const CellView& view);

/// Publishes once in a second.
class SupervisorDiagnostics {
 public:
  SupervisorDiagnostics(const ros::NodeHandle& node, const ros::NodeHandle& self, Duration wait_timeout);

  void take(const cell::CellStatus& status, const cell::SupervisionCounts& counts);
  void heardOther(const std::string& node) { view_.other = node; }
  void answered(Duration latency) { latencies_.take(latency); }

 private:
  using Describe = void (*)(diagnostic_updater::DiagnosticStatusWrapper&, const CellView&);
  void add(const char* task, Describe describe);

  CellView view_;
  Latencies latencies_;
  diagnostic_updater::Updater updater_;
  ros::SteadyTimer timer_;
};

}  // namespace cobot_command::ros_adapter
