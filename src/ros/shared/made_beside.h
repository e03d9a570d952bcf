// A publisher, a subscriber or a client that is made while its owner goes on: making one asks the ROS master,
// which may take its time, or hang.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include <ros/console.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {

/// So many are being made in this process. Meanwhile a thread may hold roscpp's lock on all subscriptions:
/// who asks one of them whether it is connected, as an action client does, waits for the master as well.
inline std::atomic<int> being_made{0};

/// Its functions are for one thread.
template <class T>
class MadeBeside {
 public:
  using Make = std::function<std::shared_ptr<T>()>;

  /// From now on it is that.
  void set(std::shared_ptr<T> made) { place_ = std::make_shared<Place>(std::move(made)); }

  /// A thread makes what it will be; until then it is nothing. What it was is dropped behind that, when the
  /// master answers: dropping asks it as well, with roscpp's locks held. `make` must not need what may be
  /// gone before: the master is not waited for, and what comes of it then is dropped.
  void begin(Make make) {
    auto before = std::exchange(place_, std::make_shared<Place>());
    std::thread([before = std::move(before), place = std::weak_ptr<Place>(place_),
                 make = std::move(make)]() mutable {
      ++being_made;
      auto made = madeBy(make);
      if (const auto open = place.lock(); open && made) open->put(std::move(made));
      made.reset();
      before.reset();
      --being_made;
    }).detach();
  }

  void drop() { place_.reset(); }

  /// nullptr: nothing was asked for, or not made yet, or could not be made, which was logged.
  [[nodiscard]] std::shared_ptr<T> get() const { return place_ ? place_->get() : nullptr; }

 private:
  class Place {
   public:
    Place() = default;
    explicit Place(std::shared_ptr<T> made) : made_(std::move(made)) {}
    void put(std::shared_ptr<T> made) {
      const std::lock_guard<std::mutex> lock(mutex_);
      made_ = std::move(made);
    }
    std::shared_ptr<T> get() {
      const std::lock_guard<std::mutex> lock(mutex_);
      return made_;
    }

   private:
    std::mutex mutex_;
    std::shared_ptr<T> made_;
  };

  static std::shared_ptr<T> madeBy(const Make& make) {
    try {
      return make();
    } catch (const std::exception& fault) {
      ROS_ERROR_STREAM(forPeople(fault.what()));
      return nullptr;
    }
  }

  std::shared_ptr<Place> place_;
};

}  // namespace cobot_command::ros_adapter
