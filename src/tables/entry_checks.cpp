#include "entry_checks.h"

#include <cmath>

#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/project_name.h"
#include "cobot_command/common/units.h"

namespace cobot_command::tables {
namespace {

/// [kg mm^2], as the tool of change_tcp.
constexpr double kMaxInertia = 1e9;
constexpr const char* kSixNumbers = "finite numbers of -100000 to 100000 mm and deg";

/// One entry and what stands around it.
class EntryCheck {
 public:
  EntryCheck(Kind kind, int index, const Entries& all, const Payload& payload)
      : kind_(kind), index_(index), all_(all), payload_(payload) {}

  [[nodiscard]] std::optional<Refusal> tool() const;
  [[nodiscard]] std::optional<Refusal> frame() const;
  [[nodiscard]] std::optional<Refusal> load() const;

 private:
  template <class Entry>
  [[nodiscard]] std::optional<Refusal> named(const Entry& entry) const;
  [[nodiscard]] std::optional<Refusal> pose(const char* what, const arm::Pose& pose) const;
  [[nodiscard]] std::optional<Refusal> reference(const Frame& frame) const;
  [[nodiscard]] std::optional<Refusal> referringFrames() const;
  [[nodiscard]] std::optional<Refusal> masses(const Load& load) const;
  [[nodiscard]] std::optional<Refusal> toolsThatWeighIt() const;

  template <class Entry>
  [[nodiscard]] const std::optional<Entry>& at(const Table<Entry>& table, int index) const {
    return table[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] Refusal refused(int error_id, std::string found, std::string allowed,
                                std::string remedy) const {
    return {error_id, kind_, index_, std::move(found), std::move(allowed), std::move(remedy)};
  }

  Kind kind_;
  int index_;
  const Entries& all_;
  const Payload& payload_;
};

template <class Entry>
std::optional<Refusal> EntryCheck::named(const Entry& entry) const {
  const std::string allowed =
      fmt::format("at most {} bytes of UTF-8 without control characters", kLongestProjectName);
  if (entry.name.empty() && !entry.pose) {
    return refused(table_error::kNameInvalid, "it has neither a name nor a pose", allowed + ", or a pose",
                   "Give the name that it has in the controller's project, or six numbers, or both");
  }
  if (!entry.name.empty() && !isProjectName(entry.name)) {
    return refused(
        table_error::kNameInvalid,
        fmt::format("its name is \"{}\", {} bytes", foreignText(entry.name, kQuoteLimit), entry.name.size()),
        allowed, "Give the name as the controller's project has it");
  }
  return entry.pose ? pose("its pose", *entry.pose) : std::nullopt;
}

std::optional<Refusal> EntryCheck::pose(const char* what, const arm::Pose& pose) const {
  if (!pose.matrix().allFinite()) {
    return refused(table_error::kNotFinite, fmt::format("{} has a number that is not finite", what),
                   kSixNumbers, "Give six finite numbers");
  }
  const double farthest = pose.translation().cwiseAbs().maxCoeff();
  if (farthest <= mmToM(arm::kMaxCoordinate)) return std::nullopt;
  return refused(table_error::kCoordinateRange, fmt::format("{} is {} mm away", what, mToMm(farthest)),
                 kSixNumbers, "Give coordinates in that range");
}

std::optional<Refusal> EntryCheck::tool() const {
  const std::optional<Tool>& tool = at(all_.tools, index_);
  if (!tool) return std::nullopt;
  if (auto refusal = named(*tool)) return refusal;
  if (isIndex(tool->load) && at(all_.loads, tool->load)) return std::nullopt;
  return refused(table_error::kLoadIndex,
                 isIndex(tool->load) ? fmt::format("its load {} is not configured", tool->load)
                                     : fmt::format("its load is {}", tool->load),
                 "the number of a load that is configured, or 0 for none", "Write the load before the tool");
}

std::optional<Refusal> EntryCheck::frame() const {
  if (const std::optional<Frame>& frame = at(all_.frames, index_)) {
    if (auto refusal = named(*frame)) return refusal;
    if (auto refusal = reference(*frame)) return refusal;
  }
  return referringFrames();
}

std::optional<Refusal> EntryCheck::reference(const Frame& frame) const {
  if (frame.reference == 0) return std::nullopt;
  const auto invalid = [this](std::string found) {
    return refused(table_error::kReferenceInvalid, std::move(found),
                   "0, the robot base, or the number of another frame that is configured",
                   "Write the reference first, or refer to 0");
  };
  if (!isIndex(frame.reference)) return invalid(fmt::format("its reference is {}", frame.reference));
  if (frame.reference == index_) return invalid("it refers to itself");
  if (!frame.pose) return invalid("it has only a name, and bases of a project are defined in the robot base");
  const std::optional<Frame>& reference = at(all_.frames, frame.reference);
  if (!reference) return invalid(fmt::format("its reference, frame {}, is not configured", frame.reference));
  if (reference->reference == 0) return std::nullopt;
  return refused(
      table_error::kReferenceRefers,
      fmt::format("its reference, frame {}, refers to frame {}", frame.reference, reference->reference),
      "a reference that refers to none", "Refer to a frame that is defined in the robot base");
}

/// Not from the other side either: frames that are refused because of what this one is now.
std::optional<Refusal> EntryCheck::referringFrames() const {
  const std::optional<Frame>& frame = at(all_.frames, index_);
  if (frame && frame->reference == 0) return std::nullopt;
  for (int other = 1; other < kEntryCount; ++other) {
    const std::optional<Frame>& referring = at(all_.frames, other);
    if (other == index_ || !referring || referring->reference != index_) continue;
    if (frame) {
      return refused(table_error::kReferenceRefers,
                     fmt::format("frame {} refers to it, and it to frame {}", other, frame->reference),
                     "one level of reference", fmt::format("Write frame {} first", other));
    }
    return refused(table_error::kReferenceInvalid, fmt::format("frame {} refers to it", other),
                   "to empty a frame to which no frame refers", fmt::format("Write frame {} first", other));
  }
  return std::nullopt;
}

std::optional<Refusal> EntryCheck::load() const {
  const std::optional<Load>& load = at(all_.loads, index_);
  return load ? masses(*load) : toolsThatWeighIt();
}

std::optional<Refusal> EntryCheck::masses(const Load& load) const {
  // Written so that NaN is refused as well.
  if (!(load.mass >= 0 && load.mass <= payload_.mass)) {
    return refused(table_error::kMass, fmt::format("its mass is {} kg", load.mass),
                   fmt::format("0 to {} kg, the payload of {}", payload_.mass, payload_.whose),
                   "Give a mass that the arm can carry");
  }
  for (const double moment : load.inertia) {
    if (moment >= 0 && moment * kMm2PerM2 <= kMaxInertia) continue;
    return refused(table_error::kInertiaRange,
                   fmt::format("a moment of inertia is {} kg mm^2", moment * kMm2PerM2),
                   fmt::format("0 to {:.0f} kg mm^2", kMaxInertia), "Set parameter in acceptable range");
  }
  return pose("the centre of its mass", load.centre);
}

std::optional<Refusal> EntryCheck::toolsThatWeighIt() const {
  for (int other = 1; other < kEntryCount; ++other) {
    const std::optional<Tool>& tool = at(all_.tools, other);
    if (!tool || tool->load != index_) continue;
    return refused(table_error::kLoadIndex, fmt::format("tool {} has this load", other),
                   "to empty a load that no tool has", fmt::format("Write tool {} first", other));
  }
  return std::nullopt;
}

}  // namespace

Result<arm::Pose, NumberFault> poseIn(const arm::ControllerPose& numbers) {
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const double number = numbers[i];
    if (std::abs(number) <= arm::kMaxCoordinate) continue;
    return refuse(NumberFault{std::isfinite(number) ? table_error::kCoordinateRange : table_error::kNotFinite,
                              fmt::format("coordinate {} of the pose is {}", i + 1, number), kSixNumbers});
  }
  return arm::toPose(numbers);
}

std::optional<Refusal> checkIndex(Kind kind, int index) {
  if (isIndex(index) && index != 0) return std::nullopt;
  const int error_id = kind == Kind::Tool    ? table_error::kToolIndex
                       : kind == Kind::Frame ? table_error::kFrameIndex
                                             : table_error::kLoadIndex;
  const char* fixed = kind == Kind::Tool    ? "number 0 is the flange"
                      : kind == Kind::Frame ? "number 0 is the robot base"
                                            : "number 0 is no load";
  return Refusal{error_id,
                 kind,
                 index,
                 index == 0 ? fixed : "there is no such number",
                 fmt::format("1 to {}", kEntryCount - 1),
                 "Give a number of that range"};
}

std::optional<Refusal> checkEntry(Kind kind, int index, const Entries& all, const Payload& payload) {
  const EntryCheck check(kind, index, all, payload);
  return kind == Kind::Tool ? check.tool() : kind == Kind::Frame ? check.frame() : check.load();
}

std::optional<Refusal> checkAll(const Entries& all, const Payload& payload) {
  // Nothing can be wrong with an empty entry that is not with the one that refers to it.
  const auto is_there = [&all](Kind kind, std::size_t i) {
    return kind == Kind::Tool    ? all.tools[i].has_value()
           : kind == Kind::Frame ? all.frames[i].has_value()
                                 : all.loads[i].has_value();
  };
  for (const Kind kind : {Kind::Load, Kind::Tool, Kind::Frame}) {
    for (int index = 1; index < kEntryCount; ++index) {
      if (!is_there(kind, static_cast<std::size_t>(index))) continue;
      if (auto refusal = checkEntry(kind, index, all, payload)) return refusal;
    }
  }
  return std::nullopt;
}

}  // namespace cobot_command::tables
