#include "cobot_command/ros/cell_watch/monitor_node.h"

#include <optional>
#include <utility>

#include "cell_watch/base_frames.h"
#include "cell_watch/believed_places.h"
#include "cell_watch/distance_messages.h"
#include "cell_watch/pictures/cell_pictures.h"
#include "cell_watch/watch.h"
#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/steady_timer.h>

#include "cobot_command/cell/program/canonical.h"
#include "cobot_command/runtime/cell/cell_files.h"
#include "cobot_command/runtime/cell/cell_watch.h"

namespace cobot_command::ros_adapter {
namespace {

using Faults = std::vector<std::string>;

/// So often pictures, and what diagnostics say of the alarm, are looked at [s].
constexpr double kPicturePeriod = 0.1;

/// nullptr: there is none.
Result<std::shared_ptr<const cell::Artifact>, Faults> artifactOf(const std::string& file,
                                                                 const cell::Cell& cell) {
  if (file.empty()) return std::shared_ptr<const cell::Artifact>();
  auto artifact = runtime::readArtifact(file);
  if (!artifact) return refuse(artifact.error());
  if (artifact->hash != cell::hashOf(cell)) {
    return refuse(
        Faults{"~artifact: " + file +
               " was made from another cell than ~cell_file; rebuild it: tm_cell build CELL -o FILE"});
  }
  return std::make_shared<const cell::Artifact>(std::move(*artifact));
}

}  // namespace

class MonitorNode::Impl {
 public:
  struct Made {
    cell::Cell cell;
    cell::Monitor monitor;
    MoverNamespaces namespaces;
    std::optional<BelievedPlaces> carried;
    std::optional<CellScene> scene;
  };
  [[nodiscard]] static Result<Made, Faults> make(const MonitorParameters& parameters);

  Impl(const ros::NodeHandle& node, const ros::NodeHandle& self, const MonitorParameters& parameters,
       Made made)
      : mode_(parameters.mode),
        period_(parameters.diagnostic_period),
        frames_(made.cell),
        pictures_(node, made.cell, std::move(made.scene)),
        watch_(node, std::move(made.monitor), std::move(made.namespaces), std::move(made.carried),
               [this, is_told = parameters.publish_frames](std::size_t robot, const std::string& prefix) {
                 if (is_told) frames_.tell(robot, prefix);
               }),
        // The updater looks for a period by itself, and throws at one that is no number: it is given a
        // namespace where there is none.
        updater_(node, ros::NodeHandle(self, "diagnostic_updater")) {
    updater_.setHardwareID(made.cell.name);
    updater_.add("Monitor", [this](diagnostic_updater::DiagnosticStatusWrapper& status) {
      describeMonitor(status, view_, mode_);
    });
    watch_.start();
    timer_ = node.createSteadyTimer(ros::WallDuration(kPicturePeriod),
                                    [this](const ros::SteadyTimerEvent&) { look(); });
  }

  void stop() {
    timer_.stop();
    watch_.stop();
  }

 private:
  void look() {
    const bool was_latched = view_.status.latched;
    view_ = watch_.view();
    pictures_.show(view_);
    const ros::SteadyTime now = ros::SteadyTime::now();
    if (view_.status.latched == was_latched && now - told_ < ros::WallDuration(period_)) return;
    told_ = now;
    updater_.force_update();
  }

  cell::MonitorSettings::Mode mode_;
  double period_;
  BaseFrames frames_;
  CellPictures pictures_;
  Watch watch_;  // behind the frames, which its thread uses
  WatchView view_;
  diagnostic_updater::Updater updater_;
  ros::SteadyTime told_;
  ros::SteadyTimer timer_;
};

Result<MonitorNode::Impl::Made, Faults> MonitorNode::Impl::make(const MonitorParameters& parameters) {
  auto cell = runtime::readCellFile(parameters.cell_file);
  if (!cell) return refuse(cell.error());
  auto monitor = runtime::monitorOf(*cell, parameters.mode, parameters.stop_distance);
  if (!monitor) return refuse(Faults{monitor.error()});
  auto namespaces = MoverNamespaces::of(*cell);
  if (!namespaces) return refuse(Faults{namespaces.error()});
  auto artifact = artifactOf(parameters.artifact, *cell);
  if (!artifact) return refuse(artifact.error());
  std::optional<BelievedPlaces> carried;
  std::optional<CellScene> scene;
  if (*artifact) {
    auto parts = BelievedPlaces::of(*artifact);
    if (!parts) return refuse(parts.error());
    carried = std::move(*parts);
    scene = sceneOf(**artifact);
  }
  return Made{std::move(*cell), std::move(*monitor), std::move(*namespaces), std::move(carried),
              std::move(scene)};
}

Result<std::unique_ptr<MonitorNode>, Faults> MonitorNode::of(const ros::NodeHandle& node,
                                                             const ros::NodeHandle& self,
                                                             const MonitorParameters& parameters) {
  auto made = Impl::make(parameters);
  if (!made) return refuse(made.error());
  return std::unique_ptr<MonitorNode>(
      new MonitorNode(std::make_unique<Impl>(node, self, parameters, std::move(*made))));
}

MonitorNode::MonitorNode(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}

MonitorNode::~MonitorNode() {
  stop();
}

void MonitorNode::stop() {
  impl_->stop();
}

}  // namespace cobot_command::ros_adapter
