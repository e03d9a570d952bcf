// What the commands of a script do to the robot, and what their lines wait for.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <optional>
#include <utility>

#include "queue/motion_queue.h"
#include "robot/io_board.h"
#include "robot/project_data.h"
#include "script_port/script_clients.h"
#include "script_port/tag_table.h"

#include "cobot_command/script/script_command.h"
#include "cobot_command/simulator/robot_state.h"
#include "cobot_command/tm_script/environment.h"
#include "cobot_command/tm_script/functions.h"

namespace cobot_command::simulator {

/// The robot, as scripts find it.
struct ScriptedRobot {
  const arm::ArmModel& model;
  MotionQueue& queue;
  IoBoard& io;
  ProjectData& project;
  std::function<RobotState()> state;
};

/// What a line waits for: a tag, or a time.
struct LineWait {
  std::optional<QueuedTag> tag;
  Instant until;
  bool is_question = false;  ///< WaitQueueTag: whether the tag is complete
  bool is_released = false;  ///< a stop has ended it
};

class ScriptCommands {
 public:
  ScriptCommands(const ScriptedRobot& robot, TagTable& tags, FaultSwitches& faults, ScriptClients& clients,
                 tm_script::Version tmflow)
      : queue_(robot.queue),
        io_(robot.io),
        project_(robot.project),
        tags_(tags),
        faults_(faults),
        clients_(clients),
        tmflow_(tmflow) {}

  /// The time at which commands act from now on.
  void setTime(Instant now) { now_ = now; }
  [[nodiscard]] tm_script::CallAnswer perform(const script::ScriptCommand& command);

  /// The queue of motions is bounded, so that no client can fill the memory. A line that does not fit is a
  /// faulty line. Points of PVT count apart: a path has thousands of them.
  static constexpr std::size_t kMostQueued = 1000;
  static constexpr std::size_t kMostPvtPoints = 20000;
  struct Room {
    std::size_t entries = 0;
    std::size_t points = 0;
  };
  [[nodiscard]] Room room() const {
    return {kMostQueued - std::min<std::size_t>(queue_.waiting().size(), kMostQueued),
            kMostPvtPoints - std::min<std::size_t>(queue_.waiting().pvtPoints(), kMostPvtPoints)};
  }

  /// Of the command that was answered Wait; told once.
  [[nodiscard]] std::optional<LineWait> takeWait() { return std::exchange(wait_, std::nullopt); }
  /// Was there a ScriptExit? Told once.
  [[nodiscard]] bool takeExit() { return std::exchange(exited_, false); }

 private:
  template <class Motion>
  tm_script::CallAnswer execute(const Motion& motion);
  tm_script::CallAnswer execute(const script::ChangeBase& change);
  tm_script::CallAnswer execute(const script::ChangeTcp& change);
  tm_script::CallAnswer execute(const script::ChangeLoad& change);
  tm_script::CallAnswer execute(const script::QueueTag& tag);
  tm_script::CallAnswer execute(const script::WaitQueueTag& wait);
  tm_script::CallAnswer execute(const script::StopAndClearBuffer& stop);
  tm_script::CallAnswer execute(const script::Pause& pause);
  tm_script::CallAnswer execute(const script::Resume& resume);
  tm_script::CallAnswer execute(const script::ScriptExit& exit);
  tm_script::CallAnswer execute(const script::WriteOutput& write) { return put(write); }
  tm_script::CallAnswer execute(const script::WriteAnalogOutput& write) { return put(write); }
  tm_script::CallAnswer execute(const script::PvtEnter& enter);
  tm_script::CallAnswer execute(const script::PvtPoint& point);
  tm_script::CallAnswer execute(const script::PvtExit& exit);
  tm_script::CallAnswer execute(const script::PvtPause& pause);
  tm_script::CallAnswer execute(const script::PvtResume& resume);
  tm_script::CallAnswer execute(const script::ContinueVJog& mode);
  tm_script::CallAnswer execute(const script::ContinueVLine& mode);
  tm_script::CallAnswer execute(const script::SetContinueVJog& set);
  tm_script::CallAnswer execute(const script::SetContinueVLine& set);
  tm_script::CallAnswer execute(const script::StopContinueVmode& stop);
  tm_script::CallAnswer execute(const script::SuspendContinueVmode& suspend);
  template <class Output>
  tm_script::CallAnswer put(const Output& write);
  tm_script::CallAnswer set(const Velocity& velocity);
  /// What stands between PVTEnter and PVTExit does not run before the PVT has all its points.
  [[nodiscard]] std::optional<tm_script::CallFailure> withinPvt(const char* what) const;

  MotionQueue& queue_;
  IoBoard& io_;
  ProjectData& project_;
  TagTable& tags_;
  FaultSwitches& faults_;
  ScriptClients& clients_;
  tm_script::Version tmflow_;

  Instant now_{};
  std::optional<LineWait> wait_;
  bool exited_ = false;
};

}  // namespace cobot_command::simulator
