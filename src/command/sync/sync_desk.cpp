#include "sync/sync_desk.h"

#include <algorithm>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/common/deadline.h"
#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/overloaded.h"

namespace cobot_command::command {
namespace {

using tables::Kind;

constexpr Kind kKinds[] = {Kind::Tool, Kind::Frame, Kind::Load};
/// What the controller refuses, as it or its project does not have it, is asked for again with each so
/// many-th look.
constexpr int kLooksUntilAgain = 10;
/// A controller that is busy with the script of another client answers late, and one answer may be wrong;
/// nothing has changed by that.
constexpr int kFailuresUntilUnknown = 3;
constexpr const char* kOrigin = "synchronisation";
constexpr const char* kLimits = "software_limits";

struct SetNumbers {
  const char* name;
  int differs;      ///< info, of a set that is not enabled
  int conflict;     ///< warning
  int unreachable;  ///< warning: could not be read, or written
};
constexpr SetNumbers numbersOf(Kind kind) {
  using namespace blocks::exchange_note;
  switch (kind) {
    case Kind::Tool:
      return {"tools", kToolsDiffer, kToolsConflict, kToolsUnreachable};
    case Kind::Frame:
      return {"frames", kFramesDiffer, kFramesConflict, kFramesUnreachable};
    default:
      return {"loads", kLoadsDiffer, kToolsConflict, kToolsUnreachable};
  }
}

bool flagOf(const blocks::DataSets& sets, Kind kind) {
  switch (kind) {
    case Kind::Tool:
      return sets.tools;
    case Kind::Frame:
      return sets.frames;
    default:
      return sets.loads;
  }
}

bool isAnyEnabled(const blocks::DataSets& sets) {
  return !(sets == blocks::DataSets());
}

bool isOf(Kind kind, const script::AttributeRead& read) {
  using script::ProjectAttribute;
  if (kind == Kind::Frame) return read.attribute == ProjectAttribute::BaseValue;
  return (read.attribute == ProjectAttribute::TcpValue) == (kind == Kind::Tool) &&
         read.attribute != ProjectAttribute::BaseValue;
}

std::string staleText(const char* set) {
  return fmt::format("data_in_sync reports that the caller's own {} are not up to date", set);
}

Message warning(int code, std::string text, std::string remedy) {
  return {0,    {},      Severity::Warning, MessageType::Interface,
          code, kOrigin, std::move(text),   std::move(remedy)};
}

}  // namespace

void SyncDesk::begin(const ExchangeRules& rules, const blocks::ExchangeSettings& settings, Instant now) {
  end();
  rules_ = rules;
  settings_ = settings;
  policy_.begin(rules);
  is_active_ = true;
  ask_at_ = now;
  look(now);
}

void SyncDesk::change(const blocks::ExchangeSettings& settings) {
  settings_ = settings;
  tell();
}

void SyncDesk::end() {
  line_.forget();
  is_active_ = is_judged_ = is_verifying_ = false;
  ask_at_.reset();
  looks_ = failures_ = 0;
  refuses_reading_ = false;
  unknown_.clear();
  unread_ = unwritten_ = {};
  look_ = {};
  changed_ = {};
  tell();
  told_infos_ = {};
  core_.tables.store().know({});
}

// --- Events.

void SyncDesk::advance(Instant now) {
  line_.advance(now);
}

std::optional<Instant> SyncDesk::nextDeadline() const {
  if (!is_active_) return std::nullopt;
  return earlier(line_.nextDeadline(), line_.isFree() ? ask_at_ : std::nullopt);
}

void SyncDesk::look(Instant now) {
  if (!is_active_) return;
  while (const auto result = line_.takeResult()) {
    take(*result, now);
    tell();
  }
  const bool are_others = &compared_.entries() != &core_.tables.store().tables().entries();
  if (are_others && !line_.isReading()) ask_at_ = now;
  if (ask_at_ && now >= *ask_at_ && line_.isFree()) ask(now);
}

void SyncDesk::ask(Instant now) {
  compared_ = core_.tables.store().tables();
  const bool is_of_the_period = !std::exchange(asks_again_, false);
  const bool asks_all = is_of_the_period && ++looks_ % kLooksUntilAgain == 0;
  if (asks_all) unknown_.clear();
  auto reads = readsOf(compared_.entries());
  const bool is_any_named = !reads.empty();
  reads.erase(
      std::remove_if(reads.begin(), reads.end(), [this](const auto& read) { return isUnknown(read); }),
      reads.end());
  ask_at_ = is_any_named ? std::optional(now + rules_.sync_period) : std::nullopt;
  if (reads.empty()) {
    takeValues({}, now);
    tell();
  } else if (!refuses_reading_ || asks_all) {
    line_.read(std::move(reads), now);
  }
}

void SyncDesk::take(const ProjectLine::Result& result, Instant now) {
  std::visit(Overloaded{[&](const robot::ReadOutcome& outcome) {
                          if (outcome) {
                            takeValues(*outcome, now);
                          } else {
                            takeFailure(outcome.error(), now);
                          }
                        },
                        [&](const ProjectLine::Written&) {
                          policy_.written();
                          is_verifying_ = true;
                          ask_at_ = now;
                        },
                        [&](const ProjectLine::NotWritten& not_written) {
                          for (const Kind kind : kKinds) {
                            if (look_.is_written.of(kind)) unwritten_.of(kind) = not_written.reason;
                          }
                        }},
             result);
}

void SyncDesk::takeValues(const std::vector<robot::ReadValue>& values, Instant now) {
  if (&compared_.entries() != &core_.tables.store().tables().entries()) return;  // asked for again
  if (failures_ >= kFailuresUntilUnknown) tellReadAgain();
  failures_ = 0;
  refuses_reading_ = false;
  unread_ = {};
  const auto wanted = readsOf(compared_.entries());
  unknown_.erase(std::remove_if(unknown_.begin(), unknown_.end(),
                                [&wanted](const auto& read) {
                                  return std::find(wanted.begin(), wanted.end(), read) == wanted.end();
                                }),
                 unknown_.end());
  for (const auto& read : unknown_) noteUnread(read, fmt::format("the project has no {}", describe(read)));
  const ProjectValues project = valuesOf(values);
  tables::TableStore& store = core_.tables.store();
  store.know({project.tcps, project.bases});
  look_ = policy_.look(compared_, project,
                       [&store](Kind kind, int index) { return store.userOf(kind, index).has_value(); });
  is_judged_ = true;
  for (const Kind kind : kKinds) {
    if (look_.changed.of(kind) != 0) changed_.of(kind) = look_.changed.of(kind);
    if (look_.isInSync(kind)) unwritten_.of(kind).clear();
  }
  carryOut(now);
}

/// What was written is looked at once before it is written again: a controller that does not keep it would be
/// asked without an end.
void SyncDesk::carryOut(Instant now) {
  const bool is_verified = std::exchange(is_verifying_, false);
  for (const TableWrite& write : look_.for_tables) {
    const auto written = core_.tables.write(write);
    if (!written) unwritten_.of(written.error().kind) = describe(written.error());
  }
  if (!look_.for_project.empty() && !is_verified && line_.isFree()) line_.write(look_.for_project, now);
}

void SyncDesk::takeFailure(const robot::ReadFailure& failure, Instant now) {
  using Failure = robot::ReadFailure::Kind;
  if (failure.kind == Failure::Lost) return;
  if (failure.kind == Failure::Unknown) {
    unknown_.insert(unknown_.end(), failure.reads.begin(), failure.reads.end());
    asks_again_ = true;
    ask_at_ = now;
    return;
  }
  if (++failures_ < kFailuresUntilUnknown) return;  // what was known counts on
  refuses_reading_ = failure.kind == Failure::NoListenSend;
  is_judged_ = true;
  for (const auto& read : readsOf(compared_.entries())) noteUnread(read, failure.reason);
}

bool SyncDesk::isUnknown(const script::AttributeRead& read) const {
  return std::find(unknown_.begin(), unknown_.end(), read) != unknown_.end();
}

void SyncDesk::noteUnread(const script::AttributeRead& read, const std::string& why) {
  for (const Kind kind : kKinds) {
    if (isOf(kind, read)) unread_.of(kind) = why;
  }
}

// --- What is so.

bool SyncDesk::isSetInSync(Kind kind) const {
  return look_.isInSync(kind) && unread_.of(kind).empty();
}

blocks::DataSets SyncDesk::controllersHalf() const {
  const auto half = [this](Kind kind) { return is_judged_ && isSetInSync(kind); };
  const bool are_limits_inside = core_.limits.excess().empty();
  return {half(Kind::Tool), half(Kind::Frame), half(Kind::Load), true, are_limits_inside, true, true};
}

std::vector<std::string> SyncDesk::localSets() const {
  std::vector<std::string> sets{"default_dynamics", "reference_dynamics"};
  if (!core_.limits.areCompared()) sets.insert(sets.begin(), kLimits);
  return sets;
}

bool SyncDesk::isInSync() const {
  const bool are_tables = std::all_of(std::begin(kKinds), std::end(kKinds), [this](Kind kind) {
    if (!flagOf(settings_.data_enable_sync, kind)) return true;
    return is_judged_ && flagOf(settings_.data_in_sync, kind) && isSetInSync(kind);
  });
  return are_tables && limitsReason().empty();
}

blocks::RiState SyncDesk::riState() const {
  if (!is_active_) return blocks::RiState::NotInitialized;
  return isAnyEnabled(settings_.data_enable_sync) && isInSync() ? blocks::RiState::Synchronized
                                                                : blocks::RiState::Initialized;
}

std::string SyncDesk::reasonOf(Kind kind) const {
  std::string reason;
  const auto add = [&reason](const std::string& text) {
    if (!text.empty()) reason += (reason.empty() ? "" : "; ") + text;
  };
  for (const auto& [which, difference] : look_.differences) {
    if (which.first == kind) add(difference);
  }
  add(unread_.of(kind));
  add(unwritten_.of(kind));
  return reason;
}

std::string SyncDesk::limitsReason() const {
  if (!settings_.data_enable_sync.software_limits || !core_.limits.areCompared()) return "";
  std::string reason = core_.limits.excess();
  return reason.empty() && !settings_.data_in_sync.software_limits ? staleText(kLimits) : reason;
}

std::string SyncDesk::whyNot() const {
  if (!is_active_) return "";
  std::string why;
  const auto add = [&why](const std::string& reason) {
    if (!reason.empty()) why += (why.empty() ? "" : "; ") + reason;
  };
  for (const Kind kind : kKinds) {
    if (!flagOf(settings_.data_enable_sync, kind)) continue;
    const std::string reason = reasonOf(kind);
    const bool is_stale = reason.empty() && !flagOf(settings_.data_in_sync, kind);
    add(is_stale ? staleText(numbersOf(kind).name) : reason);
  }
  add(limitsReason());
  return why;
}

std::string SyncDesk::remedy() const {
  if (!is_active_ || limitsReason().empty()) return "";
  return "Set the controller's limits back on the pendant, then RESUME with program_control; or stop, and "
         "narrow the limits of this node with write_software_limits";
}

std::string SyncDesk::differencesIn(const tables::Use& use) const {
  std::string text;
  const auto add = [&](Kind kind, const std::vector<int>& indices) {
    for (const int index : std::set<int>(indices.begin(), indices.end())) {
      const auto found = look_.differences.find({kind, index});
      if (found != look_.differences.end()) text += (text.empty() ? "" : "; ") + found->second;
    }
  };
  add(Kind::Tool, use.tools);
  add(Kind::Frame, use.frames);
  return text;
}

int SyncDesk::warningId() const {
  for (const Kind kind : kKinds) {
    if (look_.conflicts.of(kind)) return numbersOf(kind).conflict;
  }
  for (const Kind kind : kKinds) {
    if (!unread_.of(kind).empty() || !unwritten_.of(kind).empty()) return numbersOf(kind).unreachable;
  }
  return 0;
}

int SyncDesk::infoId() const {
  for (const Kind kind : kKinds) {
    if (is_judged_ && !flagOf(settings_.data_enable_sync, kind) && !isSetInSync(kind)) {
      return numbersOf(kind).differs;
    }
  }
  return 0;
}

// --- What is told.

void SyncDesk::tell() {
  for (const Kind kind : {Kind::Tool, Kind::Frame}) {
    const SetNumbers numbers = numbersOf(kind);
    const bool is_tools = kind == Kind::Tool;
    const bool is_conflict = look_.conflicts.of(kind) || (is_tools && look_.conflicts.loads);
    core_.messages.show(
        is_conflict,
        warning(numbers.conflict,
                fmt::format("{} were changed here and on the controller: neither is copied", numbers.name),
                "write the intended entry, or change it back on the pendant"));
    Kind blamed = kind;
    if (is_tools && unreachableText(kind).empty()) blamed = Kind::Load;
    const std::string unreachable = unreachableText(blamed);
    core_.messages.show(!unreachable.empty(),
                        warning(numbers.unreachable,
                                fmt::format("{} could not be read or written: {}", numbers.name, unreachable),
                                remedyOf(blamed)));
  }
  for (const Kind kind : kKinds) tellInfo(kind);
}

void SyncDesk::tellReadAgain() {
  core_.actions.emplace_back(
      LogMessage{Severity::Info, "the values of the controller's project can be read again"});
}

std::string SyncDesk::remedyOf(Kind kind) const {
  const bool has_unknown_names =
      std::any_of(unknown_.begin(), unknown_.end(), [kind](const auto& read) { return isOf(kind, read); });
  return has_unknown_names || !unwritten_.of(kind).empty()
             ? "give the names as the project has them; see doc/tables.md"
             : "wait: the controller is queried again automatically. If the problem persists, check for "
               "another client, a flow outside the Listen node, or TMflow before 1.76";
}

/// Once, until it is so no more.
void SyncDesk::tellInfo(Kind kind) {
  const bool is_so = is_judged_ && !flagOf(settings_.data_enable_sync, kind) && !look_.isInSync(kind);
  if (is_so && !told_infos_.of(kind)) {
    core_.actions.emplace_back(
        LogMessage{Severity::Info,
                   fmt::format("{} differ, and are not enabled in data_enable_sync: {}", numbersOf(kind).name,
                               reasonOf(kind)),
                   numbersOf(kind).differs});
  }
  told_infos_.of(kind) = is_so;
}

}  // namespace cobot_command::command
