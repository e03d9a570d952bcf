// What the parts of the arbiter use of the core.
#pragma once

#include <vector>

#include "board/output_board.h"
#include "connecting/link_keeper.h"
#include "exchange/exchange_desk.h"
#include "exchange/motion_hold.h"
#include "exchange/motion_permit.h"
#include "forecast/forecast.h"
#include "paths/path_desk.h"
#include "runs/jog_desk.h"
#include "sync/sync_guard.h"

#include "cobot_command/command/actions.h"
#include "cobot_command/command/speed_override.h"
#include "cobot_command/link/script_link.h"
#include "cobot_command/link/tag_ledger.h"
#include "cobot_command/robot/robot_watch.h"
#include "cobot_command/tables/table_store.h"

namespace cobot_command::command {

/// All of them live longer than who has this.
struct CoreParts {
  const link::LinkSettings& settings;
  link::ScriptLink& script;
  link::TagLedger& tags;
  robot::RobotWatch& robot;
  tables::TableStore& tables;
  SpeedOverride& speed;
  PathDesk& paths;
  JogDesk& jog;
  LinkKeeper& keeper;
  ExchangeDesk& exchange;
  SyncDesk& sync;
  SyncGuard& guard;
  MotionPermit& permit;
  MotionHold& hold;
  Forecast& forecast;
  OutputBoard& board;
  std::vector<Action>& actions;
};

}  // namespace cobot_command::command
