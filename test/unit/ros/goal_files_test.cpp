// Threads, but no waiting: what is read is released by the test.
#include "cobot_command/ros/command/goal_files.h"

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <stdexcept>
#include <thread>
#include <utility>

#include <gmock/gmock.h>

namespace cobot_command::ros_adapter {
namespace {

using ::testing::HasSubstr;

constexpr auto kDeadline = std::chrono::seconds(30);

/// The answer, as soon as it is there.
std::optional<StepsAnswer> awaited(GoalFiles& files, blocks::GoalId id, const std::string& location) {
  const auto give_up = std::chrono::steady_clock::now() + kDeadline;
  while (std::chrono::steady_clock::now() < give_up) {
    if (auto answer = files.find(id, FileKind::Steps, location)) return std::get<StepsAnswer>(*answer);
    std::this_thread::yield();
  }
  return std::nullopt;
}

/// Reads that hang until they are released.
struct Hanging {
  std::promise<void> promise;
  std::shared_future<void> released = promise.get_future().share();
  std::shared_ptr<std::atomic<int>> count = std::make_shared<std::atomic<int>>(0);  ///< that have begun
  GoalFiles files{[released = released, count = count](FileKind, const std::string& location) -> FileAnswer {
    ++*count;
    if (location == "hangs") released.wait();
    return StepsAnswer(std::vector<blocks::PickAndPlaceStep>(location.size()));
  }};
  [[nodiscard]] bool haveBegun(int number) const {
    const auto give_up = std::chrono::steady_clock::now() + kDeadline;
    while (*count < number && std::chrono::steady_clock::now() < give_up) std::this_thread::yield();
    return *count == number;
  }
  void release() {
    if (!std::exchange(is_released, true)) promise.set_value();
  }
  ~Hanging() { release(); }
  bool is_released = false;
};

TEST(GoalFiles, areReadBesideWhoAsks) {
  Hanging hanging;
  EXPECT_FALSE(hanging.files.find(1, FileKind::Steps, "hangs").has_value());
  const auto answer = awaited(hanging.files, 2, "abc");
  ASSERT_TRUE(answer && *answer);
  EXPECT_EQ((*answer)->size(), 3U);
  EXPECT_FALSE(hanging.files.find(1, FileKind::Steps, "hangs").has_value());
}

TEST(GoalFiles, areReadByTheirKind) {
  GoalFiles files([](FileKind kind, const std::string&) -> FileAnswer {
    if (kind == FileKind::Points) return PointsAnswer(std::vector<path::PathPoint>(3));
    return StepsAnswer();
  });
  const auto give_up = std::chrono::steady_clock::now() + kDeadline;
  std::optional<FileAnswer> answer;
  while (!answer && std::chrono::steady_clock::now() < give_up) answer = files.find(1, FileKind::Points, "a");
  ASSERT_TRUE(answer);
  EXPECT_EQ(std::get<PointsAnswer>(*answer)->size(), 3U);
}

TEST(GoalFiles, areReadOnceForAGoalUntilItForgetsThem) {
  std::atomic<int> reads{0};
  GoalFiles files([&](FileKind, const std::string&) -> FileAnswer {
    ++reads;
    return StepsAnswer(refuse(std::string("nothing")));
  });
  ASSERT_TRUE(awaited(files, 1, "a"));
  ASSERT_TRUE(awaited(files, 1, "a"));
  EXPECT_EQ(reads, 1);
  files.forget(1);
  ASSERT_TRUE(awaited(files, 1, "a"));
  EXPECT_EQ(reads, 2);
}

TEST(GoalFiles, ofOneMomentAreAllRead) {
  GoalFiles files([](FileKind, const std::string& location) -> FileAnswer {
    return StepsAnswer(std::vector<blocks::PickAndPlaceStep>(location.size()));
  });
  constexpr blocks::GoalId kMany = 200;
  for (blocks::GoalId id = 1; id <= kMany; ++id) static_cast<void>(files.find(id, FileKind::Steps, "abc"));
  for (blocks::GoalId id = 1; id <= kMany; ++id) {
    const auto answer = awaited(files, id, "abc");
    ASSERT_TRUE(answer && *answer) << "of goal " << id;
    EXPECT_EQ((*answer)->size(), 3U);
  }
}

/// Files that hang, one for each reader, all of which have begun.
struct AllHang {
  Hanging hanging;
  AllHang() {
    for (blocks::GoalId id = 1; id <= GoalFiles::kReaders; ++id) {
      EXPECT_FALSE(hanging.files.find(id, FileKind::Steps, "hangs").has_value());
    }
    EXPECT_TRUE(hanging.haveBegun(GoalFiles::kReaders));
    for (blocks::GoalId id = 1; id <= GoalFiles::kReaders; ++id) hanging.files.forget(id);  // it goes on
  }
};

TEST(GoalFiles, beyondABoundAreRefused) {
  AllHang all;
  GoalFiles& files = all.hanging.files;
  constexpr auto kFirst = static_cast<blocks::GoalId>(GoalFiles::kReaders) + 1;
  constexpr auto kLast = kFirst + static_cast<blocks::GoalId>(GoalFiles::kMostWaiting) - 1;
  for (blocks::GoalId id = kFirst; id <= kLast; ++id) {
    ASSERT_FALSE(files.find(id, FileKind::Steps, "abc").has_value());
  }
  const auto found = files.find(kLast + 1, FileKind::Steps, "abc");
  ASSERT_TRUE(found);
  const auto& answer = std::get<StepsAnswer>(*found);
  ASSERT_FALSE(answer);
  EXPECT_THAT(answer.error(),
              HasSubstr("abc: 1000 files are already waiting to be read; send the goal again"));
  files.forget(kFirst);
  EXPECT_FALSE(files.find(kLast + 2, FileKind::Steps, "abc").has_value()) << "there is a place again";
}

TEST(GoalFiles, thatNobodyNeedsAnyMoreAreNotRead) {
  AllHang all;
  GoalFiles& files = all.hanging.files;
  EXPECT_FALSE(files.find(100, FileKind::Steps, "never").has_value());
  files.forget(100);
  EXPECT_FALSE(files.find(101, FileKind::Steps, "abc").has_value());
  all.hanging.release();
  ASSERT_TRUE(awaited(files, 101, "abc"));
  EXPECT_TRUE(all.hanging.haveBegun(GoalFiles::kReaders + 1));
}

TEST(GoalFiles, thatMakeALibraryThrowEndThisGoalOnly) {
  GoalFiles files(
      [](FileKind, const std::string&) -> FileAnswer { throw std::runtime_error("out of its depth"); });
  const auto answer = awaited(files, 1, "odd.yaml");
  ASSERT_TRUE(answer && !*answer);
  EXPECT_THAT(answer->error(), HasSubstr("odd.yaml: it cannot be read: out of its depth"));
}

TEST(GoalFiles, mayBeLeftBehind) {
  std::promise<void> begun;
  std::promise<void> promise;
  std::promise<void> done;
  {
    GoalFiles files(
        [released = promise.get_future().share(), &begun, &done](FileKind, const std::string&) -> FileAnswer {
          begun.set_value();
          released.wait();
          done.set_value();
          return StepsAnswer(refuse(std::string("late")));
        });
    EXPECT_FALSE(files.find(1, FileKind::Steps, "hangs").has_value());
    ASSERT_EQ(begun.get_future().wait_for(kDeadline), std::future_status::ready);
  }
  promise.set_value();
  EXPECT_EQ(done.get_future().wait_for(kDeadline), std::future_status::ready);
}

}  // namespace
}  // namespace cobot_command::ros_adapter
