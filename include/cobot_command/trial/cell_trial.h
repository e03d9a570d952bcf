// A complete cell in simulated time, in one process: the command core, the agent and a simulated controller
// of each robot, the supervisor, and a measurement of the actual distances between the arms.
//
// For tm_cell simulate and for tests. Everything works as in the nodes, except sockets, threads and ROS. The
// same seed gives the same run.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cobot_command/blocks/shared/outcome.h"
#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/supervision/cell_state.h"
#include "cobot_command/cell/supervision/supervision.h"
#include "cobot_command/common/result.h"
#include "cobot_command/common/time.h"
#include "cobot_command/trial/trial_mechanism.h"
#include "cobot_command/trial/trial_robot.h"

namespace cobot_command::trial {

struct TrialSettings {
  cell::Policy policy = cell::Policy::Supervisor;
  bool by_schedule = false;  ///< robots take turns on the zones according to the shortest cycle of all
  int cycles = 3;            ///< per robot
  std::uint64_t seed = 1;    ///< of all random effects
  bool is_random = false;    ///< project speeds of 5..100 %, pauses, and delays of up to 0.2 s
  double loss = 0.0;         ///< ratio of lost messages, [0, 1)
  double doubled = 0.0;      ///< ratio of received messages that are received twice, [0, 1]
  Duration delay{};          ///< largest delay of a message between a robot and the supervisor
  std::vector<std::string> not_streamed;   ///< status items that the robots do not have
  std::size_t most_records = 100000;       ///< of the supervisor's journal, before it is compacted
  Duration most = std::chrono::hours(24);  ///< simulated time after which the run is aborted
};

/// The smallest distance between two arms.
struct LeastDistance {
  std::string robot;
  std::string other;
  double distance = std::numeric_limits<double>::infinity();  ///< [m]
};

struct TrialEvent {
  Instant at;
  std::string text;  ///< "RA: HOME>T1 +1 at 3.2 s"
};

struct TrialResult {
  bool all_done = false;
  bool is_dead = false;             ///< all robots wait for each other
  std::vector<std::string> faults;  ///< one sentence each
  std::vector<int> cycles;          ///< per robot
  std::vector<Duration> waited;     ///< per robot
  Duration makespan{};
  LeastDistance least;
};

class CellTrial {
 public:
  /// A fault is a sentence.
  [[nodiscard]] static Result<std::unique_ptr<CellTrial>, std::string> of(
      std::shared_ptr<const cell::Artifact> artifact, const TrialSettings& settings);
  ~CellTrial();

  /// Runs until all robots are connected and the supervisor is ready. Returns false if that does not happen.
  bool start();
  /// Sends a goal to each robot.
  void runAll(int cycles);
  void pass(Duration duration);
  /// Returns false if the condition was not met within `most`.
  bool passUntil(const std::function<bool()>& done, Duration most);
  /// start(), runAll(), then runs until all goals have ended or nothing happens any more.
  [[nodiscard]] TrialResult run();

  [[nodiscard]] TrialRobot& robot(cell::RobotIndex index) { return *robots_[index]; }
  [[nodiscard]] std::size_t robots() const { return robots_.size(); }
  [[nodiscard]] TrialMechanism& mechanism(std::size_t index) { return *mechanisms_[index]; }
  [[nodiscard]] bool hasSupervisor() const { return supervision_ != nullptr; }
  /// Precondition, here and below: the supervisor exists.
  [[nodiscard]] cell::Supervision& supervision() { return *supervision_; }
  [[nodiscard]] cell::CellStatus status() const { return supervision_->status(now_); }
  [[nodiscard]] const LeastDistance& least() const { return least_; }
  [[nodiscard]] Instant now() const { return now_; }
  /// Stops the supervisor: it neither receives nor publishes. After a restart it reads its journal.
  void killSupervisor() { supervision_.reset(); }
  void startSupervisor();
  [[nodiscard]] const std::string& journal() const { return journal_; }
  /// Simulates a full disk after this number of bytes of the journal: a record that does not fit is written
  /// partially. std::nullopt: no limit.
  void limitJournal(std::optional<std::size_t> bytes) { journal_limit_ = bytes; }
  /// Cuts the connection of that robot in both directions.
  void cut(cell::RobotIndex robot, bool is_cut) { cut_[robot] = is_cut; }
  /// Called for each executed event.
  std::function<void(const TrialEvent&)> observer;

 private:
  class Mail;

  CellTrial(std::shared_ptr<const cell::Artifact> artifact, const TrialSettings& settings);
  bool append(const std::string& line);
  bool replace(const std::string& line);
  /// Publishes the state of the supervisor if it is due or has changed.
  void tellNews(bool is_due);
  /// Advances to the next event. Returns false if nothing happens until then.
  bool step(Instant until);
  void stepTo(Instant instant);
  void exchange();
  [[nodiscard]] std::optional<cell::RobotReport> takeReport(cell::RobotIndex user);
  void hear(cell::RobotIndex user, const cell::CellStatus& state, std::uint64_t number);
  void measure();
  void disturb();
  void tellEvents(const cell::CellStatus& status);
  [[nodiscard]] Instant nextEvent() const;
  [[nodiscard]] bool isStuck() const;

  std::shared_ptr<const cell::Artifact> artifact_;
  TrialSettings settings_;
  cell::CellModel model_;
  cell::ZoneOrders turns_;
  std::vector<std::unique_ptr<TrialRobot>> robots_;
  std::vector<std::unique_ptr<TrialMechanism>> mechanisms_;
  std::unique_ptr<cell::Supervision> supervision_;
  std::vector<cell::StopOrder> stop_orders_;
  std::unique_ptr<Mail> mail_;
  std::string journal_;
  std::optional<std::size_t> journal_limit_;
  std::vector<bool> cut_;
  std::vector<std::string> places_;
  std::uint64_t state_number_ = 0;
  std::shared_ptr<const cell::CellStatus> told_;
  Instant now_;
  Instant told_at_{};
  Instant measured_at_{};
  Instant disturbed_at_{};
  Instant changed_at_{};
  LeastDistance least_;
};

}  // namespace cobot_command::trial
