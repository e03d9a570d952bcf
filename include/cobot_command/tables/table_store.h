// The tables of one robot, with writing. Tracks which entries are in use, so that these are not overwritten.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cobot_command/tables/data_tables.h"

namespace cobot_command::tables {

/// The user of some entries; number 0 need not be listed. Using a tool includes its load, using a frame its
/// reference.
struct Use {
  std::string user;  ///< for texts: "load_path 7"
  std::vector<int> tools;
  std::vector<int> frames;
};

/// The entries are in use as long as this or a copy of it exists.
using Hold = std::shared_ptr<const Use>;

/// The poses in the controller's project, by name.
struct ProjectPoses {
  std::map<std::string, arm::Pose> tools;   ///< in the flange
  std::map<std::string, arm::Pose> frames;  ///< in the robot base
};

class TableStore {
 public:
  explicit TableStore(DataTables tables = {}, Payload payload = {});

  [[nodiscard]] const DataTables& tables() const { return tables_; }
  /// The tables, completed with the known poses of the controller's project.
  [[nodiscard]] DataTables forPlans() const;
  /// Sets the known poses of the project.
  void know(ProjectPoses project) { project_ = std::move(project); }
  [[nodiscard]] const Payload& payload() const { return payload_; }
  /// Replaces everything, also entries in use. For the tables read at the start.
  void replace(DataTables tables);

  [[nodiscard]] Hold hold(Use use);
  /// The first user of the entry; std::nullopt if there is none.
  [[nodiscard]] std::optional<std::string> userOf(Kind kind, int index) const;

  /// The tables as they would be after the change, or the refusal. Changes nothing. Entries in use are
  /// refused.
  [[nodiscard]] Result<DataTables, Refusal> withTool(int index, std::optional<Tool> tool) const;
  [[nodiscard]] Result<DataTables, Refusal> withFrame(int index, std::optional<Frame> frame) const;
  [[nodiscard]] Result<DataTables, Refusal> withLoad(int index, std::optional<Load> load) const;

  /// The same, and the change is applied.
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
