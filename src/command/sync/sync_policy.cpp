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

std::vector<script::AttributeWrite> writesOf(const ComparedEntry& entry, const NamedValue& named,
                                             const ProjectValues& theirs) {
  switch (entry.kind) {
    case Kind::Tool:
      return {tcpWrite(named.name, std::get<arm::Pose>(*entry.ours))};
    case Kind::Frame:
      return {baseWrite(named.name, std::get<arm::Pose>(*entry.ours))};
    case Kind::Load:
      break;
  }
  const auto tcp = theirs.tcps.find(named.name);
  if (tcp == theirs.tcps.end()) return {};
  return burdenWrites(named.name, std::get<tables::Load>(*entry.ours), tcp->second);
}

}  // namespace

std::optional<std::string> faultIn(const ExchangeRules& rules) {
  auto fault = faultIn("tools", rules.sync.tools);
  if (!fault) fault = faultIn("frames", rules.sync.frames);
  return fault ? fault : faultIn("loads", rules.sync.loads);
}

void SyncPolicy::begin(const ExchangeRules& rules) {
  rules_ = rules;
  memory_.clear();
}

SyncPolicy::Winner SyncPolicy::winnerOf(const ComparedEntry& entry, const Memory* before,
                                        bool theirs_changed) const {
  const SyncModes& modes = rules_.sync.of(entry.kind);
  const auto mode = static_cast<SyncMode>(before == nullptr ? modes.start : modes.run);
  if (mode == SyncMode::ClientToServer) return Winner::Ours;
  if (mode == SyncMode::ServerToClient) return Winner::Theirs;
  if (mode == SyncMode::None || before == nullptr) return Winner::Nobody;
  const bool ours_changed = haveChanged(before->ours, entry.ours);
  if (before->winner == Winner::Conflict) return ours_changed ? Winner::Ours : Winner::Conflict;
  if (ours_changed && theirs_changed) return Winner::Conflict;
  if (ours_changed) return Winner::Ours;
  return theirs_changed ? Winner::Theirs : before->winner;
}

SyncLook SyncPolicy::look(const tables::DataTables& ours, const ProjectValues& theirs,
                          const IsUsed& is_used) {
  SyncLook look;
  std::map<std::pair<Kind, int>, Memory> seen;
  for (const ComparedEntry& entry : compare(ours, theirs)) {
    const auto found = memory_.find({entry.kind, entry.index});
    const bool is_known = found != memory_.end() && found->second.names == namesOf(entry);
    const Memory* const before = is_known ? &found->second : nullptr;
    const bool theirs_changed = is_known && haveChanged(before->theirs, entry.theirs);
    if (theirs_changed) look.changed.of(entry.kind) = entry.index;
    Memory now{namesOf(entry), entry.ours, entry.theirs};
    if (!entry.isInSync()) {
      now.winner = winnerOf(entry, before, theirs_changed);
      look.differences.of(entry.kind).push_back(entry.difference());
      if (now.winner == Winner::Conflict) look.conflicts.of(entry.kind) = true;
      const bool may_change = !is_used(entry.kind, entry.index);
      now.is_asked_for = may_change && now.winner == Winner::Ours;
      if (may_change) decide(entry, now.winner, ours, theirs, look);
    }
    seen[{entry.kind, entry.index}] = std::move(now);
  }
  memory_ = std::move(seen);
  return look;
}

void SyncPolicy::written() {
  for (auto& [which, memory] : memory_) {
    if (!memory.is_asked_for) continue;
    for (NamedValue& named : memory.theirs) named.value = memory.ours;
  }
}

void SyncPolicy::decide(const ComparedEntry& entry, Winner winner, const tables::DataTables& ours,
                        const ProjectValues& theirs, SyncLook& look) const {
  if (winner == Winner::Theirs) {
    const auto value = entry.theirValue();
    auto write = value ? entryOf(entry, *value, ours) : std::nullopt;
    if (write) look.for_tables.push_back(*std::move(write));
  } else if (winner == Winner::Ours && entry.ours) {
    for (const NamedValue& named : entry.theirs) {
      if (!named.value || isSame(*named.value, *entry.ours)) continue;
      auto writes = writesOf(entry, named, theirs);
      std::move(writes.begin(), writes.end(), std::back_inserter(look.for_project));
    }
  }
}

}  // namespace cobot_command::command
