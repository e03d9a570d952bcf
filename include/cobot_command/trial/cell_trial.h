// A whole cell in invented time, in one process: for each robot the command core, its agent and a simulated
// controller on one wire, beside them the supervisor, and a measure of how far the arms really are from each
// other.
//
// For tm_cell simulate and for tests. Everything is as in the nodes, but for sockets, threads and ROS. The
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
  bool by_schedule = false;                ///< robots take turns on the zones, by the shortest cycle of all
  int cycles = 3;                          ///< of each robot
  std::uint64_t seed = 1;                  ///< of all that is random
  bool is_random = false;                  ///< project speeds of 5..100 %, pauses, and delays of up to 0.2 s
  double loss = 0.0;                       ///< share of the messages that are lost, [0, 1)
  double doubled = 0.0;                    ///< share of those that arrive that do so twice, [0, 1]
  Duration delay{};                        ///< of each message between a robot and the supervisor, at most
  std::vector<std::string> not_streamed;   ///< items of the robots' status
  std::size_t most_records = 100000;       ///< of the supervisor's journal, before it is made anew
  Duration most = std::chrono::hours(24);  ///< invented time, after which it is given up
};

/// What two arms were at least from each other.
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
  bool is_dead = false;             ///< all wait for each other
  std::vector<std::string> faults;  ///< a sentence each
  std::vector<int> cycles;          ///< of each robot
  std::vector<Duration> waited;     ///< of each robot
  Duration makespan{};
  LeastDistance least;
};

class CellTrial {
 public:
  /// A fault is a sentence.
  [[nodiscard]] static Result<std::unique_ptr<CellTrial>, std::string> of(
      std::shared_ptr<const cell::Artifact> artifact, const TrialSettings& settings);
  ~CellTrial();

  /// Until all are connected, and the supervisor is ready. False: it never is.
  bool start();
  /// Sends each robot its goal.
  void runAll(int cycles);
  void pass(Duration duration);
  /// False: that did not come within `most`.
  bool passUntil(const std::function<bool()>& done, Duration most);
  /// start(), runAll(), and until all have ended, or nothing happens any more.
  [[nodiscard]] TrialResult run();

  [[nodiscard]] TrialRobot& robot(cell::RobotIndex index) { return *robots_[index]; }
  [[nodiscard]] std::size_t robots() const { return robots_.size(); }
  [[nodiscard]] TrialMechanism& mechanism(std::size_t index) { return *mechanisms_[index]; }
  [[nodiscard]] bool hasSupervisor() const { return supervision_ != nullptr; }
  /// Precondition, here and below: there is a supervisor.
  [[nodiscard]] cell::Supervision& supervision() { return *supervision_; }
  [[nodiscard]] cell::CellStatus status() const { return supervision_->status(now_); }
  [[nodiscard]] const LeastDistance& least() const { return least_; }
  [[nodiscard]] Instant now() const { return now_; }
  /// The supervisor is gone: it neither hears nor tells. Started anew, it reads its journal.
  void killSupervisor() { supervision_.reset(); }
  void startSupervisor();
  [[nodiscard]] const std::string& journal() const { return journal_; }
  /// The disk is full behind so many bytes of the journal: of a record that does not fit, only that is
  /// written which does. Nothing: there is room.
  void limitJournal(std::optional<std::size_t> bytes) { journal_limit_ = bytes; }
  /// Nothing of that robot is heard, and nothing comes to it.
  void cut(cell::RobotIndex robot, bool is_cut) { cut_[robot] = is_cut; }
  /// Told with each event that was carried out.
  std::function<void(const TrialEvent&)> observer;

 private:
  class Mail;

  CellTrial(std::shared_ptr<const cell::Artifact> artifact, const TrialSettings& settings);
  bool append(const std::string& line);
  bool replace(const std::string& line);
  /// If it is due, or something has changed.
  void tellNews(bool is_due);
  /// To what happens next. False: nothing does until then.
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
