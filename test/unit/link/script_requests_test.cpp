#include "cobot_command/link/script_requests.h"

#include <gtest/gtest.h>

namespace cobot_command::link {
namespace {

using namespace std::chrono_literals;
using protocol::CommunicationError;
using protocol::CommunicationErrorCode;
using protocol::TagState;

constexpr Instant kNow{1s};

template <class What>
std::optional<What> as(const std::optional<ScriptAnswer>& answer) {
  const auto* what = answer ? std::get_if<What>(&*answer) : nullptr;
  return what == nullptr ? std::nullopt : std::optional(*what);
}

class ScriptRequestsTest : public ::testing::Test {
 protected:
  void ask(Request::Kind kind, const std::string& id = "", int tag = 0) {
    Request request;
    request.kind = kind;
    request.script_id = id;
    request.tag = tag;
    request.handed_over = kNow;
    request.patience = 1s;
    requests_.add(std::move(request));
  }
  void askForNode() { ask(Request::Kind::NodeQuery); }
  void askForTag(int tag) { ask(Request::Kind::TagQuery, "", tag); }
  void sendScript(const std::string& id) { ask(Request::Kind::Script, id); }

  ScriptRequests requests_;
};

TEST_F(ScriptRequestsTest, tellTheReplyOfAScriptThatWasSent) {
  sendScript("7");
  EXPECT_EQ(requests_.take(protocol::ScriptReply{"8", true, {}}), std::nullopt);
  EXPECT_EQ(requests_.late(), 1U);
  const auto answered = as<ScriptAnswered>(requests_.take(protocol::ScriptReply{"7", true, {}}));
  ASSERT_TRUE(answered);
  EXPECT_EQ(answered->id, "7");
  EXPECT_TRUE(std::get<protocol::ScriptReply>(answered->answer).accepted);
  EXPECT_EQ(requests_.take(protocol::ScriptReply{"7", true, {}}), std::nullopt) << "a second time";
  EXPECT_EQ(requests_.late(), 2U);
}

TEST_F(ScriptRequestsTest, tellWhetherATagWasAskedFor) {
  askForTag(3);
  EXPECT_TRUE(as<TagReported>(requests_.take(protocol::TagReport{3, TagState::Incomplete}))->asked);
  EXPECT_FALSE(as<TagReported>(requests_.take(protocol::TagReport{3, TagState::Complete}))->asked);
  EXPECT_EQ(requests_.late(), 0U);
}

TEST_F(ScriptRequestsTest, takeALateTagForTrueOnlyWhenItIsComplete) {
  for (const TagState state : {TagState::Incomplete, TagState::Complete}) {
    askForTag(3);
    ASSERT_EQ(requests_.takeExpired(kNow), std::nullopt);
    const auto failed = as<TagQueryFailed>(requests_.takeExpired(kNow + 1s));
    ASSERT_TRUE(failed);
    EXPECT_EQ(failed->tag, 3);
    EXPECT_EQ(requests_.take(protocol::TagReport{3, state}).has_value(), state == TagState::Complete);
  }
  EXPECT_EQ(requests_.late(), 1U);
}

TEST_F(ScriptRequestsTest, tellOfAScriptWithoutAReply) {
  sendScript("7");
  ASSERT_EQ(requests_.takeExpired(kNow), std::nullopt);
  const auto answered = as<ScriptAnswered>(requests_.takeExpired(kNow + 1s));
  ASSERT_TRUE(answered);
  EXPECT_TRUE(std::holds_alternative<NoReply>(answered->answer));
  EXPECT_EQ(requests_.nextDeadline(), std::nullopt);
}

TEST_F(ScriptRequestsTest, takeAnErrorForTheOldestAndF1ForTheOldestScript) {
  askForTag(3);
  sendScript("7");
  sendScript("8");
  EXPECT_EQ(as<ScriptAnswered>(requests_.take(CommunicationError{CommunicationErrorCode::NotListening}))->id,
            "7");
  EXPECT_EQ(as<TagQueryFailed>(requests_.take(CommunicationError{CommunicationErrorCode::Data}))->tag, 3);
  EXPECT_EQ(as<ScriptAnswered>(requests_.take(CommunicationError{CommunicationErrorCode::Data}))->id, "8");
  EXPECT_EQ(requests_.take(CommunicationError{CommunicationErrorCode::Data}), std::nullopt);
  EXPECT_EQ(requests_.late(), 1U);
}

TEST_F(ScriptRequestsTest, tellNothingOfAnErrorThatAnswersTheQuestionForTheNode) {
  askForNode();
  EXPECT_EQ(requests_.take(CommunicationError{CommunicationErrorCode::Data}), std::nullopt);
  EXPECT_EQ(requests_.late(), 0U) << "it was awaited";
}

TEST_F(ScriptRequestsTest, countAnAnswerForTheNodeThatNobodyAskedFor) {
  askForNode();
  askForNode();
  EXPECT_TRUE(requests_.takeNodeState());
  requests_.dropNodeQueries();
  EXPECT_FALSE(requests_.takeNodeState());
  EXPECT_EQ(requests_.late(), 1U);
}

}  // namespace
}  // namespace cobot_command::link
