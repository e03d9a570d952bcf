// What is kept of messages, and for how long they are pending.
#include "messages/message_board.h"

#include <gtest/gtest.h>

namespace cobot_command::command {
namespace {

Message message(Severity severity, const std::string& text, int code = 1) {
  return {0, {}, severity, MessageType::Command, code, "load_path", text, "", false};
}

std::vector<std::uint32_t> idsOf(const std::vector<Message>& messages) {
  std::vector<std::uint32_t> ids;
  for (const Message& one : messages) ids.push_back(one.id);
  return ids;
}

using Ids = std::vector<std::uint32_t>;

TEST(MessageBoard, numbersWhatIsRaised) {
  MessageBoard board;
  EXPECT_EQ(board.raise(message(Severity::Error, "a"))->id, 1U);
  EXPECT_EQ(board.raise(message(Severity::Info, "b"))->id, 2U);
  EXPECT_EQ(idsOf(board.all(Severity::Off, 0)), Ids({1, 2}));
}

TEST(MessageBoard, tellsACauseOnceAsLongAsItIsPending) {
  MessageBoard board;
  ASSERT_TRUE(board.raise(message(Severity::Error, "a")));
  EXPECT_FALSE(board.raise(message(Severity::Error, "a")));
  EXPECT_TRUE(board.raise(message(Severity::Error, "another text")));
  EXPECT_EQ(board.acknowledge(), 2U);
  EXPECT_TRUE(board.raise(message(Severity::Error, "a")));
}

TEST(MessageBoard, hasErrorsPendingUntilTheyAreAcknowledged) {
  MessageBoard board;
  board.raise(message(Severity::Info, "i"));
  board.raise(message(Severity::Warning, "w"));
  board.raise(message(Severity::Error, "e"));
  board.raise(message(Severity::Fatal, "f"));
  EXPECT_EQ(idsOf(board.pending()), Ids({3, 4}));
  EXPECT_FALSE(board.end("load_path", 1)) << "an error is not over by itself";
  EXPECT_EQ(board.acknowledge(), 2U);
  EXPECT_TRUE(board.pending().empty());
  EXPECT_EQ(board.all(Severity::Off, 0).size(), 4U) << "they are kept";
}

TEST(MessageBoard, hasAWarningThatLastsPendingUntilItsCauseIsGone) {
  MessageBoard board;
  board.raise(message(Severity::Warning, "w", 7), true);
  EXPECT_EQ(board.countPending(Severity::Warning), 1U);
  EXPECT_FALSE(board.end("load_path", 8));
  EXPECT_TRUE(board.end("load_path", 7));
  EXPECT_FALSE(board.end("load_path", 7));
  EXPECT_EQ(board.countPending(Severity::Warning), 0U);
  EXPECT_TRUE(board.raise(message(Severity::Warning, "w", 7), true)) << "it is so again";
}

TEST(MessageBoard, doesNotAcknowledgeWhatIsWrongStill) {
  MessageBoard board;
  board.raise(message(Severity::Error, "a"));
  Message robot = message(Severity::Error, "b");
  robot.type = MessageType::Controller;
  board.raise(robot);
  EXPECT_EQ(board.acknowledge({MessageType::Controller}), 1U);
  EXPECT_EQ(idsOf(board.pending()), Ids({2}));
}

TEST(MessageBoard, keepsTheLastHundred) {
  MessageBoard board;
  for (int i = 0; i < 130; ++i) board.raise(message(Severity::Error, std::to_string(i)));
  const auto all = board.all(Severity::Off, 0);
  EXPECT_EQ(all.size(), MessageBoard::kMost);
  EXPECT_EQ(all.front().id, 31U);
  EXPECT_EQ(board.pending().size(), MessageBoard::kMost);
}

TEST(MessageBoard, readsFromASeverityAndAnIdOn) {
  MessageBoard board;
  for (const Severity severity : {Severity::Info, Severity::Error, Severity::Warning, Severity::Fatal}) {
    board.raise(message(severity, toString(severity)));
  }
  EXPECT_EQ(idsOf(board.all(Severity::Warning, 0)), Ids({2, 3, 4}));
  EXPECT_EQ(idsOf(board.all(Severity::Warning, 2)), Ids({3, 4}));
  EXPECT_TRUE(board.all(Severity::Off, 4).empty());
}

TEST(MessageBoard, keepsNothingBelowItsLevel) {
  MessageBoard board;
  board.keep(Severity::Error);
  EXPECT_FALSE(board.raise(message(Severity::Warning, "w")));
  EXPECT_TRUE(board.raise(message(Severity::Error, "e")));
  board.keep(Severity::Off);
  EXPECT_FALSE(board.raise(message(Severity::Fatal, "f")));
}

}  // namespace
}  // namespace cobot_command::command
