// Who leads a run_program goal: knows the program of the robot, and when each frame of it may leave. Blocks
// and the core know nothing of cells; what a cell grants comes through here (cell/agent).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "cobot_command/blocks/set_output.h"
#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/blocks/waits/wait_for_input.h"
#include "cobot_command/common/time.h"

namespace cobot_command::blocks {

/// What a run_program goal asks for.
struct ProgramRequest {
  std::vector<std::string> paths;  ///< in this order; empty: the whole program
  int cycles = 1;                  ///< 0: until it is cancelled, or finished
};

/// One script frame of a program, and what follows once the robot stands at its end.
struct ProgramFrame {
  std::vector<std::string> lines;  ///< exactly what leaves, without queue tag
  bool stands = true;              ///< false: it goes over into the next one
  std::optional<SetOutputGoal> output;
  std::optional<WaitForInputGoal> input;
  double dwell = 0;  ///< [s]
};

/// How a program stands.
struct ProgramStand {
  /// Why it waits for a permit.
  enum class Reason : std::uint8_t { None, ZoneHeld, WouldBlock, Aged, Quarantined, Holding, Scheduled };

  std::string place;  ///< in the program, for people
  std::string path;   ///< empty: at a station
  int step = -1;      ///< of the path, from 0; -1: none
  int cycle = 1;      ///< from 1
  bool is_permitted = false;
  Reason reason = Reason::None;
  std::vector<std::string> blocked_by;  ///< robots
  int place_in_queue = 0;               ///< 1: next
  Duration waiting{};
  std::string text;     ///< for people
  int cycles_done = 0;  ///< whole ones
};

/// All but objectionTo() on the core's thread.
class ProgramGuide {
 public:
  virtual ~ProgramGuide() = default;

  /// Why it is no request for this program, whatever its robot is at. From any thread.
  [[nodiscard]] virtual std::optional<Failure> objectionTo(const ProgramRequest& request) const = 0;

  /// Its turn has come. Why it cannot begin; nothing: it has begun.
  [[nodiscard]] virtual std::optional<Failure> begin(const ProgramRequest& request, Instant now) = 0;
  /// That may leave now, as far as is known; the gate looks again at that instant. nullptr: none.
  [[nodiscard]] virtual const ProgramFrame* permitted() const = 0;
  /// What was permitted has left.
  virtual void sent(Instant now) = 0;
  /// It has not left, as the gate has refused it: whether it is permitted is looked at anew.
  virtual void refused(Instant now) = 0;
  /// The next frame may follow: this one was accepted and goes over into it, or it was done, and all behind
  /// it.
  virtual void done(Instant now) = 0;
  /// All that was asked for has been done.
  [[nodiscard]] virtual bool isOver() const = 0;
  /// Why it cannot go on.
  [[nodiscard]] virtual const std::optional<Failure>& failure() const = 0;
  /// The robot has to be stopped for that.
  [[nodiscard]] virtual bool stopsRobot() const = 0;
  /// No other cycle is begun.
  virtual void finish() = 0;
  /// Nothing of it is sent any more; what was not done stays undone. How long it has waited for permits, in
  /// each of its last CycleWaits::kMost cycles.
  virtual std::vector<Duration> end(Instant now) = 0;

  [[nodiscard]] virtual ProgramStand stand(Instant now) const = 0;
  /// When something of it changes by time alone.
  [[nodiscard]] virtual std::optional<Instant> nextDeadline() const = 0;
};

using ProgramGuidePtr = std::shared_ptr<ProgramGuide>;

}  // namespace cobot_command::blocks
