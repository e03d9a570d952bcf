// What everyone may know of the core: the latched status and the active frames, told when they are others
// than before.
#pragma once

#include <string>
#include <vector>

#include "arbiter/arbiter.h"
#include "board/output_board.h"
#include "connecting/link_keeper.h"
#include "forecast/forecast.h"
#include "links/links.h"

#include "cobot_command/command/actions.h"
#include "cobot_command/link/tag_ledger.h"
#include "cobot_command/robot/robot_watch.h"
#include "cobot_command/robot/stranger_watch.h"

namespace cobot_command::command {

class StatusDesk {
 public:
  /// Parts of the core; all have to live longer.
  struct Parts {
    const Links& links;
    const link::TagLedger& tags;
    const robot::RobotWatch& robot;
    const robot::StrangerWatch& strangers;
    const OutputBoard& board;
    const LinkKeeper& keeper;
    const Forecast& forecast;
    const Arbiter& arbiter;
  };

  StatusDesk(const Parts& parts, std::vector<Action>& actions) : parts_(parts), actions_(actions) {}

  /// To be called behind each event.
  void tell();
  /// As told last.
  [[nodiscard]] int queueDepth() const { return told_.queue_depth; }

 private:
  [[nodiscard]] std::string diagnosis() const;
  void describe(CommandStatus& status) const;
  void tellStatus();
  void tellFrames();

  Parts parts_;
  std::vector<Action>& actions_;
  CommandStatus status_;  ///< of now
  CommandStatus told_;
  robot::ActiveFrames told_frames_;
};

}  // namespace cobot_command::command
