// A tour of the actions: connects, checks a sequence before it moves, moves in three ways with blending,
// works in another base with another tool, pauses and resumes, stops, and returns. Needs about 1 m of free
// space around the robot. Uses an existing link and leaves it open. Otherwise opens a link and closes it at
// the end.
//
// Ctrl-C, SIGTERM and a closed terminal stop the robot. Exit status: 0 if all steps succeeded, 1 with the
// reason if not. The same in Python: tour.py.

#include <chrono>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include <actionlib/client/simple_action_client.h>
#include <ros/ros.h>

#include "cobot_command/ChangeBaseAction.h"
#include "cobot_command/ChangeTCPAction.h"
#include "cobot_command/CheckSequenceAction.h"
#include "cobot_command/CommandStatus.h"
#include "cobot_command/ConnectAction.h"
#include "cobot_command/MoveAbsoluteAction.h"
#include "cobot_command/MoveCircleAction.h"
#include "cobot_command/MoveRelativeAction.h"
#include "cobot_command/ProgramControlAction.h"
#include "cobot_command/StopAction.h"

namespace {

using namespace cobot_command;
using State = actionlib::SimpleClientGoalState;

const ros::Duration kTimeout(60);
const ros::Duration kCloseTimeout(5);  // a command node that hangs must not delay the end
const ros::Duration kGlance(0.02);

volatile std::sig_atomic_t interrupted = 0;
bool has_moved = false;  // a motion of this tour was taken

void interrupt(int /*signal*/) {
  interrupted = 1;
}

/// With its own handler, roscpp would shut down before the robot can be stopped.
void heedSignals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const auto before = std::signal(signal, interrupt);
    if (before == SIG_IGN) std::signal(signal, SIG_IGN);  // nohup ignores SIGHUP
  }
}

/// mm and degrees, or six joints in degrees.
Transformation six(double x, double y, double z, double rx = 0, double ry = 0, double rz = 0) {
  Transformation values;
  values.x = x;
  values.y = y;
  values.z = z;
  values.rx = rx;
  values.ry = ry;
  values.rz = rz;
  return values;
}

/// Point to point, joints in degrees.
MoveAbsoluteGoal home() {
  MoveAbsoluteGoal goal;
  goal.movement_command = MoveAbsoluteGoal::PTP;
  goal.data_format = MoveAbsoluteGoal::JPP;
  goal.target_position = six(0, 0, 90, 0, 90, 0);
  goal.speed = 50;
  goal.accel_time = 300;
  return goal;
}

/// A line by an offset [mm], at `speed` [mm/s].
MoveRelativeGoal by(const Transformation& offset, int data_format, int speed) {
  MoveRelativeGoal goal;
  goal.movement_command = MoveRelativeGoal::LINE;
  goal.data_format = data_format;
  goal.target_position = offset;
  goal.speed = speed;
  goal.accel_time = 300;
  return goal;
}

/// Done when the controller has accepted it: the next motion begins before the robot has stopped.
MoveRelativeGoal up() {
  MoveRelativeGoal goal = by(six(0, 0, 60), MoveRelativeGoal::CAP, 150);
  goal.blending_enable = true;
  goal.blending_value = 50;
  return goal;
}

MoveRelativeGoal aside() {
  MoveRelativeGoal goal = by(six(0, 80, 0), MoveRelativeGoal::CAP, 150);
  goal.buffer_mode = MoveRelativeGoal::BUFFERED;
  return goal;
}

MoveCircleGoal arc() {
  MoveCircleGoal goal;
  goal.data_format = MoveCircleGoal::CAP;
  goal.arc_point = six(480, -60, 461, 180, 0, 90);
  goal.end_point = six(517.5, 0, 461, 180, 0, 90);
  goal.speed = 150;
  goal.accel_time = 300;
  return goal;
}

SequenceStep step(const MoveRelativeGoal& move) {
  SequenceStep checked;
  checked.kind = SequenceStep::MOVE_RELATIVE;
  checked.move_relative = move;
  return checked;
}

/// The client of one action. Throws if a goal does not end as expected.
template <class Action>
class Client {
 public:
  using Goal = typename Action::_action_goal_type::_goal_type;
  using Result = typename Action::_action_result_type::_result_type;

  explicit Client(std::string name) : name_(std::move(name)), client_(name_) {}

  Result run(const Goal& goal) {
    start(goal);
    return expect(State::SUCCEEDED);
  }

  /// Returns when the goal is accepted, so that it can be cancelled.
  void start(const Goal& goal) {
    if (interrupted != 0) throw std::runtime_error("interrupted");
    waitForServer();
    client_.sendGoal(goal);
    while (ros::ok() && client_.getState() == State::PENDING) ros::Duration(0.01).sleep();
    has_moved = has_moved || (name_.rfind("move_", 0) == 0 && client_.getState() != State::REJECTED);
  }

  /// The last goal, which nothing interrupts. Its result is ignored.
  void runLast(const Goal& goal) {
    if (client_.isServerConnected() || client_.waitForServer(kCloseTimeout)) {
      client_.sendGoalAndWait(goal, kCloseTimeout, kCloseTimeout);
    }
  }

  Result expect(State::StateEnum state) {
    const ros::Time deadline = ros::Time::now() + kTimeout;
    while (!client_.waitForResult(kGlance)) {
      if (interrupted != 0) throw std::runtime_error("interrupted");
      if (ros::Time::now() > deadline) throw std::runtime_error(name_ + " did not end");
    }
    Result result = *client_.getResult();
    if (client_.getState() != state) {
      throw std::runtime_error(name_ + ": " + result.error_description + " -> " + result.remedy);
    }
    return result;
  }

  void waitForServer() {
    if (client_.waitForServer(kTimeout)) return;
    throw std::runtime_error("no action server " + name_ + ": is the command node running?");
  }

  bool isActive() { return client_.getState() == State::ACTIVE; }
  void cancelAndWait() {
    client_.cancelGoal();
    client_.waitForResult(kCloseTimeout);
  }

 private:
  std::string name_;
  actionlib::SimpleActionClient<Action> client_;
};

/// Commands can be sent.
bool isReady() {
  // Latched: the newest is there at once.
  const auto status = ros::topic::waitForMessage<CommandStatus>("command_status", ros::Duration(10));
  return status && status->link_state == CommandStatus::READY && status->status_stream;
}

/// Ready to send commands as long as it lives.
class Link {
 public:
  Link() {
    client_.waitForServer();
    is_others_ = isReady();
    std::puts(is_others_ ? "A link exists: it is used and kept"
                         : "Connect: the goal stays active as long as the link exists");
    if (!is_others_) open();
  }
  Link(const Link&) = delete;
  Link& operator=(const Link&) = delete;
  /// Leaves a robot that stands: by the normal end of connect, or, over a link of somebody else, by a stop. A
  /// robot that was never ours to move, as somebody else moves it, is left alone.
  void leave() {
    if (!is_others_) {
      client_.cancelAndWait();
    } else if (has_moved) {
      Client<StopAction>("stop").runLast(StopGoal());
    }
  }

 private:
  void open() {
    ConnectGoal goal;
    goal.timeout = 20;
    client_.start(goal);
    while (client_.isActive()) {
      if (isReady()) return;
    }
    client_.expect(State::ACTIVE);
  }

  Client<ConnectAction> client_{"connect"};
  bool is_others_ = false;
};

void show(const Transformation& tool) {
  std::printf("  the tool is at %.1f, %.1f, %.1f mm\n", tool.x, tool.y, tool.z);
}

void checkBeforeMoving() {
  std::puts("Check a sequence that starts at home: nothing is sent");
  CheckSequenceGoal goal;
  goal.start_joints = {0, 0, 90, 0, 90, 0};
  goal.steps = {step(up()), step(aside())};
  const auto checked = Client<CheckSequenceAction>("check_sequence").run(goal);
  std::printf("  it would take %.2f s\n", checked.planned_duration.toSec());
}

void moveInThreeWays() {
  Client<MoveAbsoluteAction> move_absolute("move_absolute");
  Client<MoveRelativeAction> move_relative("move_relative");
  std::puts("Go home, point to point");
  move_absolute.run(home());
  std::puts("Up, and aside without stopping in between: the first is done when it is accepted");
  move_relative.run(up());
  move_relative.run(aside());
  std::puts("Home again, and along an arc");
  move_absolute.run(home());
  show(Client<MoveCircleAction>("move_circle").run(arc()).final_pose);
}

void workInAnotherBase() {
  std::puts("Another base and another tool: the same place has other numbers");
  Client<ChangeBaseAction> change_base("change_base");
  Client<ChangeTCPAction> change_tcp("change_tcp");
  ChangeBaseGoal base;
  base.transformation = six(400, 0, 100);
  change_base.run(base);
  ChangeTCPGoal tool;
  tool.tcp_offset = six(0, 0, 120);
  tool.weight = 1.2;
  change_tcp.run(tool);
  show(Client<MoveRelativeAction>("move_relative")
           .run(by(six(0, 0, 20), MoveRelativeGoal::CAP, 100))
           .final_pose);
  tool.tcp_name = "NOTOOL";
  change_tcp.run(tool);
  base.base_name = "RobotBase";
  change_base.run(base);
}

void pauseResumeAndStop() {
  std::puts("Begin a slow motion; pause it, resume it, stop it");
  Client<MoveRelativeAction> move_relative("move_relative");
  Client<ProgramControlAction> program_control("program_control");
  move_relative.start(by(six(0, 0, 150), MoveRelativeGoal::TAP, 20));
  ProgramControlGoal control;
  control.command = ProgramControlGoal::PAUSE;
  program_control.run(control);
  control.command = ProgramControlGoal::RESUME;
  program_control.run(control);
  Client<StopAction>("stop").run(StopGoal());
  move_relative.expect(State::PREEMPTED);
  std::puts("Home");
  Client<MoveAbsoluteAction>("move_absolute").run(home());
}

/// False, and why, when a part of the tour did not end as it should.
template <class Part>
bool succeeds(Part part) {
  try {
    part();
    return true;
  } catch (const std::exception& failure) {
    std::printf("The tour ends here: %s\n", failure.what());
    return false;
  }
}

/// Waits for the ROS master. A node handle would wait as well, but heeds no signal.
bool hasMaster() {
  while (!ros::master::check()) {
    if (interrupted != 0) return false;
    std::printf("waiting for the ROS master at %s\n", ros::master::getURI().c_str());
    std::this_thread::sleep_for(std::chrono::seconds(1));
  }
  return true;
}

/// The tour has no options. Asking for help must not move the robot.
int explain(const std::string& option) {
  std::puts(
      "tour: the actions, one after the other. It moves the robot and needs about 1 m of free space around "
      "it.");
  if (option == "--help" || option == "-h") return 0;
  std::printf("tour takes no arguments; '%s' was given\n", option.c_str());
  return 2;
}

}  // namespace

// NOLINTNEXTLINE(bugprone-exception-escape): whatever is thrown here is a std::exception
int main(int argc, char** argv) try {
  ros::init(argc, argv, "tour", ros::init_options::AnonymousName | ros::init_options::NoSigintHandler);
  if (argc > 1) return explain(argv[1]);
  heedSignals();
  if (!hasMaster()) return 1;
  const ros::NodeHandle node;
  Link link;
  const bool is_over = succeeds([] {
    checkBeforeMoving();
    moveInThreeWays();
    workInAnotherBase();
    pauseResumeAndStop();
  });
  link.leave();
  if (is_over) std::puts("The tour is over");
  return is_over ? 0 : 1;
} catch (const std::exception& failure) {
  std::printf("The tour ends here: %s\n", failure.what());
  return 1;
}
