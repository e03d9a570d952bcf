// What can become of frames between a command layer and a controller, as values: a frame in, steps out.
//
// Owns no socket and no clock: fault_proxy.h carries the steps out. The same seed, faults and frames give the
// same steps.
#pragma once

#include <cstddef>
#include <limits>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/common/time.h"
#include "cobot_command/protocol/frame.h"

namespace cobot_command::testing {

enum class Direction { ToController, ToClient };

/// Which frames of its direction a fault strikes.
enum class Which {
  Any,
  Script,     ///< a script, or the reply to one; not the entry message
  Tag,        ///< TMSTA 01: asked, answered or reported
  NodeState,  ///< TMSTA 00: asked or answered
};

enum class FaultKind {
  // What happens to a frame.
  Drop,           ///< for all frames of a direction: a black hole
  Duplicate,      ///< twice in a row
  Echo,           ///< once more, `time` later
  Delay,          ///< `time` later; the order stays
  Overtaken,      ///< `time` later; what follows does not wait
  Swap,           ///< behind the next one that is struck
  ByteByByte,     ///< each byte a segment of its own; with `rate`, so many a second
  Merge,          ///< with all that comes within `time` in one segment
  Cut,            ///< in two parts, with `time` between them
  WrongChecksum,  ///< only so
  WrongChecksumThenGood,
  Garbage,      ///< behind `text`; empty: some bytes that begin no frame
  BadLength,    ///< `text` in place of its LENGTH
  OtherId,      ///< the id of no script
  Cperr,        ///< CPERR `text` in place of it
  AnswerFirst,  ///< to the controller: its client gets `OK` before the controller has the script
  AnswerAhead,  ///< to the controller: its client gets `OK` for the script behind it, too
  Reset,        ///< RST on both sides in place of it
  Close,        ///< FIN on both sides in place of it
  // What happens to a connection; `direction` counts for NeverRead alone, `which`, `first` and `count` for
  // none.
  Refuse,       ///< new ones are refused
  Silence,      ///< new ones lead nowhere, and hear nothing
  CloseAtOnce,  ///< new ones are closed
  NeverRead,    ///< what is sent in this direction is left in the buffers of the system
};

struct Fault {
  FaultKind kind = FaultKind::Drop;
  Direction direction = Direction::ToClient;
  Which which = Which::Any;
  std::size_t first = 0;                                        ///< so many pass before it strikes
  std::size_t count = std::numeric_limits<std::size_t>::max();  ///< so many are struck
  Duration time{};
  Duration jitter{};  ///< so much more or less than `time`, at random
  double rate = 0;    ///< of ByteByByte [1/s]; 0: as fast as it goes
  std::string text;
};

/// What a proxy does next in one direction, one step behind the other.
struct Step {
  enum class Kind {
    Send,
    SendDelayed,    ///< `wait` after it came, not after the step in front of it
    SendOvertaken,  ///< `wait` later, beside the others
    SendMerged,     ///< with what has gathered behind it meanwhile
    Reset,
    Close
  };
  Kind kind = Kind::Send;
  Direction direction = Direction::ToClient;
  std::string bytes;
  Duration wait{};  ///< before it
};

class FrameFaults {
 public:
  explicit FrameFaults(unsigned seed) : random_(seed) {}

  /// Counts frames from now on. When several could strike a frame, the one that was added first does.
  void add(const Fault& fault) { armed_.push_back({fault, 0, 0, {}}); }
  void clear() { armed_.clear(); }
  /// Is there a fault of this kind, whatever it has struck?
  [[nodiscard]] bool has(FaultKind kind) const;
  [[nodiscard]] bool neverReads(Direction direction) const;

  /// What becomes of a frame.
  [[nodiscard]] std::vector<Step> pass(Direction direction, const protocol::Frame& frame);
  /// Frames that were struck.
  [[nodiscard]] std::size_t strikes() const { return strikes_; }

 private:
  struct Armed {
    Fault fault;
    std::size_t seen = 0;
    std::size_t struck = 0;
    std::string held;  ///< Swap: the one that waits for the next
  };

  [[nodiscard]] Armed* striking(Direction direction, const protocol::Frame& frame);
  [[nodiscard]] std::vector<Step> strike(Armed& armed, const protocol::Frame& frame);
  /// What makes more than one frame of it, or none.
  [[nodiscard]] std::vector<Step> several(Armed& armed, const protocol::Frame& frame);
  [[nodiscard]] std::vector<Step> inPieces(const Fault& fault, const std::string& bytes);
  [[nodiscard]] std::string spoilt(const Fault& fault, const protocol::Frame& frame);
  [[nodiscard]] Duration waitOf(const Fault& fault);
  [[nodiscard]] std::size_t upTo(std::size_t last) {
    return std::uniform_int_distribution<std::size_t>(0, last)(random_);
  }

  std::mt19937 random_;
  std::vector<Armed> armed_;
  std::size_t strikes_ = 0;
};

}  // namespace cobot_command::testing
