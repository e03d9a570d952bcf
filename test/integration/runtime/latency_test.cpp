// How long it takes from a call until the frame is on the wire, and until a dead robot is known to be one.
//
// What is sent in which event is the core's, and asserted with invented time in test/unit; here it only has
// to come.
#include <algorithm>
#include <array>
#include <future>
#include <optional>
#include <string>
#include <thread>

#include "figure.h"
#include "script_peer.h"
#include "session_states.h"
#include "thorough.h"

namespace cobot_command::runtime {
namespace {

using blocks::Phase;
using Clock = std::chrono::steady_clock;

/// A commander that keeps nothing of what a flood brings.
class Asker {
 public:
  explicit Asker(SimulatorPorts ports)
      : runtime_(testArm(), settingsFor(ports), [this](const command::Action& action, Instant /*now*/) {
          if (std::holds_alternative<command::GoalEnded>(action) ||
              std::holds_alternative<command::GoalProgressed>(action) ||
              std::holds_alternative<command::RobotStatusReceived>(action)) {
            keep(action);
          }
        }) {
    link_ = submit(blocks::ConnectGoal{"127.0.0.1", ports.script, 60, {}});
    EXPECT_TRUE(reaches(link_, Phase::Connected));
  }

  blocks::GoalId submit(const blocks::Goal& goal) {
    EXPECT_TRUE(runtime_.submit(++last_goal_, goal));
    return last_goal_;
  }
  void cancel(blocks::GoalId goal) { runtime_.cancel(goal); }
  [[nodiscard]] bool reaches(blocks::GoalId goal, Phase phase) {
    return goals_.waitUntil([&](const auto& events) {
      return std::any_of(events.begin(), events.end(), [&](const Event& event) {
        return event.goal == goal && (event.ended || event.phase == phase);
      });
    });
  }
  /// Why the link ended; nothing while it stands.
  [[nodiscard]] std::optional<std::string> endOfTheLink() const {
    for (const auto& event : goals_.events()) {
      if (event.goal == link_ && event.ended) return event.description;
    }
    return std::nullopt;
  }
  [[nodiscard]] bool ends(blocks::GoalId goal) {
    return goals_.waitUntil([&](const auto& events) {
      return std::any_of(events.begin(), events.end(),
                         [&](const Event& event) { return event.goal == goal && event.ended; });
    });
  }

 private:
  struct Event {
    blocks::GoalId goal = 0;
    Phase phase{};
    bool ended = false;
    std::string description;
  };
  static link::LinkSettings settingsFor(SimulatorPorts ports) {
    link::LinkSettings settings;
    settings.status_port = ports.status;
    // After a flood an answer is late, to a script and to a lifesign; no flood lasts.
    settings.reply_timeout = std::chrono::minutes(1);
    settings.supervision_period = std::chrono::minutes(1);
    return settings;
  }
  void keep(const command::Action& action) {
    if (const auto* const ended = std::get_if<command::GoalEnded>(&action)) {
      goals_.add({ended->goal, {}, true, ended->outcome.error_description});
    } else if (const auto* const progressed = std::get_if<command::GoalProgressed>(&action)) {
      goals_.add({progressed->goal, progressed->progress.phase, false, {}});
    }
  }

  testing::EventLog<Event> goals_;
  blocks::GoalId last_goal_ = 0;
  blocks::GoalId link_ = 0;
  CommandRuntime runtime_;
};

blocks::MoveAbsoluteGoal bufferedMove(double joint_deg) {
  auto move = moveJoints({joint_deg, 0, 90, 0, 90, 0});
  move.buffer_mode = static_cast<int>(blocks::BufferMode::Buffered);
  return move;
}

/// A hundred moves: those that blend are in the controller's queue, of the others one is sent and waits for
/// its tag, the rest waits in the layer's. The one that waits for its tag.
blocks::GoalId queueHundredMoves(Asker& asker, ScriptPeer& peer, std::size_t round) {
  constexpr int kBlended = 40, kOthers = 60;
  for (int i = 0; i < kBlended; ++i) {
    auto move = bufferedMove(i % 2);
    move.blending_enable = true;
    EXPECT_TRUE(asker.ends(asker.submit(move)));
  }
  const auto first = asker.submit(bufferedMove(0));
  EXPECT_TRUE(peer.timeOf("QueueTag", round));
  for (int i = 1; i < kOthers; ++i) {
    const auto other = asker.submit(bufferedMove(i % 2));
    EXPECT_TRUE(asker.reaches(other, Phase::Queued));
  }
  return first;
}

/// The longest sequence that there may be: it is planned for many seconds.
blocks::CheckSequenceGoal longSequence() {
  blocks::CheckSequenceGoal goal;
  for (std::size_t i = 0; i < blocks::CheckSequenceGoal::kMostSteps; ++i) {
    goal.steps.emplace_back(moveLine(kStartJoints, {0, 0, i % 2 == 0 ? -300.0 : 0.0}, 1));
  }
  return goal;
}

enum class Reader { Calm, Flooded, Planning };

std::string nameOf(const ::testing::TestParamInfo<Reader>& tested) {
  constexpr std::array<const char*, 3> kNames{"a_calm_reader", "a_flooded_reader", "one_that_plans"};
  return kNames.at(static_cast<std::size_t>(tested.param));
}

class StopPath : public ::testing::TestWithParam<Reader> {};
INSTANTIATE_TEST_SUITE_P(Of, StopPath, ::testing::Values(Reader::Calm, Reader::Flooded, Reader::Planning),
                         nameOf);

/// Asks for a stop behind a hundred moves, again and again.
template <class Ask>
void measureStops(Reader reader, testing::Figure& figure, const Ask& ask) {
  ScriptPeer peer;
  Asker asker(peer.ports());
  for (int i = 0; i < testing::quickOrThorough(2, 100); ++i) {
    const auto round = static_cast<std::size_t>(i);
    const auto first = queueHundredMoves(asker, peer, round);
    ASSERT_EQ(asker.endOfTheLink(), std::nullopt);
    const auto check = reader == Reader::Planning ? asker.submit(longSequence()) : 0;
    if (reader == Reader::Flooded) {
      ASSERT_TRUE(peer.floods());
    }
    const auto start = Clock::now();
    ask(asker, first);
    const auto heard = peer.timeOf(kStop, round);
    peer.endFlood();
    ASSERT_TRUE(heard.has_value()) << asker.endOfTheLink().value_or("the link stands");
    figure.add(*heard - start);
    asker.cancel(check);
    ASSERT_TRUE(asker.ends(first));
    ASSERT_TRUE(reader != Reader::Planning || asker.ends(check));
  }
}

std::string underLoad(const std::string& what, Reader reader) {
  constexpr std::array<const char*, 3> kLoads{"", ", both ports flooded", ", 200 slow lines are checked"};
  return what + ", 100 moves queued" + kLoads.at(static_cast<std::size_t>(reader));
}

TEST_P(StopPath, isOpenForAStop) {
  testing::Figure figure("G4", underLoad("stop to its frame read by the robot", GetParam()), "ms", 20,
                         testing::Figure::Limited::NinetyNinthPercentile);
  measureStops(GetParam(), figure, [](Asker& asker, auto /*moving*/) { asker.submit(blocks::StopGoal{}); });
}

TEST_P(StopPath, isOpenForACancel) {
  testing::Figure figure("G4", underLoad("cancel to the stop frame read by the robot", GetParam()), "ms", 20,
                         testing::Figure::Limited::NinetyNinthPercentile);
  measureStops(GetParam(), figure, [](Asker& asker, auto moving) { asker.cancel(moving); });
}

TEST(CommandLatency, ofFiftyGoalsASecond) {
  constexpr auto kPeriod = std::chrono::milliseconds(20);
  testing::Figure figure("G3", "goal to its frame read by the robot, 50 goals/s", "ms", 20,
                         testing::Figure::Limited::NinetyNinthPercentile);
  ScriptPeer peer;
  Asker asker(peer.ports());
  auto next = Clock::now();
  for (int i = 0; i < testing::quickOrThorough(10, 1000); ++i) {
    std::this_thread::sleep_until(next += kPeriod);  // the load, not a wait for something
    auto move = moveJoints({i % 2 == 0 ? 5.0 : 0.0, 0, 90, 0, 90, 0});
    move.blending_enable = true;
    const auto start = Clock::now();
    const auto goal = asker.submit(move);
    const auto heard = peer.timeOf("PTP", static_cast<std::size_t>(i));
    ASSERT_TRUE(heard.has_value());
    figure.add(*heard - start);
    ASSERT_TRUE(asker.ends(goal));
  }
}

/// Whoever is told may take a while; the frame, or the stop, does not wait for that.
TEST(CommandLatency, holdsNoFrameBackForThoseWhoAreTold) {
  ScriptPeer peer;
  testing::EventLog<blocks::Phase> link;
  std::promise<bool> was_sent;
  link::LinkSettings settings;
  settings.status_port = peer.ports().status;
  CommandRuntime runtime(testArm(), settings, [&](const command::Action& action, Instant /*now*/) {
    if (const auto* const told = std::get_if<command::GoalProgressed>(&action)) {
      link.add(told->progress.phase);
    }
    const auto* const accepted = std::get_if<command::GoalAccepted>(&action);
    if (accepted && accepted->goal == 2) was_sent.set_value(peer.timeOf("PTP", 0).has_value());
  });
  ASSERT_TRUE(runtime.submit(1, blocks::ConnectGoal{"127.0.0.1", peer.ports().script, 60, {}}));
  ASSERT_TRUE(link.waitUntil([](const auto& phases) {
    return std::find(phases.begin(), phases.end(), Phase::Connected) != phases.end();
  }));
  ASSERT_TRUE(runtime.submit(2, bufferedMove(5)));
  EXPECT_TRUE(was_sent.get_future().get());
}

TEST(DeadPeer, isFoundByItsLifesignAndEndsAllThatIsUnderWay) {
  testing::Figure found("G6", "a robot falls silent in motion, until the link is lost", "ms", 3000);
  // The goals wait for the three status frames that may show a reason beside the silence.
  testing::Figure ended("G6", "from there until all goals have ended", "ms", 100);
  for (int i = 0; i < testing::quickOrThorough(1, 20); ++i) {
    Session session;
    session.robot = std::make_unique<Robot>(1);
    session.commander = std::make_unique<Commander>(session.robot->ports().status);
    const auto link = session.commander->connect(session.robot->ports());
    const auto move = session.move();
    const auto start = Clock::now();
    session.fault("silence");
    ASSERT_TRUE(session.commander->waitFor<command::StatusChanged>(
        [](const auto& changed) { return changed.status.last_lost.has_value(); }));
    const auto lost = Clock::now();
    const auto of_move = session.commander->outcomeOf(move);
    const auto of_link = session.commander->outcomeOf(link);
    const auto last = Clock::now();
    ASSERT_TRUE(of_move && of_link);
    EXPECT_EQ(of_move->error_id, 0x99) << of_move->error_description;
    EXPECT_EQ(of_link->error_id, 0x90) << of_link->error_description;
    found.add(lost - start);
    ended.add(last - lost);
  }
}

}  // namespace
}  // namespace cobot_command::runtime
