#include "shared/made_beside.h"

#include <future>
#include <stdexcept>

#include <gtest/gtest.h>

namespace cobot_command::ros_adapter {
namespace {

/// Tells when it is dropped.
struct Told {
  std::promise<void> dropped;
  ~Told() { dropped.set_value(); }
};

class MadeBesideIts : public ::testing::Test {
 protected:
  /// Makes what `let` lets go.
  static MadeBeside<int>::Make made(const std::shared_future<int>& let) {
    return [let] { return std::make_shared<int>(let.get()); };
  }
  static int awaited(const MadeBeside<int>& beside) {
    while (!beside.get()) std::this_thread::yield();
    return *beside.get();
  }

  std::promise<int> first;
  std::promise<int> second;
};

TEST_F(MadeBesideIts, ownerIsNothingUntilItIsMade) {
  MadeBeside<int> beside;
  EXPECT_EQ(beside.get(), nullptr);
  beside.begin(made(first.get_future().share()));
  EXPECT_EQ(beside.get(), nullptr);
  first.set_value(1);
  EXPECT_EQ(awaited(beside), 1);
}

TEST_F(MadeBesideIts, ownerIsWhatWasAskedForLastWhicheverIsMadeFirst) {
  MadeBeside<int> beside;
  beside.set(std::make_shared<int>(0));
  beside.begin(made(first.get_future().share()));
  EXPECT_EQ(beside.get(), nullptr) << "no longer what it was";
  beside.begin(made(second.get_future().share()));
  second.set_value(2);
  EXPECT_EQ(awaited(beside), 2);
  first.set_value(1);
  EXPECT_EQ(awaited(beside), 2);
}

TEST_F(MadeBesideIts, ownerMayBeGoneBeforeItIsMade) {
  std::promise<void> let;
  std::promise<std::shared_future<void>> dropped;
  {
    MadeBeside<Told> beside;
    beside.begin([&] {
      let.get_future().wait();
      auto told = std::make_shared<Told>();
      dropped.set_value(told->dropped.get_future().share());
      return told;
    });
  }
  let.set_value();
  dropped.get_future().get().wait();
}

TEST_F(MadeBesideIts, ownerIsNothingWhereItCannotBeMade) {
  std::promise<void> tried;
  MadeBeside<int> beside;
  beside.begin([&]() -> std::shared_ptr<int> {
    tried.set_value_at_thread_exit();
    throw std::runtime_error("something else of this node has the name");
  });
  tried.get_future().wait();
  EXPECT_EQ(beside.get(), nullptr);
}

}  // namespace
}  // namespace cobot_command::ros_adapter
