// The monitor behind its façade.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "monitor/alarm.h"
#include "monitor/body_set.h"
#include "monitor/mechanism_track.h"
#include "monitor/pair_watch.h"
#include "monitor/robot_track.h"
#include "monitor/track.h"

#include "cobot_command/cell/monitor/monitor.h"

namespace cobot_command::cell {

class Monitor::Parts {
 public:
  Parts(std::vector<WatchedRobot> robots, const std::vector<WatchedObstacle>& obstacles,
        const MonitorSettings& settings, std::vector<WatchedMechanism> mechanisms);

  void take(const std::string& robot, const arm::JointVector& joints,
            const std::optional<arm::JointVector>& velocities, Duration age, Instant now);
  void takePosition(const std::string& mechanism, double position, Duration age, Instant now);
  bool setCarried(const std::string& robot, const std::optional<Carried>& parts);
  bool setPermit(const std::string& mover, const std::optional<Permit>& permit);
  void tick(Instant now);
  ResetAnswer reset(Instant now);

  std::vector<MonitorAction> takeActions() { return alarm_.takeActions(); }
  [[nodiscard]] MonitorStatus status() const;
  [[nodiscard]] std::vector<SeenBodies> bodies() const;
  [[nodiscard]] bool latched() const { return alarm_.latched(); }
  [[nodiscard]] std::vector<Breach> breaches() const;
  [[nodiscard]] std::optional<Instant> nextDeadline() const;

 private:
  /// A robot or a mechanism.
  struct Mover {
    std::string name;
    std::unique_ptr<monitor::Track> track;
    bool silent = false;  ///< it moved, and its data is stale
    std::optional<Permit> permit = std::nullopt;
  };
  struct Obstacle {
    std::string name;
    monitor::BodySet set;
  };

  void pairUp(std::size_t robots);
  void count(monitor::Track::Taken taken, Instant now);
  void judgeAge(Mover& mover, Instant now);
  void judge(monitor::PairWatch& pair, Instant now);
  /// By all that it may have done since it was measured.
  void grow(Mover& mover, Instant now);
  /// The same within `prompt` alone, as fast as it may be.
  void growPromptly(Mover& mover, Instant now);
  [[nodiscard]] bool areKeptApart(const monitor::PairWatch& pair) const;
  /// Precondition: they are. Takes back what is uncertain only as the data is older than `prompt`.
  void boundByPermits(monitor::PairWatch& pair, Instant now);
  void begin(monitor::PairWatch& pair, Instant now);
  void end(monitor::PairWatch& pair, Instant now);

  [[nodiscard]] const monitor::BodySet& setOf(std::size_t thing) const;
  [[nodiscard]] const std::string& nameOf(std::size_t thing) const;
  [[nodiscard]] bool isHeard(std::size_t thing) const;
  /// Precondition: the gap is of the bodies of now.
  [[nodiscard]] monitor::Names bodiesOf(const monitor::PairWatch& pair) const;
  [[nodiscard]] std::string bodyName(std::size_t thing, std::size_t body) const;
  [[nodiscard]] std::string sentenceOf(const monitor::PairWatch& pair, double limit,
                                       const char* limit_name) const;
  [[nodiscard]] PairStatus statusOf(const monitor::PairWatch& pair) const;
  [[nodiscard]] std::string diagnosis() const;
  [[nodiscard]] std::string closest() const;
  [[nodiscard]] std::vector<std::string> causes() const;
  [[nodiscard]] std::string staleSentence(const Mover& mover) const;

  MonitorSettings settings_;
  double stop_distance_;
  std::vector<Mover> movers_;  ///< robots, then mechanisms
  std::map<std::string, monitor::RobotTrack*> robots_;
  std::map<std::string, monitor::MechanismTrack*> mechanisms_;
  std::vector<Obstacle> obstacles_;
  std::vector<monitor::PairWatch> pairs_;
  monitor::Alarm alarm_;
  std::deque<Breach> ended_;
  MonitorCounts counts_;
  std::optional<Instant> ticked_;
  std::optional<Instant> news_;  ///< since the last tick, the first
};

}  // namespace cobot_command::cell
