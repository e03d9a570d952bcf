// The same calls at the same times give the same bytes and the same joints, however often time is advanced
// between them.
#include <functional>
#include <random>

#include "simulated_robot.h"
#include <gtest/gtest.h>

namespace cobot_command::simulator::test {
namespace {

struct Session {
  std::string script_bytes;
  std::string status_bytes;
  std::vector<arm::JointVector> joints;  ///< at the end of each step
};

/// Brings the robot from its time to `target`, by as many calls as it likes.
using Advance = std::function<void(SimulatedRobot&, Instant target)>;

Session play(const Advance& advance) {
  Settings settings;
  settings.velocity_licence = true;
  SimulatedRobot robot(settings);
  const ClientId client = robot.connect(), status = robot.connect(Port::Status);
  Session session;
  Instant time{};
  const auto step = [&](Duration duration, const std::string& script) {
    time += duration;
    advance(robot, time);
    session.joints.push_back(robot.state().joints);
    robot.script(client, "s", script);
  };
  step(7ms,
       "PTP(\"JPP\",90,20,60,0,90,0,100,200,0,false)\r\nQueueTag(1)\r\nMove_PTP(\"JPP\",-5,0,0,0,0,0,10,0,0,"
       "false)\r\nQueueTag(2,1)");
  step(321ms, "Pause()");
  step(1234567ns, "Resume()");
  step(2s, "Line(\"CAP\",0,480,320,180,0,180,100,200,0,false)\r\nQueueTag(3)");
  step(80ms, "Pause()");
  step(90ms, "Resume()");
  step(1s, "StopAndClearBuffer()");
  step(33ms,
       "PTP(\"JPP\",0,0,90,0,90,0,100,200,0,false)\r\nQueueTag(4)\r\nWaitQueueTag(4,100)\r\nScriptExit()");
  step(3s, "QueueTag(5)");
  step(1s,
       "Move_PTP(\"JPP\",-30,10,5,0,0,20,60,200,80,false)\r\nQueueTag(8)\r\n"
       "Move_Line(\"CAR\",0,-50,-50,0,0,10,150,150,12,false)");
  step(123456789ns, "Move_Line(\"TPP\",0,0,-50,0,0,0,10,150,100,false)");
  step(700ms, "Pause()");
  step(400ms, "Resume()\r\nMove_PTP(\"CPP\",0,30,0,0,0,0,20,300,0,false)");
  step(450ms, "StopAndClearBuffer()");
  step(600ms, "Move_PLine(\"CAP\",0,0,-40,0,0,0,100,100,50)\r\nMove_PLine(\"CAP\",0,40,0,0,0,0,100,100,50)");
  step(2s,
       "Move_PLine(\"CAP\",0,0,40,0,0,10,50,100,0)\r\nPVTEnter(0)\r\nPVTPoint(0,20,80,0,90,0,5,0,0,0,0,0,2.5)"
       "\r\n"
       "QueueTag(9)\r\nPVTPoint(5,20,80,0,90,0,0,0,0,0,0,0,1.5)\r\nPVTExit()");
  step(5s, "QueueTag(9)\r\nContinueVLine(400,600)\r\nSetContinueVLine(0,30,0,0,0,0)");
  step(1s, "ContinueVJog()\r\nSetContinueVJog(0,0,5,0,0,0)");
  step(300ms, "SetContinueVJog(0,5,-5,0,0,0)");
  step(500ms, "StopContinueVmode()");
  step(10s, "PTP(\"CPP\",2000,0,0,0,0,0,100,200,0,false)\r\nQueueTag(6,1)");
  step(1s, "QueueTag(7)");
  session.script_bytes = robot.heard(client);
  session.status_bytes = robot.heard(status);
  return session;
}

void inOneStep(SimulatedRobot& robot, Instant target) {
  robot.waitUntil(target);
}

void expectEqual(const Session& one, const Session& other) {
  EXPECT_EQ(one.script_bytes, other.script_bytes);
  EXPECT_TRUE(one.status_bytes == other.status_bytes);
  ASSERT_EQ(one.joints.size(), other.joints.size());
  for (std::size_t i = 0; i < one.joints.size(); ++i) {
    EXPECT_EQ(one.joints[i], other.joints[i]) << "step " << i;
  }
}

TEST(Determinism, twoRunsAreBitIdentical) {
  const Session session = play(inOneStep);
  for (const char* done : {"04,true", "08,true", "09,true"}) {
    EXPECT_NE(session.script_bytes.find(tag(done)), std::string::npos) << done;
  }
  for (const char* wrong : {"09,false", "ERROR"}) {
    EXPECT_EQ(session.script_bytes.find(wrong), std::string::npos) << wrong;
  }
  expectEqual(session, play(inOneStep));
}

TEST(Determinism, advancingEachMillisecondChangesNothing) {
  expectEqual(play(inOneStep), play([](SimulatedRobot& robot, Instant target) {
                while (robot.now() + 1ms < target) robot.wait(1ms);
                robot.waitUntil(target);
              }));
}

TEST(Determinism, advancingFromEventToEventChangesNothing) {
  expectEqual(play(inOneStep), play([](SimulatedRobot& robot, Instant target) {
                while (robot.controller().nextEvent() <= target) {
                  robot.waitUntil(robot.controller().nextEvent());
                }
                robot.waitUntil(target);
              }));
}

TEST(Determinism, advancingAtRandomChangesNothing) {
  std::mt19937 random(1);  // NOLINT: the seed is fixed so that a failure can be repeated
  std::uniform_int_distribution<int> microseconds(0, 20000);
  expectEqual(play(inOneStep), play([&](SimulatedRobot& robot, Instant target) {
                for (Instant next = robot.now(); next < target;
                     next += std::chrono::microseconds(microseconds(random))) {
                  robot.waitUntil(next);
                }
                robot.waitUntil(target);
              }));
}

TEST(Time, doesNotGoBack) {
  SimulatedRobot robot;
  robot.wait(1s);
  robot.controller().advance(Instant{});
  EXPECT_EQ(robot.state().time, Instant{} + 1s);
}

}  // namespace
}  // namespace cobot_command::simulator::test
