// What the reports of robots and mechanisms have alike.
#pragma once

#include <cstdint>
#include <string>

#include "agent/program_walk.h"
#include "agent/state_watch.h"

#include "cobot_command/cell/artifact/artifact.h"
#include "cobot_command/cell/supervision/report.h"

namespace cobot_command::cell {

/// Who tells, how far its program is, and to which supervisor.
[[nodiscard]] inline RobotReport headOf(const std::string& name, const Artifact& artifact,
                                        std::uint64_t session, const StateWatch& states,
                                        const ProgramWalk& walk) {
  RobotReport report;
  report.robot = name;
  report.hash = artifact.digest;
  report.session = session;
  report.instance = states.instance();
  report.events = walk.untold();
  report.place = walk.place().name;
  return report;
}

}  // namespace cobot_command::cell
