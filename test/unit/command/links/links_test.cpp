#include "links/links.h"

#include "taken_actions.h"
#include <gtest/gtest.h>

namespace cobot_command::command {
namespace {

using namespace std::chrono_literals;

class LinksTest : public ::testing::Test {
 protected:
  /// What was asked for since the last call, of one kind.
  template <typename Kind>
  std::vector<Kind> take() {
    return testing::takeOf<Kind>(actions_);
  }

  link::LinkSettings settings_;
  std::vector<Action> actions_;
  Links links_{settings_, actions_};
  Instant now_{};
};

TEST_F(LinksTest, asksForAConnectionOfItsOwnForEachLink) {
  links_.script().start("robot", 5890, now_);
  links_.status().start("robot", 5891, now_);

  const auto opened = take<OpenConnection>();
  ASSERT_EQ(opened.size(), 2U);
  EXPECT_EQ(opened[0].channel, link::Channel::Script);
  EXPECT_EQ(opened[0].port, 5890);
  EXPECT_EQ(opened[1].channel, link::Channel::Status);
  EXPECT_EQ(opened[1].port, 5891);
  EXPECT_NE(opened[0].id, opened[1].id);
}

TEST_F(LinksTest, handsTheEventsOfAConnectionToItsLink) {
  links_.script().start("robot", 5890, now_);
  links_.status().start("robot", 5891, now_);
  const auto opened = take<OpenConnection>();
  ASSERT_EQ(opened.size(), 2U);

  links_.opened(opened[0].id, now_);

  EXPECT_TRUE(links_.script().connected());
  EXPECT_EQ(links_.lateEvents(), 0U);
  const auto sent = take<SendBytes>();
  ASSERT_FALSE(sent.empty());
  EXPECT_EQ(sent.front().id, opened[0].id);

  links_.closed(opened[0].id, "reset by peer", now_);
  EXPECT_FALSE(links_.script().connected());
}

TEST_F(LinksTest, countsWhatComesOfAConnectionThatNobodyOwnsAnyMore) {
  links_.script().start("robot", 5890, now_);
  const auto opened = take<OpenConnection>();
  ASSERT_EQ(opened.size(), 1U);
  const link::ConnectionId gone = opened[0].id + 7;

  links_.opened(gone, now_);
  links_.received(gone, "$TMSCT,4,1,OK,*5C\r\n");
  links_.openFailed(gone, {link::OpenFailure::Kind::Refused, "refused"}, now_);
  links_.closed(gone, "closed", now_);

  EXPECT_EQ(links_.lateEvents(), 4U);
  EXPECT_FALSE(links_.script().connected());
  EXPECT_TRUE(take<SendBytes>().empty());
}

TEST_F(LinksTest, describesNoFrameThatNobodyReads) {
  bool listens = false;
  Links links(settings_, actions_, [&](link::Channel channel) {
    EXPECT_EQ(channel, link::Channel::Script);
    return listens;
  });
  links.script().start("robot", 5890, now_);
  links.opened(take<OpenConnection>().at(0).id, now_);
  EXPECT_TRUE(take<FrameTraced>().empty());

  listens = true;
  links.advance(*links.nextDeadline());
  const auto traced = take<FrameTraced>();
  ASSERT_EQ(traced.size(), 1U);
  EXPECT_FALSE(traced[0].meaning.empty());
}

TEST_F(LinksTest, tellsReceivedFramesAsTheyCame) {
  links_.script().start("robot", 5890, now_);
  const auto id = take<OpenConnection>().at(0).id;
  links_.opened(id, now_);
  take<FrameTraced>();
  const std::string own_way = "$TMSTA,0x9,00,true,L,*58\r\n";
  links_.received(id, own_way + "$TMNOT,0x1,a,*78\r\n");
  while (links_.script().next(now_)) {
  }
  const auto traced = take<FrameTraced>();
  ASSERT_EQ(traced.size(), 2U);
  EXPECT_EQ(traced[0].bytes, own_way);
  EXPECT_EQ(traced[1].bytes, "$TMNOT,0x1,a,*78\r\n");
}

TEST_F(LinksTest, wakesForTheLinkThatIsDueFirst) {
  EXPECT_FALSE(links_.nextDeadline());
  links_.script().start("robot", 5890, now_);
  const auto opened = take<OpenConnection>();
  links_.openFailed(opened.at(0).id, {link::OpenFailure::Kind::Refused, "refused"}, now_);

  ASSERT_TRUE(links_.nextDeadline());
  links_.advance(*links_.nextDeadline());

  EXPECT_EQ(take<OpenConnection>().size(), 1U) << "it tries again";
}

}  // namespace
}  // namespace cobot_command::command
