// Our tables and the controller's project, kept side by side while the interface is enabled: looked at, told,
// and brought into line as the modes of the node say; and the software limits beside those of its safety
// functions, told only (SRCI: data in sync).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dynamics/limits_desk.h"
#include "messages/message_desk.h"
#include "sync/project_line.h"
#include "sync/sync_policy.h"
#include "tables/table_desk.h"

#include "cobot_command/blocks/exchange_configuration.h"
#include "cobot_command/command/actions.h"
#include "cobot_command/command/exchange_rules.h"

namespace cobot_command::command {

class SyncDesk {
 public:
  /// All have to live longer.
  struct Core {
    link::ScriptLink& script;
    const link::LinkSettings& settings;
    TableDesk& tables;
    MessageDesk& messages;
    const LimitsDesk& limits;
    std::vector<Action>& actions;
  };
  explicit SyncDesk(const Core& core) : core_(core), line_(core.script, core.settings) {}

  /// The interface is enabled; nothing is known of the controller's values yet.
  void begin(const ExchangeRules& rules, const blocks::ExchangeSettings& settings, Instant now);
  void change(const blocks::ExchangeSettings& settings);
  void end();

  // --- Events. The first two: whether it was for this desk.
  bool take(const protocol::ListenData& data) { return line_.take(data); }
  bool take(const link::ScriptAnswered& answered) { return line_.take(answered); }
  void advance(Instant now);
  /// Behind each event: what was answered, and what is to be asked now.
  void look(Instant now);
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

  // --- What is so.
  /// The tables were looked at, or cannot be; or limits are out of sync, for which nobody has to look.
  [[nodiscard]] bool isJudged() const { return is_judged_ || !limitsReason().empty(); }
  /// All that are enabled.
  [[nodiscard]] bool isInSync() const;
  [[nodiscard]] blocks::RiState riState() const;
  /// The controller's half: without the flags of the caller.
  [[nodiscard]] blocks::DataSets controllersHalf() const;
  /// Those that have no counterpart on the controller.
  [[nodiscard]] std::vector<std::string> localSets() const;
  /// Changed last on the controller, by others; 0: none.
  [[nodiscard]] const BySet<int>& changed() const { return changed_; }
  /// SRCI's numbers; 0: none.
  [[nodiscard]] int warningId() const;
  [[nodiscard]] int infoId() const;
  /// What is out of sync, in words; empty: nothing.
  [[nodiscard]] std::string whyNot() const;
  /// Where it is by the software limits, which no write of an entry brings into line; else "".
  [[nodiscard]] std::string remedy() const;
  /// Which of these entries differ from the controller's, in words; empty: none.
  [[nodiscard]] std::string differencesIn(const tables::Use& use) const;

 private:
  void ask(Instant now);
  void take(const ProjectLine::Result& result, Instant now);
  void takeValues(const std::vector<robot::ReadValue>& values, Instant now);
  void takeFailure(const robot::ReadFailure& failure, Instant now);
  void carryOut(Instant now);
  [[nodiscard]] bool isUnknown(const script::AttributeRead& read) const;
  void noteUnread(const script::AttributeRead& read, const std::string& why);
  /// "" without a reason.
  [[nodiscard]] std::string reasonOf(tables::Kind kind) const;
  [[nodiscard]] bool isSetInSync(tables::Kind kind) const;
  /// Why the software limits are out of sync; "" where they are not, or are not enabled.
  [[nodiscard]] std::string limitsReason() const;
  /// Messages of what is so, each once.
  void tell();
  void tellInfo(tables::Kind kind);
  void tellReadAgain();
  /// Why entries could not be read or written, and what to do; empty: they could.
  [[nodiscard]] std::string unreachableText(tables::Kind kind) const {
    return unread_.of(kind) + unwritten_.of(kind);
  }
  [[nodiscard]] std::string remedyOf(tables::Kind kind) const;

  Core core_;
  ProjectLine line_;
  SyncPolicy policy_;
  ExchangeRules rules_;
  blocks::ExchangeSettings settings_;
  bool is_active_ = false;
  bool is_judged_ = false;
  bool is_verifying_ = false;  ///< ours were written, and are read back
  std::optional<Instant> ask_at_;
  int looks_ = 0;                               ///< with each period
  bool asks_again_ = false;                     ///< at once, without what the project does not have
  int failures_ = 0;                            ///< of readings, one after the other
  bool refuses_reading_ = false;                ///< the controller does: it is asked now and then
  tables::DataTables compared_;                 ///< our tables, as they were then
  std::vector<script::AttributeRead> unknown_;  ///< of names that the project does not have
  BySet<std::string> unread_;                   ///< why their values are not known
  BySet<std::string> unwritten_;                ///< why ours were not taken
  SyncLook look_;
  BySet<int> changed_;
  BySet<bool> told_infos_;
};

}  // namespace cobot_command::command
