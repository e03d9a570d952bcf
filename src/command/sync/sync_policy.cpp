#include "sync/sync_policy.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

namespace cobot_command::command {
namespace {

using tables::Kind;

bool isOneOf(int mode, int highest) {
  return mode >= 0 && mode <= highest;
}

std::optional<std::string> faultIn(const char* set, const SyncModes& modes) {
  if (!isOneOf(modes.start, static_cast<int>(SyncMode::ServerToClient))) {
    return fmt::format("sync/{}/start is {}, allowed: 0 to 2", set, modes.start);
  }
  if (!isOneOf(modes.run, static_cast<int>(SyncMode::Automatic))) {
    return fmt::format("sync/{}/run is {}, allowed: 0 to 3", set, modes.run);
  }
  return std::nullopt;
}

std::string namesOf(const ComparedEntry& entry) {
  std::string names;
  for (const NamedValue& named : entry.theirs) names += named.name + '\n';
  return names;
}

bool haveChanged(const std::optional<EntryValue>& before, const std::optional<EntryValue>& now) {
  return before && now && !isSame(*before, *now);
}

bool haveChanged(const std::vector<NamedValue>& before, const std::vector<NamedValue>& now) {
  return !std::equal(before.begin(), before.end(), now.begin(), now.end(),
                     [](const NamedValue& a, const NamedValue& b) { return !haveChanged(a.value, b.value); });
}

/// Theirs, as our tables have it.
std::optional<TableWrite> entryOf(const ComparedEntry& entry, const EntryValue& theirs,
                                  const tables::DataTables& ours) {
  const auto i = static_cast<std::size_t>(entry.index);
  if (entry.kind == Kind::Load) return TableWrite{entry.index, std::optional(std::get<tables::Load>(theirs))};
  const auto& pose = std::get<arm::Pose>(theirs);
  if (entry.kind == Kind::Tool) {
    std::optional<tables::Tool> tool = ours.entries().tools[i];
    tool->pose = pose;
    return TableWrite{entry.index, std::move(tool)};
  }
  std::optional<tables::Frame> frame = ours.entries().frames[i];
  const auto reference = ours.frameInRobotBase(frame->reference);
  if (!reference) return std::nullopt;
  frame->pose = arm::Pose(reference->inverse() * pose);
  return TableWrite{entry.index, std::move(frame)};
}

std::vector<script::AttributeWrite> writesOf(const ComparedEntry& entry, const std::string& name,
                                             const tables::DataTables& ours, const ProjectValues& theirs) {
  switch (entry.kind) {
    case Kind::Tool:
      return {tcpWrite(name, std::get<arm::Pose>(*entry.ours))};
    case Kind::Frame:
      return {baseWrite(name, std::get<arm::Pose>(*entry.ours))};
    case Kind::Load:
      break;
  }
  for (const auto& tool : ours.entries().tools) {
    const auto tcp = tool && tool->name == name ? tcpOf(*tool, theirs) : std::nullopt;
    if (tcp) return burdenWrites(name, std::get<tables::Load>(*entry.ours), *tcp);
  }
  return {};
}

/// So that what refers to it, and comes behind it, is seen from where it is then.
void take(tables::DataTables& ours, const TableWrite& write) {
  if (const auto* const frame = std::get_if<std::optional<tables::Frame>>(&write.entry)) {
    static_cast<void>(ours.writeFrame(write.index, *frame, {}));
  } else if (const auto* const tool = std::get_if<std::optional<tables::Tool>>(&write.entry)) {
    static_cast<void>(ours.writeTool(write.index, *tool, {}));
  }
}

}  // namespace

std::optional<std::string> faultIn(const ExchangeRules& rules) {
  auto fault = faultIn("tools", rules.sync.tools);
  if (!fault) fault = faultIn("frames", rules.sync.frames);
  return fault ? fault : faultIn("loads", rules.sync.loads);
}

bool SyncLook::isInSync(tables::Kind kind) const {
  return std::none_of(differences.begin(), differences.end(),
                      [kind](const auto& difference) { return difference.first.first == kind; });
}

void SyncPolicy::begin(const ExchangeRules& rules) {
  rules_ = rules;
  memory_.clear();
}

SyncPolicy::Winner SyncPolicy::winnerOf(const ComparedEntry& entry, const Memory* before,
                                        bool theirs_changed) const {
  const SyncModes& modes = rules_.sync.of(entry.kind);
  const bool is_start = before == nullptr || !before->has_begun;
  if (!entry.also_named.empty()) return Winner::Nobody;
  const auto mode = static_cast<SyncMode>(is_start ? modes.start : modes.run);
  if (mode == SyncMode::ClientToServer) return Winner::Ours;
  if (mode == SyncMode::ServerToClient) return Winner::Theirs;
  if (mode == SyncMode::None || is_start) return Winner::Nobody;
  const bool ours_changed = haveChanged(before->own, entry.own);
  if (before->winner == Winner::Conflict) return ours_changed ? Winner::Ours : Winner::Conflict;
  if (ours_changed && theirs_changed) return Winner::Conflict;
  if (ours_changed) return Winner::Ours;
  return theirs_changed ? Winner::Theirs : before->winner;
}

SyncLook SyncPolicy::look(const tables::DataTables& ours, const ProjectValues& theirs,
                          const IsUsed& is_used) {
  SyncLook look;
  seen_.clear();
  tables::DataTables working = ours;
  for (ComparedEntry& entry : compare(ours, theirs)) {
    lookAt(std::move(entry), working, theirs, is_used, look);
  }
  memory_ = std::move(seen_);
  return look;
}

void SyncPolicy::lookAt(ComparedEntry entry, tables::DataTables& ours, const ProjectValues& theirs,
                        const IsUsed& is_used, SyncLook& look) {
  const auto found = memory_.find({entry.kind, entry.index});
  const bool is_known = found != memory_.end() && found->second.names == namesOf(entry);
  const Memory* const before = is_known ? &found->second : nullptr;
  const bool theirs_changed = is_known && haveChanged(before->theirs, entry.theirs);
  if (theirs_changed) look.changed.of(entry.kind) = entry.index;
  Memory now{namesOf(entry), entry.own, entry.ours, entry.theirs};
  now.has_begun = before != nullptr && before->has_begun;
  if (entry.kind == Kind::Frame && entry.ours) {
    if (const auto pose = ours.frameInRobotBase(entry.index)) entry.ours = *pose;
    now.ours = entry.ours;
  }
  if (entry.isInSync()) {
    now.has_begun = true;
  } else {
    now.winner = winnerOf(entry, before, theirs_changed);
    look.differences[{entry.kind, entry.index}] = entry.difference();
    if (now.winner == Winner::Conflict) look.conflicts.of(entry.kind) = true;
    const bool may_change = !is_used(entry.kind, entry.index);
    now.is_asked_for = may_change && now.winner == Winner::Ours;
    now.has_begun = now.has_begun || (may_change && entry.isRead());
    if (may_change) decide(entry, now.winner, ours, theirs, look);
  }
  seen_[{entry.kind, entry.index}] = std::move(now);
}

void SyncPolicy::written() {
  for (auto& [which, memory] : memory_) {
    if (!memory.is_asked_for) continue;
    for (NamedValue& named : memory.theirs) named.value = memory.ours;
  }
}

void SyncPolicy::decide(const ComparedEntry& entry, Winner winner, tables::DataTables& ours,
                        const ProjectValues& theirs, SyncLook& look) {
  if (winner == Winner::Theirs) {
    const auto value = entry.theirValue();
    auto write = value ? entryOf(entry, *value, ours) : std::nullopt;
    if (!write) return;
    take(ours, *write);
    look.for_tables.push_back(*std::move(write));
  } else if (winner == Winner::Ours && entry.ours) {
    for (const NamedValue& named : entry.theirs) {
      if (!named.value || isSame(*named.value, *entry.ours)) continue;
      auto writes = writesOf(entry, named.name, ours, theirs);
      look.is_written.of(entry.kind) = true;
      std::move(writes.begin(), writes.end(), std::back_inserter(look.for_project));
    }
  }
}

}  // namespace cobot_command::command
