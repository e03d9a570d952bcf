#include "cobot_command/tables/table_store.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::tables {
namespace {

int inUseError(Kind kind) {
  return kind == Kind::Tool    ? table_error::kToolInUse
         : kind == Kind::Frame ? table_error::kFrameInUse
                               : table_error::kLoadInUse;
}

}  // namespace

TableStore::TableStore(DataTables tables, Payload payload)
    : tables_(std::move(tables)), payload_(std::move(payload)) {}

void TableStore::replace(DataTables tables) {
  tables.stamp(tables_.revision() + 1);
  tables_ = std::move(tables);
}

DataTables TableStore::forPlans() const {
  DataTables tables = tables_;
  for (const auto& [name, pose] : project_.tools) tables.learnTool(name, pose);
  for (const auto& [name, pose] : project_.frames) tables.learnFrame(name, pose);
  return tables;
}

Hold TableStore::hold(Use use) {
  uses_.erase(std::remove_if(uses_.begin(), uses_.end(), [](const auto& one) { return one.expired(); }),
              uses_.end());
  auto held = std::make_shared<const Use>(std::move(use));
  uses_.push_back(held);
  return held;
}

bool TableStore::uses(const Use& use, Kind kind, int index) const {
  const Entries& entries = tables_.entries();
  // What is in use is not written, so it refers to what it referred to when its use began.
  const auto is_load = [&](int tool) {
    return isIndex(tool) && entries.tools[static_cast<std::size_t>(tool)] &&
           entries.tools[static_cast<std::size_t>(tool)]->load == index;
  };
  const auto is_or_refers = [&](int frame) {
    return frame == index || (isIndex(frame) && entries.frames[static_cast<std::size_t>(frame)] &&
                              entries.frames[static_cast<std::size_t>(frame)]->reference == index);
  };
  switch (kind) {
    case Kind::Tool:
      return std::find(use.tools.begin(), use.tools.end(), index) != use.tools.end();
    case Kind::Frame:
      return std::any_of(use.frames.begin(), use.frames.end(), is_or_refers);
    default:
      return std::any_of(use.tools.begin(), use.tools.end(), is_load);
  }
}

std::optional<std::string> TableStore::userOf(Kind kind, int index) const {
  if (index == 0) return std::nullopt;
  for (const auto& one : uses_) {
    const Hold held = one.lock();
    if (held && uses(*held, kind, index)) return held->user;
  }
  return std::nullopt;
}

std::optional<Refusal> TableStore::inUse(Kind kind, int index) const {
  const auto user = userOf(kind, index);
  if (!user) return std::nullopt;
  return Refusal{inUseError(kind),
                 kind,
                 index,
                 fmt::format("{} uses it", foreignText(*user, kQuoteLimit)),
                 "to write an entry that is not in use",
                 "Wait until it is done, or cancel it"};
}

Result<DataTables, Refusal> TableStore::unlessUsed(Kind kind, int index, DataTables changed,
                                                   std::optional<Refusal> refusal) const {
  if (!refusal) refusal = inUse(kind, index);
  if (refusal) return refuse(*std::move(refusal));
  return changed;
}

Result<DataTables, Refusal> TableStore::withTool(int index, std::optional<Tool> tool) const {
  DataTables changed = tables_;
  auto refusal = changed.writeTool(index, std::move(tool), payload_);
  return unlessUsed(Kind::Tool, index, std::move(changed), std::move(refusal));
}

Result<DataTables, Refusal> TableStore::withFrame(int index, std::optional<Frame> frame) const {
  DataTables changed = tables_;
  auto refusal = changed.writeFrame(index, std::move(frame), payload_);
  return unlessUsed(Kind::Frame, index, std::move(changed), std::move(refusal));
}

Result<DataTables, Refusal> TableStore::withLoad(int index, std::optional<Load> load) const {
  DataTables changed = tables_;
  auto refusal = changed.writeLoad(index, std::move(load), payload_);
  return unlessUsed(Kind::Load, index, std::move(changed), std::move(refusal));
}

std::optional<Refusal> TableStore::take(Result<DataTables, Refusal> changed) {
  if (!changed) return changed.error();
  replace(*std::move(changed));
  return std::nullopt;
}

std::optional<Refusal> TableStore::writeTool(int index, std::optional<Tool> tool) {
  return take(withTool(index, std::move(tool)));
}

std::optional<Refusal> TableStore::writeFrame(int index, std::optional<Frame> frame) {
  return take(withFrame(index, std::move(frame)));
}

std::optional<Refusal> TableStore::writeLoad(int index, std::optional<Load> load) {
  return take(withLoad(index, std::move(load)));
}

}  // namespace cobot_command::tables
