#include "cobot_command/runtime/simulation/simulator_runtime.h"

#include <future>
#include <limits>

#include "long_pvt.h"
#include "raw_client.h"
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cobot_command/protocol/frame.h"

namespace cobot_command::runtime {
namespace {

using protocol::encodeFrame;
using simulator::LogLine;
using simulator::RobotState;
using simulator::SimulatedController;
using ::testing::HasSubstr;

arm::ArmModel arm900() {
  return *arm::ArmModel::named("tm5-900");
}

SimulatorOptions anyPorts(double time_scale = 20) {
  SimulatorOptions options;
  options.script_port = 0;
  options.status_port = 0;
  options.time_scale = time_scale;
  return options;
}

/// A started simulator and its ports.
struct Simulator {
  explicit Simulator(const SimulatorOptions& options = anyPorts(), SimulatorRuntime::Observer observer = {})
      : runtime(arm900(), simulator::Settings{}, options, std::move(observer)) {
    const auto started = runtime.start();
    EXPECT_TRUE(started.has_value()) << started.error().message;
    ports = started.value_or(SimulatorPorts{});
  }
  /// Carries out an operator's action, and waits until all that follows from it is done.
  void operate(SimulatorRuntime::Operation operation) {
    ASSERT_TRUE(runtime.post(std::move(operation)));
    (void)state();
  }
  [[nodiscard]] RobotState state() {
    std::promise<RobotState> state;
    EXPECT_TRUE(
        runtime.post([&](SimulatedController& controller, Instant) { state.set_value(controller.state()); }));
    return state.get_future().get();
  }

  SimulatorRuntime runtime;
  SimulatorPorts ports;
};

const std::string kListenQuery = encodeFrame("TMSTA", "00");
const std::string kListenAnswer = encodeFrame("TMSTA", "00,true,Listen1");

/// From the start posture, joint 1 by 90 degrees and back is slow at 5 %: some 10 s in simulated time.
const std::string kSlowMotion =
    encodeFrame("TMSCT", "1,PTP(\"JPP\",90,0,90,0,90,0,5,200,0,false)\r\nQueueTag(3)");
const std::string kTagComplete = encodeFrame("TMSTA", "01,03,true");

TEST(SimulatorRuntime, answersWhetherItListens) {
  const Simulator simulator;
  RawClient client(simulator.ports.script);
  client.send(kListenQuery);
  EXPECT_TRUE(client.reads(kListenAnswer)) << client.received();
}

TEST(SimulatorRuntime, streamsItsStatusToEveryClient) {
  const Simulator simulator;
  RawClient first(simulator.ports.status);
  RawClient second(simulator.ports.status);
  EXPECT_TRUE(first.reads("Joint_Angle"));
  EXPECT_TRUE(second.reads("Joint_Angle"));
}

TEST(SimulatorRuntime, reportsTheTagWhenTheMotionIsOver) {
  Simulator simulator(anyPorts(50));
  RawClient client(simulator.ports.script);
  client.send(kSlowMotion);
  ASSERT_TRUE(client.reads(encodeFrame("TMSCT", "1,OK"))) << client.received();
  EXPECT_EQ(client.received().find(kTagComplete), std::string::npos);
  ASSERT_TRUE(client.reads(kTagComplete));
  EXPECT_NEAR(simulator.state().joints[0], degToRad(90), 1e-9);
}

TEST(SimulatorRuntime, movesAsFastAsPossibleAndStreamsEveryStateOnTheWay) {
  Simulator simulator(anyPorts(kAsFastAsPossible));
  RawClient status(simulator.ports.status);
  ASSERT_TRUE(status.reads("Joint_Angle"));
  const auto frames = [&] {
    int count = 0;
    for (auto at = status.received().find("$TMSVR"); at != std::string::npos;
         at = status.received().find("$TMSVR", at + 1)) {
      ++count;
    }
    return count;
  };
  const auto real_start = std::chrono::steady_clock::now();
  const Instant start = simulator.state().time;
  RawClient client(simulator.ports.script);
  client.send(kSlowMotion);
  ASSERT_TRUE(client.reads(kTagComplete));
  const double simulated = toSeconds(simulator.state().time - start);
  const double real = toSeconds(std::chrono::steady_clock::now() - real_start);
  EXPECT_GT(simulated, 9.0);
  EXPECT_LT(real, simulated / 2);
  EXPECT_TRUE(status.reads(std::string(1, '$')));
  simulator.runtime.stop();
  ASSERT_TRUE(status.readsTheEnd());
  EXPECT_GT(frames(), static_cast<int>(simulated / 0.015) - 2);
}

TEST(SimulatorRuntime, takesAPathOfThousandsOfPointsInOneFrameAndListensOn) {
  const Simulator simulator(anyPorts(kAsFastAsPossible));
  RawClient client(simulator.ports.script);
  RawClient other(simulator.ports.script);
  client.send(encodeFrame("TMSCT", "1," + testing::LongPvt(6000).script()));
  other.send(kListenQuery);
  EXPECT_TRUE(other.reads(kListenAnswer));
  ASSERT_TRUE(client.reads(encodeFrame("TMSCT", "1,OK"))) << client.received();
  ASSERT_TRUE(client.reads(encodeFrame("TMSTA", "01,02,true")));
  EXPECT_NE(client.received().find(encodeFrame("TMSTA", "01,01,true")), std::string::npos);
}

TEST(SimulatorRuntime, refusesClientsWhileNoProjectRunsAndServesThemAgainOnTheSamePort) {
  Simulator simulator;
  RawClient before(simulator.ports.script);
  ASSERT_TRUE(before.isConnected());
  simulator.operate([](SimulatedController& controller, Instant now) {
    controller.operate(simulator::StopProject{}, now);
  });
  ASSERT_TRUE(before.readsTheEnd());
  EXPECT_FALSE(RawClient(simulator.ports.script).isConnected());
  EXPECT_TRUE(RawClient(simulator.ports.status).isConnected()) << "the status port needs no project";

  simulator.operate(
      [](SimulatedController& controller, Instant now) { controller.operate(simulator::RunProject{}, now); });
  RawClient after(simulator.ports.script);
  ASSERT_TRUE(after.isConnected());
  after.send(kListenQuery);
  EXPECT_TRUE(after.reads(kListenAnswer));
}

TEST(SimulatorRuntime, tellsItsStateAtTheRateAskedFor) {
  testing::EventLog<RobotState> states;
  SimulatorOptions options = anyPorts();
  options.state_period = std::chrono::milliseconds(2);
  const Simulator simulator(options, {[&](const RobotState& state) { states.add(state); }, {}});
  ASSERT_TRUE(states.waitUntil([](const auto& seen) { return seen.size() >= 10; }));
  const auto seen = states.events();
  EXPECT_LT(seen.front().time, seen.back().time);
  EXPECT_TRUE(seen.front().joints.isApprox(simulator::Settings{}.start_posture));
}

TEST(SimulatorRuntime, tellsItsStateOnlyWhileThatIsWanted) {
  testing::EventLog<RobotState> states;
  SimulatorOptions options = anyPorts();
  options.state_period = std::chrono::milliseconds(1);
  options.tells_states = false;
  Simulator simulator(options, {[&](const RobotState& state) { states.add(state); }, {}});
  for (int i = 0; i < 2; ++i) {
    const auto before = states.events().size();
    simulator.runtime.tellStates(true);
    ASSERT_TRUE(states.waitUntil([&](const auto& seen) { return seen.size() >= before + 3; }));
    simulator.runtime.tellStates(false);
    static_cast<void>(simulator.state());  // behind that
    const auto after = states.events().size();
    RawClient client(simulator.ports.status);
    ASSERT_TRUE(client.reads("Joint_Angle"));  // a period of the stream, which is longer
    EXPECT_EQ(states.events().size(), after);
  }
}

TEST(SimulatorRuntime, tellsItsLog) {
  testing::EventLog<std::string> lines;
  const Simulator simulator(anyPorts(), {{}, [&](const LogLine& line) { lines.add(line.text); }});
  RawClient client(simulator.ports.script);
  client.send(kListenQuery);
  EXPECT_TRUE(lines.waitUntil([](const auto& seen) {
    return std::any_of(seen.begin(), seen.end(),
                       [](const std::string& line) { return line.find("connected") != std::string::npos; });
  })) << ::testing::PrintToString(lines.events());
}

TEST(SimulatorRuntime, saysWhatToDoWhenAPortIsTaken) {
  const Simulator first;
  SimulatorOptions options = anyPorts();
  options.status_port = first.ports.script;
  SimulatorRuntime second(arm900(), simulator::Settings{}, options);
  const auto started = second.start();
  ASSERT_FALSE(started.has_value());
  EXPECT_EQ(started.error().kind, SimulatorError::Kind::Unavailable);
  EXPECT_THAT(started.error().message, HasSubstr(std::to_string(first.ports.script)));
  EXPECT_THAT(started.error().message, HasSubstr("choose another port"));
}

TEST(SimulatorRuntime, doesNotTakeOnePortForBoth) {
  int port = 0;
  {
    const Simulator earlier;
    port = earlier.ports.script;
  }
  SimulatorOptions options;
  options.script_port = port;
  options.status_port = port;
  SimulatorRuntime simulator(arm900(), simulator::Settings{}, options);
  EXPECT_FALSE(simulator.start().has_value());
}

TEST(SimulatorRuntime, refusesOptionsThatMeanNothing) {
  const simulator::Settings settings;
  const auto refused = [&settings](auto change) {
    SimulatorOptions options = anyPorts();
    change(options);
    SimulatorRuntime simulator(arm900(), settings, options);
    const auto started = simulator.start();
    return !started.has_value() && started.error().kind == SimulatorError::Kind::BadOption &&
           !started.error().message.empty();
  };
  for (const int port : {-1, 65536, std::numeric_limits<int>::max()}) {
    EXPECT_TRUE(refused([&](SimulatorOptions& options) { options.script_port = port; })) << port;
    EXPECT_TRUE(refused([&](SimulatorOptions& options) { options.status_port = port; })) << port;
  }
  for (const double scale :
       {-1.0, 1e-9, 1e9, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_TRUE(refused([&](SimulatorOptions& options) { options.time_scale = scale; })) << scale;
  }
  for (const char* address : {"", "nowhere", "192.0.2.1"}) {
    EXPECT_TRUE(refused([&](SimulatorOptions& options) { options.bind_address = address; })) << address;
  }
}

TEST(SimulatorRuntime, doesNothingAnyMoreOnceStopped) {
  testing::EventLog<RobotState> states;
  SimulatorOptions options = anyPorts();
  options.state_period = std::chrono::milliseconds(1);
  Simulator simulator(options, {[&](const RobotState& state) { states.add(state); }, {}});
  ASSERT_TRUE(states.waitUntil([](const auto& seen) { return !seen.empty(); }));
  simulator.runtime.stop();
  const auto seen = states.events().size();
  EXPECT_FALSE(simulator.runtime.post([](auto&, Instant) { FAIL(); }));
  EXPECT_FALSE(RawClient(simulator.ports.script).isConnected());
  EXPECT_FALSE(RawClient(simulator.ports.status).isConnected());
  simulator.runtime.stop();  // again: harmless
  EXPECT_EQ(states.events().size(), seen);
}

TEST(SimulatorRuntime, canBeStoppedBeforeItWasStarted) {
  SimulatorRuntime simulator(arm900(), simulator::Settings{}, anyPorts());
  simulator.stop();
}

}  // namespace
}  // namespace cobot_command::runtime
