#include "sync/table_comparison.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/overloaded.h"
#include "cobot_command/common/units.h"
#include "cobot_command/robot/same_values.h"

namespace cobot_command::command {
namespace {

using tables::Kind;

bool isSamePose(const arm::Pose& a, const arm::Pose& b) {
  const arm::Pose apart(a.inverse() * b);
  const bool is_place = (a.translation() - b.translation()).cwiseAbs().maxCoeff() <= robot::same::kPlace;
  return is_place && Eigen::AngleAxisd(apart.linear()).angle() <= robot::same::kAngle;
}

bool isSameLoad(const tables::Load& a, const tables::Load& b) {
  bool is_same = std::abs(a.mass - b.mass) <= robot::same::kMass && isSamePose(a.centre, b.centre);
  for (std::size_t i = 0; i < a.inertia.size(); ++i) {
    is_same = is_same && std::abs(a.inertia[i] - b.inertia[i]) <= robot::same::kInertia;
  }
  return is_same;
}

template <class Values>
std::optional<EntryValue> find(const Values& values, const std::string& name) {
  const auto found = values.find(name);
  return found == values.end() ? std::nullopt : std::optional<EntryValue>(found->second);
}

void addTools(std::vector<ComparedEntry>& compared, const tables::DataTables& ours,
              const ProjectValues& theirs) {
  for (int i = 1; i < tables::kEntryCount; ++i) {
    const auto& tool = ours.entries().tools[static_cast<std::size_t>(i)];
    if (!tool || tool->name.empty()) continue;
    ComparedEntry entry{Kind::Tool, i, {}, {{tool->name, find(theirs.tcps, tool->name)}}};
    if (tool->pose) entry.own = entry.ours = *tool->pose;
    compared.push_back(std::move(entry));
  }
}

void addFrames(std::vector<ComparedEntry>& compared, const tables::DataTables& ours,
               const ProjectValues& theirs, bool refers) {
  for (int i = 1; i < tables::kEntryCount; ++i) {
    const auto& frame = ours.entries().frames[static_cast<std::size_t>(i)];
    if (!frame || frame->name.empty() || (frame->reference != 0) != refers) continue;
    ComparedEntry entry{Kind::Frame, i, {}, {{frame->name, find(theirs.bases, frame->name)}}};
    if (frame->pose) entry.own = *frame->pose;
    if (const auto pose = ours.frameInRobotBase(i)) entry.ours = *pose;
    compared.push_back(std::move(entry));
  }
}

/// With the centre in the flange.
std::optional<EntryValue> burdenOf(const tables::Tool& tool, const ProjectValues& theirs) {
  const auto found = theirs.burdens.find(tool.name);
  const auto tcp = tcpOf(tool, theirs);
  if (found == theirs.burdens.end() || !tcp) return std::nullopt;
  tables::Load load = found->second;
  load.centre = arm::Pose(*tcp * load.centre);
  return load;
}

void addLoads(std::vector<ComparedEntry>& compared, const tables::DataTables& ours,
              const ProjectValues& theirs) {
  for (int i = 1; i < tables::kEntryCount; ++i) {
    const auto& load = ours.entries().loads[static_cast<std::size_t>(i)];
    if (!load) continue;
    ComparedEntry entry{Kind::Load, i, EntryValue(*load), {}};
    entry.own = entry.ours;
    for (const auto& tool : ours.entries().tools) {
      if (!tool || tool->name.empty() || tool->load != i) continue;
      entry.theirs.push_back({tool->name, burdenOf(*tool, theirs)});
    }
    if (!entry.theirs.empty()) compared.push_back(std::move(entry));
  }
}

bool shareAName(const ComparedEntry& a, const ComparedEntry& b) {
  return std::any_of(a.theirs.begin(), a.theirs.end(), [&b](const NamedValue& of_a) {
    return std::any_of(b.theirs.begin(), b.theirs.end(),
                       [&of_a](const NamedValue& of_b) { return of_a.name == of_b.name; });
  });
}

/// The project has one value for a name.
void noteTwins(std::vector<ComparedEntry>& compared) {
  for (ComparedEntry& entry : compared) {
    for (const ComparedEntry& other : compared) {
      const bool is_twin = &entry != &other && entry.kind == other.kind && shareAName(entry, other);
      const bool differs = is_twin && entry.ours && other.ours && !isSame(*entry.ours, *other.ours);
      if (differs) entry.also_named = fmt::format("{} {}", toString(other.kind), other.index);
    }
  }
}

std::string textOf(const arm::Pose& pose) {
  const arm::ControllerPose six = arm::toControllerPose(pose);
  return fmt::format("{:.6g},{:.6g},{:.6g},{:.6g},{:.6g},{:.6g}", six[0], six[1], six[2], six[3], six[4],
                     six[5]);
}

}  // namespace

bool isSame(const EntryValue& a, const EntryValue& b) {
  return std::visit(Overloaded{[](const arm::Pose& x, const arm::Pose& y) { return isSamePose(x, y); },
                               [](const tables::Load& x, const tables::Load& y) { return isSameLoad(x, y); },
                               [](const auto&, const auto&) { return false; }},
                    a, b);
}

std::string describe(const EntryValue& value) {
  return std::visit(Overloaded{[](const arm::Pose& pose) { return textOf(pose); },
                               [](const tables::Load& load) {
                                 return fmt::format("{:.6g} kg with {:.6g},{:.6g},{:.6g} kg mm^2 about {}",
                                                    load.mass, load.inertia[0] * kMm2PerM2,
                                                    load.inertia[1] * kMm2PerM2, load.inertia[2] * kMm2PerM2,
                                                    textOf(load.centre));
                               }},
                    value);
}

bool ComparedEntry::isInSync() const {
  return also_named.empty() && std::all_of(theirs.begin(), theirs.end(), [this](const NamedValue& named) {
           return named.value && (!ours || isSame(*ours, *named.value));
         });
}

bool ComparedEntry::isRead() const {
  return std::all_of(theirs.begin(), theirs.end(),
                     [](const NamedValue& named) { return named.value.has_value(); });
}

std::optional<EntryValue> ComparedEntry::theirValue() const {
  const bool agree = std::all_of(theirs.begin(), theirs.end(), [this](const NamedValue& named) {
    return named.value && theirs.front().value && isSame(*named.value, *theirs.front().value);
  });
  return agree && !theirs.empty() ? theirs.front().value : std::nullopt;
}

std::string ComparedEntry::difference() const {
  for (const auto& [name, value] : theirs) {
    const std::string who =
        fmt::format("{} {} \"{}\"", toString(kind), index, foreignText(name, kQuoteLimit));
    if (!value) return who + " cannot be read";
    if (!also_named.empty()) return fmt::format("{} has the name of {}, and another value", who, also_named);
    if (ours && !isSame(*ours, *value)) {
      return fmt::format("{} is {} on the controller, {} here", who, describe(*value), describe(*ours));
    }
  }
  return "";
}

std::optional<arm::Pose> tcpOf(const tables::Tool& tool, const ProjectValues& theirs) {
  if (tool.pose) return tool.pose;
  const auto found = theirs.tcps.find(tool.name);
  return found == theirs.tcps.end() ? std::nullopt : std::optional(found->second);
}

std::vector<ComparedEntry> compare(const tables::DataTables& ours, const ProjectValues& theirs) {
  std::vector<ComparedEntry> compared;
  addTools(compared, ours, theirs);
  addFrames(compared, ours, theirs, /*refers=*/false);
  addFrames(compared, ours, theirs, /*refers=*/true);
  addLoads(compared, ours, theirs);
  noteTwins(compared);
  return compared;
}

}  // namespace cobot_command::command
