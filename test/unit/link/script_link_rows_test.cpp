// The script link, row by row of its table, and the pairs that are in none.
#include "script_link_fixture.h"

namespace cobot_command::link {
namespace {

using State = ScriptLinkState;
using Event = ScriptLinkEvent;

struct Case {
  State state;
  Event event;
};

class ScriptLinkRows : public ScriptLinkTest, public ::testing::WithParamInterface<Case> {};

TEST_P(ScriptLinkRows, isFollowed) {
  const auto row = *findTransition<ScriptLinkTable>(GetParam().state, GetParam().event);
  bringTo(row.from);
  ASSERT_EQ(link.state(), row.from);
  before = row.from;
  make(row.event);
  EXPECT_EQ(link.state(), row.to);
  EXPECT_EQ(all<LinkLost>().size(), row.action == ScriptLinkAction::Lose ? 1u : 0u);
  EXPECT_EQ(link.nextDeadline().has_value(), row.to != State::Disconnected && row.to != State::Connecting);
  EXPECT_FALSE(link.diagnosis().empty());
  const bool down = row.to == State::BackingOff || row.to == State::Disconnected;
  const bool by_peer = row.event == Event::Closed || row.event == Event::OpenFailed;
  const bool had_connection = row.from != State::BackingOff && !by_peer;
  EXPECT_EQ(wire.closed.size(), down && had_connection ? 1u : 0u);
}

std::vector<Case> listedPairs() {
  std::vector<Case> cases;
  for (const auto& row : ScriptLinkTable::kRows) cases.push_back({row.from, row.event});
  return cases;
}
INSTANTIATE_TEST_SUITE_P(Table, ScriptLinkRows, ::testing::ValuesIn(listedPairs()));

class UnlistedPairs : public ScriptLinkTest, public ::testing::WithParamInterface<Case> {};

TEST_P(UnlistedPairs, changeNothing) {
  ASSERT_FALSE(findTransition<ScriptLinkTable>(GetParam().state, GetParam().event));
  bringTo(GetParam().state);
  outputs.clear();
  const std::size_t sent = wire.sent.size();
  const std::size_t opened = wire.opened.size();
  before = GetParam().state;
  make(GetParam().event);
  EXPECT_EQ(link.state(), GetParam().state);
  EXPECT_EQ(wire.sent.size(), sent);
  EXPECT_EQ(wire.opened.size(), opened);
  EXPECT_TRUE(wire.closed.empty());
  EXPECT_TRUE(all<LinkLost>().empty());
}

// Those that can be brought about from outside; the others never come to the table.
INSTANTIATE_TEST_SUITE_P(
    Table, UnlistedPairs,
    ::testing::Values(Case{State::Disconnected, Event::Stop}, Case{State::BackingOff, Event::Start},
                      Case{State::BackingOff, Event::ExitAccepted}, Case{State::Probing, Event::Start},
                      Case{State::Probing, Event::Opened}, Case{State::Probing, Event::NodeLeft},
                      Case{State::NotListening, Event::ExitAccepted},
                      Case{State::NotListening, Event::ForeignPeer},
                      Case{State::Leaving, Event::ExitAccepted}, Case{State::Leaving, Event::ForeignPeer},
                      Case{State::Ready, Event::Start}, Case{State::Ready, Event::Opened},
                      Case{State::Ready, Event::ForeignPeer}));

}  // namespace
}  // namespace cobot_command::link
