// The tables of tools, frames and loads as one value: checked, and cheap to copy, also into another thread.
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

/// What may be carried at most.
struct Payload {
  double mass = 14;                                  ///< [kg]
  std::string whose = "the family's strongest arm";  ///< for texts
};
[[nodiscard]] Payload payloadOf(const arm::ArmModel& model);

/// Why there is no pose of that number.
struct Gap {
  enum class Reason {
    OutOfRange,     ///< no number of 0..15
    NotConfigured,  ///< an empty entry
    ValueUnknown    ///< only its name in the controller's project is known
  };

  Reason reason = Reason::NotConfigured;
  int index = 0;      ///< of the entry that it lacks: it may be the reference of the one that was asked for
  std::string name;   ///< in the project; where the value is unknown
  std::string found;  ///< for people: "frame 7 is not configured"
};

/// What is wrong with numbers that should be a pose.
struct NumberFault {
  int error_id = 0;
  std::string found;
  std::string allowed;
};
/// x y z [mm] rx ry rz [deg] of a caller, when all are finite and none is beyond +-100000.
[[nodiscard]] Result<arm::Pose, NumberFault> poseIn(const arm::ControllerPose& numbers);

class DataTables {
 public:
  DataTables();  ///< only number 0 of each
  /// All of them, checked together: the order of the entries means nothing.
  [[nodiscard]] static Result<DataTables, Refusal> of(Entries entries, const Payload& payload);

  [[nodiscard]] const Entries& entries() const { return *entries_; }

  /// Higher with each change of the tables that this is a copy of (TableStore); who gets them on several ways
  /// sees by it which are newer.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  void stamp(std::uint64_t revision) { revision_ = revision; }

  [[nodiscard]] Result<arm::Pose, Gap> toolInFlange(int index) const;
  [[nodiscard]] Result<arm::Pose, Gap> frameInRobotBase(int index) const;
  [[nodiscard]] Result<Load, Gap> load(int index) const;

  /// Each takes the entry, nothing for an empty one, or says why not and changes nothing. Number 0 is fixed.
  [[nodiscard]] std::optional<Refusal> writeTool(int index, std::optional<Tool> tool, const Payload& payload);
  [[nodiscard]] std::optional<Refusal> writeFrame(int index, std::optional<Frame> frame,
                                                  const Payload& payload);
  [[nodiscard]] std::optional<Refusal> writeLoad(int index, std::optional<Load> load, const Payload& payload);

  /// What the controller's project has under that name; for entries that have the name and no value of their
  /// own.
  void learnTool(std::string_view name, const arm::Pose& in_flange);
  void learnFrame(std::string_view name, const arm::Pose& in_robot_base);

 private:
  explicit DataTables(Entries entries);
  template <class Entry>
  std::optional<Refusal> write(Kind kind, Table<Entry> Entries::*table, int index, std::optional<Entry> entry,
                               const Payload& payload);

  std::shared_ptr<const Entries> entries_;  ///< never changed, only replaced
  std::uint64_t revision_ = 0;
};

}  // namespace cobot_command::tables
