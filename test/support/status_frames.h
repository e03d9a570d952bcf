// Frames of a status stream, made by saying what is unusual in them.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "whole_stream.h"

#include "cobot_command/protocol/status_items.h"

namespace cobot_command::testing {

/// A robot that stands at J = 0 0 90 0 90 0 degrees, without errors, its project running.
class StatusFrames {
 public:
  StatusFrames() {
    namespace item = protocol::item;
    items_ = {item::ofByte("Robot_Link", 1),
              item::ofBool("Robot_Error", false),
              item::ofBool("Project_Run", true),
              item::ofBool("Project_Pause", false),
              item::ofBool("Safeguard_A", false),
              item::ofBool("ESTOP", false),
              item::ofInt("Error_Code", 0),
              item::ofInt("Project_Speed", 100),
              item::ofFloats("Joint_Angle", {0, 0, 90, 0, 90, 0}),
              item::ofFloats("Joint_Speed", {0, 0, 0, 0, 0, 0})};
  }

  /// With all that every data table should have.
  StatusFrames& whole() {
    for (auto& item : wholeStream()) {
      const bool is_there = std::any_of(items_.begin(), items_.end(),
                                        [&](const auto& known) { return known.name == item.name; });
      if (!is_there) items_.push_back(std::move(item));
    }
    return *this;
  }
  StatusFrames& with(protocol::StatusItem item) {
    for (auto& known : items_) {
      if (known.name == item.name) {
        known = std::move(item);
        return *this;
      }
    }
    items_.push_back(std::move(item));
    return *this;
  }
  StatusFrames& without(const std::string& name) {
    std::vector<protocol::StatusItem> kept;
    for (auto& item : items_) {
      if (item.name != name) kept.push_back(std::move(item));
    }
    items_ = std::move(kept);
    return *this;
  }
  StatusFrames& at(const std::vector<float>& joints_deg) {
    return with(protocol::item::ofFloats("Joint_Angle", joints_deg));
  }
  StatusFrames& moving() { return with(protocol::item::ofFloats("Joint_Speed", {0, 5, -20, 0, 0, 0})); }
  StatusFrames& input(const std::string& name, bool on) {
    return with(protocol::item::ofByte(name, on ? 1 : 0));
  }
  StatusFrames& paused() { return with(protocol::item::ofBool("Project_Pause", true)); }
  StatusFrames& emergencyStop() { return with(protocol::item::ofBool("ESTOP", true)); }
  StatusFrames& error(int code, const std::string& text) {
    return with(protocol::item::ofBool("Robot_Error", true))
        .with(protocol::item::ofInt("Error_Code", code))
        .with(protocol::item::ofString("Error_Content", text));
  }

  operator const std::vector<protocol::StatusItem>&() const { return items_; }  // NOLINT: meant to convert

 private:
  std::vector<protocol::StatusItem> items_;
};

}  // namespace cobot_command::testing
