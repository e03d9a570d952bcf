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
  BySet<std::vector<std::string>> differences;      ///< in words; none: in sync
  BySet<bool> conflicts;                            ///< both sides have changed an entry: nobody wins
  BySet<int> changed;                               ///< an index that the controller's side changed; 0: none
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
    std::optional<EntryValue> ours;
    std::vector<NamedValue> theirs;
    Winner winner = Winner::Nobody;  ///< until both are the same
    bool is_asked_for = false;       ///< the controller is to take ours
  };

  [[nodiscard]] Winner winnerOf(const ComparedEntry& entry, const Memory* before, bool theirs_changed) const;
  void decide(const ComparedEntry& entry, Winner winner, const tables::DataTables& ours,
              const ProjectValues& theirs, SyncLook& look) const;

  ExchangeRules rules_;
  std::map<std::pair<tables::Kind, int>, Memory> memory_;
};

}  // namespace cobot_command::command
