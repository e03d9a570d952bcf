// The tables of one robot where they are changed: who uses an entry, and that nobody writes it meanwhile.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cobot_command/tables/data_tables.h"

namespace cobot_command::tables {

/// Who uses which entries; number 0 needs no mention. A tool that is used uses its load, a frame its
/// reference.
struct Use {
  std::string user;  ///< for texts: "load_path 7"
  std::vector<int> tools;
  std::vector<int> frames;
};

/// As long as it, or a copy of it, is there, the entries are in use.
using Hold = std::shared_ptr<const Use>;

/// What the controller's project has, by its names.
struct ProjectPoses {
  std::map<std::string, arm::Pose> tools;   ///< in the flange
  std::map<std::string, arm::Pose> frames;  ///< in the robot base
};

class TableStore {
 public:
  explicit TableStore(DataTables tables = {}, Payload payload = {});

  [[nodiscard]] const DataTables& tables() const { return tables_; }
  /// With the poses of entries that only the project knows, as far as those are known.
  [[nodiscard]] DataTables forPlans() const;
  /// What is known of the project from now on.
  void know(ProjectPoses project) { project_ = std::move(project); }
  [[nodiscard]] const Payload& payload() const { return payload_; }
  /// All at once, whoever uses what: for what is read at the start.
  void replace(DataTables tables);

  [[nodiscard]] Hold hold(Use use);
  /// The first of them; nothing when nobody does.
  [[nodiscard]] std::optional<std::string> userOf(Kind kind, int index) const;

  /// The tables as they would be, and nothing is changed yet; or why not. Entries in use are refused.
  [[nodiscard]] Result<DataTables, Refusal> withTool(int index, std::optional<Tool> tool) const;
  [[nodiscard]] Result<DataTables, Refusal> withFrame(int index, std::optional<Frame> frame) const;
  [[nodiscard]] Result<DataTables, Refusal> withLoad(int index, std::optional<Load> load) const;

  /// The same, and they are so from now on.
  [[nodiscard]] std::optional<Refusal> writeTool(int index, std::optional<Tool> tool);
  [[nodiscard]] std::optional<Refusal> writeFrame(int index, std::optional<Frame> frame);
  [[nodiscard]] std::optional<Refusal> writeLoad(int index, std::optional<Load> load);

 private:
  [[nodiscard]] std::optional<Refusal> inUse(Kind kind, int index) const;
  [[nodiscard]] bool uses(const Use& use, Kind kind, int index) const;
  [[nodiscard]] Result<DataTables, Refusal> unlessUsed(Kind kind, int index, DataTables changed,
                                                       std::optional<Refusal> refusal) const;
  std::optional<Refusal> take(Result<DataTables, Refusal> changed);

  DataTables tables_;
  Payload payload_;
  ProjectPoses project_;
  std::vector<std::weak_ptr<const Use>> uses_;
};

}  // namespace cobot_command::tables
