// Guides a run_program goal: it has the program of the robot, and decides when each frame of it may be sent.
// Blocks and the core have no knowledge of cells; the permits of a cell arrive through this interface
// (cell/agent).
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

/// The request of a run_program goal.
struct ProgramRequest {
  std::vector<std::string> paths;  ///< in this order; empty: the whole program
  int cycles = 1;                  ///< 0: until it is cancelled or finished
};

/// One script frame of a program, and the actions after the robot has stopped at its end.
struct ProgramFrame {
  std::vector<std::string> lines;  ///< exactly the lines to send, without queue tag
  bool stands = true;              ///< the robot stops at its end; false: it continues into the next frame
  std::optional<SetOutputGoal> output;
  std::optional<WaitForInputGoal> input;
  double dwell = 0;  ///< [s]
};

/// State of a program.
struct ProgramStand {
  /// Why the program waits for a permit.
  enum class Reason : std::uint8_t { None, ZoneHeld, WouldBlock, Aged, Quarantined, Holding, Scheduled };

  std::string place;  ///< place in the program, for people
  std::string path;   ///< empty: at a station
  int step = -1;      ///< of the path, from 0; -1: none
  int cycle = 1;      ///< from 1
  bool is_permitted = false;
  Reason reason = Reason::None;
  std::vector<std::string> blocked_by;  ///< robots that block it
  int place_in_queue = 0;               ///< 1: next
  Duration waiting{};
  std::string text;     ///< for people
  int cycles_done = 0;  ///< complete ones
};

/// All functions except objectionTo() are called on the core's thread.
class ProgramGuide {
 public:
  virtual ~ProgramGuide() = default;

  /// Why the request does not fit this program, whatever the state of its robot; nullopt: it fits. Callable
  /// from any thread.
  [[nodiscard]] virtual std::optional<Failure> objectionTo(const ProgramRequest& request) const = 0;

  /// The goal's turn has come. Returns why the program cannot begin; nullopt: it has begun.
  [[nodiscard]] virtual std::optional<Failure> begin(const ProgramRequest& request, Instant now) = 0;
  /// The frame that may be sent now, as far as is known; the gate checks it again when it is sent. nullptr:
  /// none.
  [[nodiscard]] virtual const ProgramFrame* permitted() const = 0;
  /// The permitted frame was sent.
  virtual void sent(Instant now) = 0;
  /// The permitted frame was not sent because the gate refused it: its permit is checked again.
  virtual void refused(Instant now) = 0;
  /// The next frame may follow: this one was accepted and continues into the next one, or it and all actions
  /// after it are done.
  virtual void done(Instant now) = 0;
  /// Everything that was requested is done.
  [[nodiscard]] virtual bool isOver() const = 0;
  /// Why the program cannot continue.
  [[nodiscard]] virtual const std::optional<Failure>& failure() const = 0;
  /// True: the robot must be stopped because of the failure.
  [[nodiscard]] virtual bool stopsRobot() const = 0;
  /// No further cycle is begun.
  virtual void finish() = 0;
  /// Nothing more of the program is sent; what is not done stays undone. Returns the time that it waited for
  /// permits, for each of its last CycleWaits::kMost cycles.
  virtual std::vector<Duration> end(Instant now) = 0;

  [[nodiscard]] virtual ProgramStand stand(Instant now) const = 0;
  /// When its state changes by time alone; nullopt: never.
  [[nodiscard]] virtual std::optional<Instant> nextDeadline() const = 0;
};

using ProgramGuidePtr = std::shared_ptr<ProgramGuide>;

}  // namespace cobot_command::blocks
