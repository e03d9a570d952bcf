// The life sign of the controller while exchange_configuration is enabled: SRCI oracle 10.
#include "exchange/life_sign.h"

#include "exchange_rig.h"
#include <gmock/gmock.h>

namespace cobot_command::testing {
namespace {

using namespace blocks;
using namespace command;
using ::testing::HasSubstr;

std::size_t questionsIn(ExchangeRig& rig, Duration time) {
  const auto asked = [&rig] {
    return std::count_if(rig.traces.begin(), rig.traces.end(), [](const FrameTraced& t) {
      return t.sent && t.bytes.find("TMSTA,2,00") != std::string::npos;
    });
  };
  const auto before = asked();
  rig.pass(time);
  return static_cast<std::size_t>(asked() - before);
}

TEST(LifeSign, isAskedForThreeTimesInItsLimit) {
  struct Row {
    int limit;
    std::size_t in_a_second;
  };
  for (const Row& row : {Row{300, 10}, Row{60, 50}, Row{10, 200}}) {
    ExchangeRig rig;
    rig.connect();
    rig.exchangeWith([&](auto& s) { s.life_sign_time_out = row.limit; });
    rig.pass(500ms);
    const std::size_t asked = questionsIn(rig, 1s);
    EXPECT_NEAR(static_cast<double>(asked), static_cast<double>(row.in_a_second), 1) << row.limit;
  }
}

TEST(LifeSign, thatDoesNotComeEndsTheGoalsAndStopsTheRobot) {
  ExchangeRig rig;
  rig.connect();
  const GoalId id = rig.exchange();
  rig.pass(550ms);
  const GoalId move = rig.submit(CoreRig::move());
  rig.reply(rig.takeScript().id);
  rig.answers_lifesigns = false;
  rig.pass(190ms);
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.pass(120ms);
  EXPECT_EQ(rig.errorOf(id), 0x80A5);
  EXPECT_EQ(rig.errorOf(move), 0x99);
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr("does not stop automatically"));
  EXPECT_THAT(rig.outcome(id)->error_description, HasSubstr("300 ms"));
  bool stops = false;
  for (const auto& message : rig.takeAllSent()) {
    const auto* const script = std::get_if<protocol::ScriptRequest>(&message);
    stops = stops || (script != nullptr && script->script.find("StopAndClearBuffer()") != std::string::npos);
  }
  EXPECT_TRUE(stops);
  EXPECT_NE(rig.latest().link, CommandStatus::LinkState::Ready);
}

TEST(LifeSign, isAnyFrameOfTheController) {
  ExchangeRig rig;
  rig.connect();
  const GoalId id = rig.exchange();
  rig.answers_lifesigns = false;
  for (int i = 0; i < 20; ++i) {
    rig.pass(100ms);
    rig.tag(15);
  }
  EXPECT_EQ(rig.outcome(id), nullptr);
  rig.discardSent();
}

TEST(LifeSign, tellsItsLongestGap) {
  LifeSign sign;
  const Instant begin{100s};
  sign.begin(300ms, begin);
  sign.heard(begin + 100ms);
  sign.heard(begin + 250ms);
  sign.heard(begin + 250ms);
  sign.heard(begin + 300ms);
  EXPECT_EQ(sign.worstGap(), 150ms);
  EXPECT_EQ(sign.deadline(), begin + 600ms);
  sign.begin(20ms, begin + 400ms);
  EXPECT_EQ(sign.worstGap(), 0ms);
  sign.end();
  EXPECT_EQ(sign.deadline(), std::nullopt);
}

}  // namespace
}  // namespace cobot_command::testing
