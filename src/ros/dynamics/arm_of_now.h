// The arm with the limits that rule, for who answers beside the core: calculates kinematics, say.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "cobot_command/arm/arm_model.h"

namespace cobot_command::ros_adapter {

/// Thread-safe.
class ArmOfNow {
 public:
  /// As the node begins; nothing: no model is known.
  explicit ArmOfNow(const std::optional<arm::ArmModel>& arm)
      : arm_(arm ? std::make_shared<const arm::ArmModel>(*arm) : nullptr) {}

  /// nullptr: no model is known. What it is asked for stays as it is, whatever comes later.
  [[nodiscard]] std::shared_ptr<const arm::ArmModel> get() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return arm_;
  }
  /// The core plans with it from now on.
  void take(std::shared_ptr<const arm::ArmModel> arm) {
    const std::lock_guard<std::mutex> lock(mutex_);
    arm_ = std::move(arm);
  }

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const arm::ArmModel> arm_;
};

}  // namespace cobot_command::ros_adapter
