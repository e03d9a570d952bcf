#include "script_port/node_flow.h"

#include "table_checks.h"
#include <gtest/gtest.h>

namespace cobot_command::simulator {
namespace {

constexpr FlowState kStates[] = {FlowState::Stopped, FlowState::Listening, FlowState::Leaving,
                                 FlowState::Elsewhere};
constexpr FlowEvent kEvents[] = {FlowEvent::Run, FlowEvent::Exit, FlowEvent::Done, FlowEvent::Reenter,
                                 FlowEvent::Stop};

FlowState after(FlowState state, FlowEvent event) {
  const auto row = findTransition<FlowTable>(state, event);
  return row ? row->to : state;
}

TEST(FlowTable, isSound) {
  testing::expectSoundTable<FlowTable>(FlowState::Elsewhere, FlowEvent::Stop, FlowState::Stopped);
}

TEST(NodeFlow, goesRoundFromStoppedThroughTheNodeAndBackIntoIt) {
  EXPECT_EQ(after(FlowState::Stopped, FlowEvent::Run), FlowState::Listening);
  EXPECT_EQ(after(FlowState::Listening, FlowEvent::Exit), FlowState::Leaving);
  EXPECT_EQ(after(FlowState::Leaving, FlowEvent::Done), FlowState::Elsewhere);
  EXPECT_EQ(after(FlowState::Elsewhere, FlowEvent::Reenter), FlowState::Listening);
}

TEST(NodeFlow, stopsFromEverywhere) {
  for (const FlowState state : kStates) EXPECT_EQ(after(state, FlowEvent::Stop), FlowState::Stopped);
}

TEST(NodeFlow, staysWhereItIsOnEveryPairThatIsNotInTheTable) {
  int changes = 0;
  for (const FlowState state : kStates) {
    for (const FlowEvent event : kEvents) changes += after(state, event) != state ? 1 : 0;
  }
  EXPECT_EQ(changes, 7);
}

}  // namespace
}  // namespace cobot_command::simulator
