// Allocations that are counted, and one of them fails: this program's operator new is our own.
//
// Only those of `during` count, so that the test itself always has memory. What does not go through operator
// new (Eigen's matrices of unknown size) is not seen.
#pragma once

#include <functional>
#include <new>
#include <string>

#include "thorough.h"
#include <gtest/gtest.h>

namespace cobot_command::allocation {

class FailingAllocation {
 public:
  /// The n-th allocation, from 1, throws std::bad_alloc. One at a time in the program.
  explicit FailingAllocation(long n);
  ~FailingAllocation();
  FailingAllocation(const FailingAllocation&) = delete;
  FailingAllocation& operator=(const FailingAllocation&) = delete;

  template <class Call>
  auto during(const Call& call) const {
    const Counting counting;
    return call();
  }
  [[nodiscard]] bool happened() const;

 private:
  struct Counting {
    Counting();
    ~Counting();
    Counting(const Counting&) = delete;
    Counting& operator=(const Counting&) = delete;
  };
};

/// What was allocated and not yet given back.
[[nodiscard]] long liveAllocations();

/// Tells the story again and again, each time with another allocation that fails, until none fails any more.
/// Each failure comes out of the story as std::bad_alloc, and leaves nothing behind. When watched, every
/// tenth allocation fails.
inline void failEachAllocationOf(const std::function<void(const FailingAllocation&)>& story) {
  story(FailingAllocation(0));  // what is made once and kept for ever is there now
  const auto stride = static_cast<long>(testing::strideWhenWatched());
  long failures = 0;
  for (long n = 1;; n += stride) {
    const long before = liveAllocations();
    bool happened = false;
    bool thrown = false;
    {
      const FailingAllocation failing(n);
      try {
        story(failing);
      } catch (const std::bad_alloc&) {
        thrown = true;
      }
      happened = failing.happened();
    }
    ASSERT_EQ(thrown, happened) << "allocation " << n << " was swallowed";
    ASSERT_EQ(liveAllocations(), before) << "allocation " << n << " left something behind";
    if (!happened) {
      break;
    }
    ++failures;
  }
  ::testing::Test::RecordProperty("failed_allocations", std::to_string(failures));
  EXPECT_GT(failures * stride, 100) << "the story is too short to tell anything";
}

}  // namespace cobot_command::allocation
