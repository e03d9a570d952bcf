// The tables of the two links.

#include "table_checks.h"
#include <gtest/gtest.h>

#include "cobot_command/link/script_link_states.h"
#include "cobot_command/link/status_link_states.h"

namespace cobot_command::link {
namespace {

using testing::allUpTo;
using testing::expectSoundTable;

TEST(ScriptLinkTable, isSound) {
  expectSoundTable<ScriptLinkTable>(ScriptLinkState::Ready, ScriptLinkEvent::Stop,
                                    ScriptLinkState::Disconnected);
}

TEST(StatusLinkTable, isSound) {
  expectSoundTable<StatusLinkTable>(StatusLinkState::Streaming, StatusLinkEvent::Stop, StatusLinkState::Off);
}

TEST(ScriptLinkTable, canBeStoppedInEveryStateButTheFirst) {
  for (const auto state : allUpTo(ScriptLinkState::Ready)) {
    const auto row = findTransition<ScriptLinkTable>(state, ScriptLinkEvent::Stop);
    EXPECT_EQ(row.has_value(), state != ScriptLinkState::Disconnected);
    if (row) {
      EXPECT_EQ(row->to, ScriptLinkState::Disconnected);
      EXPECT_EQ(row->action, ScriptLinkAction::Release);
    }
  }
}

TEST(ScriptLinkTable, canBeReadyAgainFromEveryStateWithAConnection) {
  for (const auto state : allUpTo(ScriptLinkState::Ready)) {
    if (!isConnected(state)) continue;
    bool ready = false;
    for (const auto event : {ScriptLinkEvent::AnsweredTrue, ScriptLinkEvent::StillListening}) {
      const auto row = findTransition<ScriptLinkTable>(state, event);
      ready = ready || (row && row->to == ScriptLinkState::Ready);
    }
    EXPECT_TRUE(ready) << "state " << static_cast<int>(state)
                       << ": nothing but lifesigns is sure to be answered";
  }
}

TEST(ScriptLinkTable, tellsOfALossWheneverItWasEstablished) {
  for (const auto state : allUpTo(ScriptLinkState::Ready)) {
    for (const auto event : {ScriptLinkEvent::Closed, ScriptLinkEvent::NoAnswer}) {
      const auto row = findTransition<ScriptLinkTable>(state, event);
      if (isEstablished(state)) {
        ASSERT_TRUE(row);
        EXPECT_EQ(row->action, ScriptLinkAction::Lose);
      } else if (row) {
        EXPECT_EQ(row->action, ScriptLinkAction::Retry);
      }
    }
  }
}

}  // namespace
}  // namespace cobot_command::link
