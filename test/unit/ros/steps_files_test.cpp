// Threads, but no waiting: what is read is released by the test.
#include "cobot_command/ros/steps_files.h"

#include <atomic>
#include <chrono>
#include <future>
#include <stdexcept>
#include <thread>

#include <gmock/gmock.h>

namespace cobot_command::ros_adapter {
namespace {

using testing::HasSubstr;

constexpr auto kDeadline = std::chrono::seconds(30);

/// The answer, as soon as it is there.
std::optional<StepsAnswer> awaited(StepsFiles& files, blocks::GoalId id, const std::string& location) {
  const auto give_up = std::chrono::steady_clock::now() + kDeadline;
  while (std::chrono::steady_clock::now() < give_up) {
    if (auto answer = files.find(id, location)) return answer;
    std::this_thread::yield();
  }
  return std::nullopt;
}

/// Reads that hang until they are released.
struct Hanging {
  std::promise<void> promise;
  std::shared_future<void> released = promise.get_future().share();
  StepsFiles files{[released = released](const std::string& location) -> StepsAnswer {
    if (location == "hangs") released.wait();
    return StepsAnswer(std::vector<blocks::PickAndPlaceStep>(location.size()));
  }};
  ~Hanging() { promise.set_value(); }
};

TEST(StepsFiles, areReadBesideWhoAsks) {
  Hanging hanging;
  EXPECT_FALSE(hanging.files.find(1, "hangs").has_value());
  const auto answer = awaited(hanging.files, 2, "abc");
  ASSERT_TRUE(answer && *answer);
  EXPECT_EQ((*answer)->size(), 3U);
  EXPECT_FALSE(hanging.files.find(1, "hangs").has_value());
}

TEST(StepsFiles, areReadOnceForAGoalUntilItForgetsThem) {
  std::atomic<int> reads{0};
  StepsFiles files([&](const std::string&) -> StepsAnswer {
    ++reads;
    return refuse(std::string("nothing"));
  });
  ASSERT_TRUE(awaited(files, 1, "a"));
  ASSERT_TRUE(awaited(files, 1, "a"));
  EXPECT_EQ(reads, 1);
  files.forget(1);
  ASSERT_TRUE(awaited(files, 1, "a"));
  EXPECT_EQ(reads, 2);
}

TEST(StepsFiles, thatDoNotComeToTheirEndAreNotReadWithoutNumber) {
  Hanging hanging;
  for (blocks::GoalId id = 1; id <= 4; ++id) {
    EXPECT_FALSE(hanging.files.find(id, "hangs").has_value());
    hanging.files.forget(id);  // cancelled; the reading goes on
  }
  const auto answer = hanging.files.find(5, "abc");
  ASSERT_TRUE(answer && !*answer);
  EXPECT_THAT(answer->error(), HasSubstr("abc: 4 other files are being read"));
}

TEST(StepsFiles, thatMakeALibraryThrowEndThisGoalOnly) {
  StepsFiles files([](const std::string&) -> StepsAnswer { throw std::runtime_error("out of its depth"); });
  const auto answer = awaited(files, 1, "odd.yaml");
  ASSERT_TRUE(answer && !*answer);
  EXPECT_THAT(answer->error(), HasSubstr("odd.yaml: it cannot be read: out of its depth"));
}

TEST(StepsFiles, mayBeLeftBehind) {
  std::promise<void> promise;
  std::promise<void> done;
  {
    StepsFiles files([released = promise.get_future().share(), &done](const std::string&) -> StepsAnswer {
      released.wait();
      done.set_value();
      return refuse(std::string("late"));
    });
    EXPECT_FALSE(files.find(1, "hangs").has_value());
  }
  promise.set_value();
  EXPECT_EQ(done.get_future().wait_for(kDeadline), std::future_status::ready);
}

}  // namespace
}  // namespace cobot_command::ros_adapter
