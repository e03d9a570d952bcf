// Runs a path with the core alone, without ROS: plans it, and prints each point with its times and the text
// that is sent for it. Then drives it on a simulated controller in this program, or on the controller at an
// address:
//
//   load_path [HOST [SCRIPT_PORT STATUS_PORT]]
//
// The robot moves to joints 0 0 90 0 90 0, and from there around a box of 100 x 100 mm and back.
// Ctrl-C, SIGTERM and a closed terminal stop it. Exit status: 0 if the path is done, 1 with the reason if
// not. The action, in Python: load_path.py.

#include "cobot_command/blocks/load_path.h"

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <future>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/path/path_pieces.h"
#include "cobot_command/path/path_planner.h"
#include "cobot_command/runtime/command/command_runtime.h"
#include "cobot_command/runtime/simulation/simulator_runtime.h"

namespace {

using namespace cobot_command;
using path::PathPoint;

constexpr std::chrono::seconds kTimeout(60);
constexpr std::chrono::milliseconds kGlance(20);
constexpr blocks::GoalId kConnect = 1;
constexpr blocks::GoalId kHome = 2;
constexpr blocks::GoalId kPath = 3;

volatile std::sig_atomic_t interrupted = 0;

void interrupt(int /*signal*/) {
  interrupted = 1;
}

arm::ArmModel model() {
  return *arm::ArmModel::named("tm5-900");
}

// --- The path.

/// The same point, blended with this tolerance [% of a PTP, else mm].
PathPoint blended(PathPoint point, double tolerance) {
  point.termination_type = static_cast<int>(path::Termination::Blend);
  point.command_tolerance = tolerance;
  return point;
}

PathPoint home() {
  PathPoint point;
  point.joints = {0, 0, 90, 0, 90, 0};
  point.speed = 60;
  point.acceleration = point.deceleration = 180;
  return point;
}

/// Of the flange, in the robot base.
PathPoint straight(path::Interpolation way, const arm::ControllerPose& pose) {
  PathPoint point;
  point.interpolation = static_cast<int>(way);
  point.target_type = static_cast<int>(path::TargetType::Cartesian);
  point.pose = pose;
  point.profile_type = static_cast<int>(path::ProfileType::ModSine);
  point.acceleration_jerk = point.deceleration_jerk = 100;
  point.speed = 150;
  point.acceleration = point.deceleration = 600;
  point.orientation_speed = 60;
  point.orientation_acceleration = point.orientation_deceleration = 240;
  return point;
}

blocks::LoadPathGoal goalOf(const std::vector<PathPoint>& points) {
  blocks::LoadPathGoal goal;
  goal.path = points;
  goal.number_of_moves = static_cast<int>(points.size());
  return goal;
}

blocks::LoadPathGoal aroundTheBox() {
  using path::Interpolation;
  return goalOf({blended(straight(Interpolation::Linear, {450, -122.3, 461.05, 180, 0, 90}), 20),
                 blended(straight(Interpolation::Wrist, {450, -122.3, 361.05, 180, 0, 135}), 20),
                 blended(straight(Interpolation::Wrist, {550, -122.3, 361.05, 180, 0, 90}), 20), home()});
}

/// Prints the plan. The core uses the same planner.
void showPlan() {
  const path::PathScene scene{model(), arm::toJointVector({0, 0, 90, 0, 90, 0})};
  const blocks::LoadPathGoal goal = aroundTheBox();
  path::PathPlanner planner(scene);
  if (const auto refusal = planner.append({goal.path, goal.start_index, goal.number_of_moves})) {
    throw std::runtime_error("point " + std::to_string(refusal->index) + ": " + refusal->found);
  }
  std::puts("Planned:");
  for (const path::PlannedPoint& point : planner.plan().points()) {
    std::printf("  point %d from %.3f s to %.3f s, the last %.3f s together with the next one\n", point.index,
                toSeconds(point.start), toSeconds(point.end()), toSeconds(point.overlap));
  }
  const auto pieces = path::piecesOf(planner.plan(), scene);
  if (!pieces) throw std::runtime_error(pieces.error().found);
  for (const path::PathPiece& piece : *pieces) {
    std::printf("  sent as a PVT of %zu points\n", piece.block.points.size());
  }
}

// --- The robot.

struct Controller {
  std::string host = "127.0.0.1";
  runtime::SimulatorPorts ports{5890, 5891};
  std::unique_ptr<runtime::SimulatorRuntime> simulated;  ///< absent: the controller is elsewhere
};

Controller simulatedController() {
  Controller controller;
  runtime::SimulatorOptions options;
  options.script_port = options.status_port = 0;  // any free ones
  controller.simulated = std::make_unique<runtime::SimulatorRuntime>(model(), simulator::Settings(), options);
  const auto ports = controller.simulated->start();
  if (!ports) throw std::runtime_error(ports.error().message);
  controller.ports = *ports;
  return controller;
}

/// The core of one robot. Its events arrive on a separate thread; this class waits for them.
class Robot {
 public:
  explicit Robot(const Controller& controller)
      : runtime_(model(), settingsFor(controller),
                 [this](const command::Action& action, Instant /*now*/) { take(action); }) {}

  void connect(const Controller& controller) {
    blocks::ConnectGoal goal;
    goal.host = controller.host;
    goal.port = controller.ports.script;
    submit(kConnect, goal);
    std::future<void> ready = ready_.get_future();
    wait(ready, "link");
  }

  /// Returns its outcome when it is done; throws if it fails.
  blocks::Outcome run(blocks::GoalId id, const blocks::LoadPathGoal& goal) {
    std::promise<blocks::Outcome>& promise = id == kHome ? home_ended_ : path_ended_;
    std::future<blocks::Outcome> ended = promise.get_future();
    submit(id, goal);
    wait(ended, "end of the path");
    blocks::Outcome outcome = ended.get();
    if (outcome.ending == blocks::Ending::Done) return outcome;
    throw std::runtime_error(outcome.error_description + " -> " + outcome.remedy);
  }

 private:
  static link::LinkSettings settingsFor(const Controller& controller) {
    link::LinkSettings settings;
    settings.status_port = controller.ports.status;
    return settings;
  }

  void submit(blocks::GoalId id, blocks::Goal goal) {
    if (!runtime_.submit(id, std::move(goal))) throw std::runtime_error("the core has ended");
  }

  template <class Value>
  static void wait(std::future<Value>& future, const char* what) {
    const auto deadline = std::chrono::steady_clock::now() + kTimeout;
    while (future.wait_for(kGlance) != std::future_status::ready) {
      if (interrupted != 0) throw std::runtime_error("interrupted");
      if (std::chrono::steady_clock::now() > deadline) {
        throw std::runtime_error(std::string("no ") + what + " in a minute");
      }
    }
  }

  // --- On the thread of the core.
  void take(const command::Action& action) {
    if (const auto* changed = std::get_if<command::StatusChanged>(&action)) takeStatus(changed->status);
    if (const auto* told = std::get_if<command::GoalProgressed>(&action)) takeProgress(*told);
    if (const auto* ended = std::get_if<command::GoalEnded>(&action)) takeEnd(*ended);
  }

  void takeStatus(const command::CommandStatus& status) {
    const bool is_ready = status.link == command::CommandStatus::LinkState::Ready && status.status_stream;
    if (is_ready && !std::exchange(is_ready_, true)) ready_.set_value();
  }

  void takeProgress(const command::GoalProgressed& told) {
    const auto* place = told.progress.detail.find<blocks::PathPlace>();
    if (told.goal != kPath || place == nullptr || !place->active) return;
    if (std::exchange(active_, place->active_path_point) == place->active_path_point) return;
    std::printf("  point %d is active, %d done, %d queued, %d pending\n", place->active_path_point,
                place->done_path_points, place->queued_path_points, place->pending_path_points);
  }

  void takeEnd(const command::GoalEnded& ended) {
    if (ended.goal == kHome) home_ended_.set_value(ended.outcome);
    if (ended.goal == kPath) path_ended_.set_value(ended.outcome);
  }

  std::promise<void> ready_;
  std::promise<blocks::Outcome> home_ended_;
  std::promise<blocks::Outcome> path_ended_;
  bool is_ready_ = false;
  int active_ = -1;
  runtime::CommandRuntime runtime_;  // ends first, with a stop for a robot that moves
};

void drive(const Controller& controller) {
  Robot robot(controller);
  robot.connect(controller);
  robot.run(kHome, goalOf({home()}));
  std::puts("Driven:");
  const blocks::Outcome outcome = robot.run(kPath, aroundTheBox());
  const auto& report = outcome.detail.as<blocks::PathReport>();
  for (std::size_t i = 0; i < report.points.size(); ++i) {
    std::printf("  point %zu was done after %.3f s\n", i, toSeconds(report.points[i].done));
  }
  std::printf("  off the plan: joints %.3f deg, path %.3f mm, lag %.3f s; %zu blends lost\n",
              report.max_joint_deviation, report.max_path_deviation, toSeconds(report.lag),
              report.blends_lost.size());
}

/// 1 to 65535; throws std::invalid_argument on anything else.
int portOf(const char* text) {
  char* end = nullptr;
  const long port = std::strtol(text, &end, 10);
  if (end != text && *end == '\0' && port >= 1 && port <= 65535) return static_cast<int>(port);
  throw std::invalid_argument(std::string("'") + text + "' is not a port: 1 to 65535 is allowed");
}

Controller controllerOf(int argc, char** argv) {
  if (argc == 1) return simulatedController();
  Controller controller;
  controller.host = argv[1];
  if (argc == 4) controller.ports = {portOf(argv[2]), portOf(argv[3])};
  return controller;
}

}  // namespace

// NOLINTNEXTLINE(bugprone-exception-escape): whatever is thrown here is a std::exception
int main(int argc, char** argv) try {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const auto before = std::signal(signal, interrupt);
    if (before == SIG_IGN) std::signal(signal, SIG_IGN);  // nohup ignores SIGHUP
  }
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // into a pipe, too, as it happens
  const bool is_help = argc == 2 && (std::string(argv[1]) == "--help" || std::string(argv[1]) == "-h");
  if (is_help || (argc != 1 && argc != 2 && argc != 4) || (argc > 1 && argv[1][0] == '-')) {
    std::puts(
        "usage: load_path [HOST [SCRIPT_PORT STATUS_PORT]]; it moves the robot. Without HOST: a simulated "
        "one");
    return is_help ? 0 : 2;
  }
  const Controller controller = controllerOf(argc, argv);
  showPlan();
  drive(controller);
  std::puts("The path is done");
  return 0;
} catch (const std::invalid_argument& failure) {
  std::puts(failure.what());
  return 2;
} catch (const std::exception& failure) {
  std::printf("The path ends here: %s\n", failure.what());
  return 1;
}
