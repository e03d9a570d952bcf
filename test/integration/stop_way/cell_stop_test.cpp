// A stop of a cell goes first, whatever the disk of the supervisor's journal does.
#include <chrono>
#include <fstream>
#include <memory>
#include <string>
#include <thread>

#include "cell/cell_messages.h"
#include "event_log.h"
#include "own_folder.h"
#include "slow_disk.h"
#include "source_tree.h"
#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/spinner.h>
#include <std_srvs/SetBool.h>
#include <std_srvs/Trigger.h>

#include "cobot_command/CellReport.h"
#include "cobot_command/CellState.h"
#include "cobot_command/StopActionGoal.h"
#include "cobot_command/cell/artifact/cell_build.h"
#include "cobot_command/ros/supervision/supervisor_node.h"
#include "cobot_command/runtime/cell/cell_files.h"

namespace cobot_command::ros_adapter {
namespace {

/// The supervisor of the cell handover; its robot RA is this program.
class CellStopWay : public ::testing::Test {
 protected:
  CellStopWay() {
    auto read = runtime::readCellFile(test_support::inSourceTree("config/cells/handover.yaml"));
    cell::CellBuild build(*std::move(read), cell::Policy::Supervisor, 1);
    for (const cell::BuildStage stage : cell::kBuildStages) EXPECT_TRUE(build.run(stage).empty());
    std::ofstream(folder.file("artifact")) << build.bytes();
    auto opened = runtime::CellSupervisor::open({folder.file("artifact"), folder.file("journal"), ""},
                                                runtime::Deciding::AsBuilt);
    hash = (*opened)->artifact().digest;
    supervisor = std::make_unique<SupervisorNode>(ros::NodeHandle("/cell"),
                                                  ros::NodeHandle("/cell/supervisor"), *std::move(opened));
    spinner.start();
    listeners.start();
  }
  ~CellStopWay() override {
    testing::SlowDisk::instance().goOn();
    spinner.stop();
    listeners.stop();
  }

  /// The supervisor knows its node then, and can stop it.
  void report() {
    cell::RobotReport report;
    report.robot = "RA";
    report.hash = hash;
    report.session = 1;
    report.number = ++number;
    reports.publish(toMessage(report));
  }
  void becomeKnown() {
    const auto deadline = std::chrono::steady_clock::now() + testing::kDeadline;
    const auto wait = [deadline](const auto& is_so) {
      while (!is_so() && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
      return is_so();
    };
    ASSERT_TRUE(wait([this] { return reports.getNumSubscribers() > 0; }));
    report();
    ASSERT_TRUE(wait([this] { return stops.getNumPublishers() > 0; }));
  }
  template <class Service>
  [[nodiscard]] typename Service::Response call(const std::string& name, Service service) {
    EXPECT_TRUE(cell.serviceClient<Service>(name).call(service)) << name;
    return service.response;
  }
  [[nodiscard]] bool hearsStop() {
    return stop_goals.waitUntil([](const auto& goals) { return !goals.empty(); });
  }

  OwnFolder folder;
  std::string hash;
  std::uint64_t number = 0;
  std::unique_ptr<SupervisorNode> supervisor;
  ros::AsyncSpinner spinner{1};  ///< of the supervisor
  ros::CallbackQueue queue;
  ros::AsyncSpinner listeners{1, &queue};
  ros::NodeHandle cell{"/cell"};
  ros::NodeHandle listening{[this] {
    ros::NodeHandle handle("/cell");
    handle.setCallbackQueue(&queue);
    return handle;
  }()};
  testing::EventLog<std::string> stop_goals;
  testing::EventLog<int> modes;
  ros::Publisher reports = cell.advertise<cobot_command::CellReport>("reports", 10);
  // In the namespace of the node that reports: of this program.
  ros::Subscriber stops = listening.subscribe<cobot_command::StopActionGoal>(
      "/stop/goal", 10, [this](const auto& goal) { stop_goals.add(goal->goal_id.id); });
  ros::Subscriber states = listening.subscribe<cobot_command::CellState>(
      "state", 10, [this](const auto& state) { modes.add(state->mode); });
};

TEST_F(CellStopWay, aStopWaitsForNoJournal) {
  becomeKnown();
  testing::SlowDisk::instance().hang();
  std_srvs::SetBool hold;
  hold.request.data = 1;
  std::thread person([&] { EXPECT_EQ(call("hold", hold).success, 1); });
  ASSERT_TRUE(testing::SlowDisk::instance().isWaitedFor());
  EXPECT_EQ(call("stop", std_srvs::Trigger()).success, 1);
  EXPECT_TRUE(hearsStop());
  testing::SlowDisk::instance().goOn();
  person.join();
  EXPECT_TRUE(modes.waitUntil([](const auto& seen) { return !seen.empty(); }));
}

TEST_F(CellStopWay, endsWhileItsPeopleWait) {
  std_srvs::SetBool finish;
  finish.request.data = 1;
  testing::SlowDisk::instance().hang();
  std::thread person([&] { EXPECT_EQ(call("finish", finish).success, 1); });
  ASSERT_TRUE(testing::SlowDisk::instance().isWaitedFor());
  std::thread disk([] { testing::SlowDisk::instance().goOn(); });
  spinner.stop();
  supervisor.reset();
  person.join();
  disk.join();
}

}  // namespace
}  // namespace cobot_command::ros_adapter
