#include "cobot_command/tables/data_tables.h"

#include <utility>

#include "entry_checks.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::tables {
namespace {

template <class Entry>
Result<Entry, Gap> found(Kind kind, const Table<Entry>& table, int index) {
  if (!isIndex(index)) {
    return refuse(
        Gap{Gap::Reason::OutOfRange, index, "",
            fmt::format("there is no {} {}; allowed: 0 to {}", toString(kind), index, kEntryCount - 1)});
  }
  if (const auto& entry = table[static_cast<std::size_t>(index)]) return *entry;
  return refuse(Gap{Gap::Reason::NotConfigured, index, "",
                    fmt::format("{} {} is not configured", toString(kind), index)});
}

template <class Entry>
Result<arm::Pose, Gap> poseOf(Kind kind, const Entry& entry, int index) {
  if (entry.pose) return *entry.pose;
  return refuse(Gap{Gap::Reason::ValueUnknown, index, entry.name,
                    fmt::format("{} {} is \"{}\" of the controller's project, whose value is not known",
                                toString(kind), index, foreignText(entry.name, kQuoteLimit))});
}

template <class Entry>
void learn(Table<Entry>& table, std::string_view name, const arm::Pose& pose) {
  for (std::optional<Entry>& entry : table) {
    if (entry && !entry->pose && entry->name == name) entry->pose = pose;
  }
}

}  // namespace

Payload payloadOf(const arm::ArmModel& model) {
  return {model.ratings().payload, model.name()};
}

DataTables::DataTables() : DataTables(Entries()) {}
DataTables::DataTables(Entries entries) : entries_(std::make_shared<const Entries>(std::move(entries))) {}

Result<DataTables, Refusal> DataTables::of(Entries entries, const Payload& payload) {
  const Entries fixed;
  entries.tools[0] = fixed.tools[0];
  entries.frames[0] = fixed.frames[0];
  entries.loads[0] = fixed.loads[0];
  if (auto refusal = checkAll(entries, payload)) return refuse(*std::move(refusal));
  return DataTables(std::move(entries));
}

Result<arm::Pose, Gap> DataTables::toolInFlange(int index) const {
  const auto tool = found(Kind::Tool, entries_->tools, index);
  if (!tool) return refuse(tool.error());
  return poseOf(Kind::Tool, *tool, index);
}

Result<arm::Pose, Gap> DataTables::frameInRobotBase(int index) const {
  const auto frame = found(Kind::Frame, entries_->frames, index);
  if (!frame) return refuse(frame.error());
  auto pose = poseOf(Kind::Frame, *frame, index);
  if (!pose || frame->reference == 0) return pose;
  const auto reference = frameInRobotBase(frame->reference);  // which refers to none
  if (!reference) {
    Gap gap = reference.error();
    gap.found = fmt::format("frame {} refers to another: {}", index, gap.found);
    return refuse(std::move(gap));
  }
  return arm::Pose(*reference * *pose);
}

Result<Load, Gap> DataTables::load(int index) const {
  return found(Kind::Load, entries_->loads, index);
}

template <class Entry>
std::optional<Refusal> DataTables::write(Kind kind, Table<Entry> Entries::*table, int index,
                                         std::optional<Entry> entry, const Payload& payload) {
  if (auto refusal = checkIndex(kind, index)) return refusal;
  Entries changed = *entries_;
  (changed.*table)[static_cast<std::size_t>(index)] = std::move(entry);
  if (auto refusal = checkEntry(kind, index, changed, payload)) return refusal;
  entries_ = std::make_shared<const Entries>(std::move(changed));
  return std::nullopt;
}

std::optional<Refusal> DataTables::writeTool(int index, std::optional<Tool> tool, const Payload& payload) {
  return write(Kind::Tool, &Entries::tools, index, std::move(tool), payload);
}

std::optional<Refusal> DataTables::writeFrame(int index, std::optional<Frame> frame, const Payload& payload) {
  return write(Kind::Frame, &Entries::frames, index, std::move(frame), payload);
}

std::optional<Refusal> DataTables::writeLoad(int index, std::optional<Load> load, const Payload& payload) {
  return write(Kind::Load, &Entries::loads, index, std::move(load), payload);
}

void DataTables::learnTool(std::string_view name, const arm::Pose& in_flange) {
  Entries changed = *entries_;
  learn(changed.tools, name, in_flange);
  entries_ = std::make_shared<const Entries>(std::move(changed));
}

void DataTables::learnFrame(std::string_view name, const arm::Pose& in_robot_base) {
  Entries changed = *entries_;
  learn(changed.frames, name, in_robot_base);
  entries_ = std::make_shared<const Entries>(std::move(changed));
}

}  // namespace cobot_command::tables
