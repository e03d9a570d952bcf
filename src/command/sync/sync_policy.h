// Who wins where our tables and the controller's project differ: by the modes of the node, and by who has
// changed what since the last look.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sync/table_comparison.h"

#include "cobot_command/command/exchange_rules.h"
#include "cobot_command/command/table_write.h"

namespace cobot_command::command {

/// What one look has shown, and what is to be done.
struct SyncLook {
  [[nodiscard]] bool isInSync(tables::Kind kind) const;

  /// Of each entry that is not in sync, in words; by set and number.
  std::map<std::pair<tables::Kind, int>, std::string> differences;
  BySet<bool> conflicts;                            ///< both sides have changed an entry: nobody wins
  BySet<int> changed;                               ///< an index that the controller's side changed; 0: none
  BySet<bool> is_written;                           ///< of that set something is for_project
  std::vector<script::AttributeWrite> for_project;  ///< ours win
  std::vector<TableWrite> for_tables;               ///< theirs win
};

class SyncPolicy {
 public:
  /// Whether somebody uses that entry, so that it has to stay as it is.
  using IsUsed = std::function<bool(tables::Kind kind, int index)>;

  /// Nothing is known of before. Precondition: no faultIn() the rules.
  void begin(const ExchangeRules& rules);

  [[nodiscard]] SyncLook look(const tables::DataTables& ours, const ProjectValues& theirs,
                              const IsUsed& is_used);
  /// The controller has taken what the last look had for it.
  void written();

 private:
  enum class Winner { Nobody, Ours, Theirs, Conflict };
  struct Memory {
    std::string names;  ///< in the project: with another one it is another entry
    std::optional<EntryValue> own;
    std::optional<EntryValue> ours;
    std::vector<NamedValue> theirs;
    Winner winner = Winner::Nobody;  ///< until both are the same
    bool is_asked_for = false;       ///< the controller is to take ours
    bool has_begun = false;          ///< the mode of the start has ruled, or had nothing to do
  };

  [[nodiscard]] Winner winnerOf(const ComparedEntry& entry, const Memory* before, bool theirs_changed) const;
  /// What is ours now, of one entry behind the other: `ours` has what was taken in this look.
  void lookAt(ComparedEntry entry, tables::DataTables& ours, const ProjectValues& theirs,
              const IsUsed& is_used, SyncLook& look);
  static void decide(const ComparedEntry& entry, Winner winner, tables::DataTables& ours,
                     const ProjectValues& theirs, SyncLook& look);

  ExchangeRules rules_;
  std::map<std::pair<tables::Kind, int>, Memory> memory_;
  std::map<std::pair<tables::Kind, int>, Memory> seen_;  ///< in this look
};

}  // namespace cobot_command::command
