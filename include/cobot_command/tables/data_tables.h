// The tables of tools, frames and loads as one value: checked, and cheap to copy, also to another thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "cobot_command/arm/arm_model.h"
#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/result.h"
#include "cobot_command/tables/entries.h"
#include "cobot_command/tables/refusal.h"

namespace cobot_command::tables {

/// Largest permitted payload.
struct Payload {
  double mass = 14;                                  ///< [kg]
  std::string whose = "the family's strongest arm";  ///< owner of the limit, for texts
};
[[nodiscard]] Payload payloadOf(const arm::ArmModel& model);

/// Why a number has no pose.
struct Gap {
  enum class Reason {
    OutOfRange,     ///< not a number of 0..15
    NotConfigured,  ///< an empty entry
    ValueUnknown    ///< only its name in the controller's project is known
  };

  Reason reason = Reason::NotConfigured;
  int index = 0;      ///< of the missing entry; may be the reference of the requested frame
  std::string name;   ///< in the project, if the value is unknown
  std::string found;  ///< for messages: "frame 7 is not configured"
};

/// Error of numbers that should be a pose.
struct NumberFault {
  int error_id = 0;
  std::string found;
  std::string allowed;
};
/// Reads x y z [mm] rx ry rz [deg] of a caller. All must be finite and within +-100000.
[[nodiscard]] Result<arm::Pose, NumberFault> poseIn(const arm::ControllerPose& numbers);

class DataTables {
 public:
  DataTables();  ///< only number 0 of each table
  /// Checks all entries together; their order does not matter.
  [[nodiscard]] static Result<DataTables, Refusal> of(Entries entries, const Payload& payload);

  [[nodiscard]] const Entries& entries() const { return *entries_; }

  /// Increases with each change in the TableStore that this is a copy of. A receiver that gets copies over
  /// several paths can determine which is newer.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  void stamp(std::uint64_t revision) { revision_ = revision; }

  [[nodiscard]] Result<arm::Pose, Gap> toolInFlange(int index) const;
  [[nodiscard]] Result<arm::Pose, Gap> frameInRobotBase(int index) const;
  [[nodiscard]] Result<Load, Gap> load(int index) const;

  /// Writes the entry; std::nullopt clears it. On a refusal nothing changes. Number 0 is fixed.
  [[nodiscard]] std::optional<Refusal> writeTool(int index, std::optional<Tool> tool, const Payload& payload);
  [[nodiscard]] std::optional<Refusal> writeFrame(int index, std::optional<Frame> frame,
                                                  const Payload& payload);
  [[nodiscard]] std::optional<Refusal> writeLoad(int index, std::optional<Load> load, const Payload& payload);

  /// Sets the pose from the controller's project, for entries that have this name and no pose of their own.
  void learnTool(std::string_view name, const arm::Pose& in_flange);
  void learnFrame(std::string_view name, const arm::Pose& in_robot_base);

 private:
  explicit DataTables(Entries entries);
  template <class Entry>
  std::optional<Refusal> write(Kind kind, Table<Entry> Entries::*table, int index, std::optional<Entry> entry,
                               const Payload& payload);

  std::shared_ptr<const Entries> entries_;  ///< never modified, only replaced
  std::uint64_t revision_ = 0;
};

}  // namespace cobot_command::tables
