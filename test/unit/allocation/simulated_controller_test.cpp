// A simulated controller that runs out of memory, at each single allocation of a run.
#include "cobot_command/simulator/simulated_controller.h"

#include <string>

#include "failing_allocation.h"

#include "cobot_command/protocol/frame.h"

namespace cobot_command::allocation {
namespace {

using simulator::Port;
using simulator::SimulatedController;

constexpr simulator::ClientId kScript = 1, kStatus = 2;

simulator::Settings briefSettings() {
  simulator::Settings settings;
  settings.status_period = std::chrono::milliseconds(200);
  return settings;
}

class Story {
 public:
  Story(const FailingAllocation& failing, const arm::ArmModel& arm)
      : failing_(failing),
        controller_(failing.during([&] { return SimulatedController(arm, briefSettings(), Instant{}); })) {}

  void connect() {
    tell([&](auto& controller) {
      controller.clientConnected(Port::Script, kScript, now_, "127.0.0.1");
      controller.clientConnected(Port::Status, kStatus, now_, "127.0.0.1");
    });
  }
  void script(const std::string& text) {
    const std::string frame = protocol::encodeFrame("TMSCT", "1," + text);
    tell([&](auto& controller) { controller.received(Port::Script, kScript, frame, now_); });
  }
  void operate(const simulator::OperatorAction& action) {
    tell([&](auto& controller) { (void)controller.operate(action, now_); });
  }
  void pass(Duration duration) {
    now_ += duration;
    tell([&](auto& controller) { controller.advance(now_); });
  }

  /// What the clients got.
  [[nodiscard]] const std::string& sent() const { return sent_; }

 private:
  template <class Event>
  void tell(const Event& event) {
    const auto outputs = failing_.during([&] {
      event(controller_);
      return controller_.takeOutputs();
    });
    for (const auto& output : outputs) {
      if (const auto* const send = std::get_if<simulator::Send>(&output)) {
        sent_ += send->bytes;
      }
    }
  }

  const FailingAllocation& failing_;
  SimulatedController controller_;
  Instant now_{};
  std::string sent_;
};

/// A script with a motion, one with a fault, an error, an emergency stop in motion, the project anew.
std::string tell(const FailingAllocation& failing, const arm::ArmModel& arm) {
  Story story(failing, arm);
  story.connect();
  story.script("float[] target = {5,0,90,0,90,0}\r\nPTP(\"JPP\",target,50,200,0,false)\r\nQueueTag(1)");
  story.pass(std::chrono::seconds(2));
  story.script("PTP(\"JPP\",1,2)");
  story.operate(simulator::RaiseError{0x13, "PTP"});
  story.pass(std::chrono::milliseconds(300));
  story.operate(simulator::ClearError{});
  story.script("PTP(\"JPP\",0,0,90,0,90,0,50,200,0,false)\r\nQueueTag(2)");
  story.pass(std::chrono::milliseconds(100));
  story.operate(simulator::SetEmergencyStop{true});
  story.operate(simulator::SetEmergencyStop{false});
  story.operate(simulator::RunProject{});
  story.pass(std::chrono::milliseconds(300));
  return story.sent();
}

TEST(OutOfMemory, leavesNothingOfASimulatedController) {
  const arm::ArmModel arm = *arm::ArmModel::named("tm5-900");
  const std::string sent = tell(FailingAllocation(0), arm);
  EXPECT_NE(sent.find("01,01,true"), std::string::npos) << "the motion was made";
  EXPECT_NE(sent.find("1,ERROR"), std::string::npos) << "the fault was found";
  failEachAllocationOf([&](const auto& failing) { tell(failing, arm); });
}

}  // namespace
}  // namespace cobot_command::allocation
