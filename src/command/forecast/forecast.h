// What is known of the robot ahead of time: where a command starts that is sent now or behind others, in
// which base, with which TCP and load, and what moves on though no goal waits for it any more.
//
// It is told what goes out and what becomes of it, plans each command from there, and says at once what
// speaks against one.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "forecast/command_order.h"
#include "forecast/plan.h"
#include "forecast/plan_desk.h"
#include "forecast/planned_queue.h"

#include "cobot_command/blocks/list/goal.h"
#include "cobot_command/command/actions.h"
#include "cobot_command/command/speed_override.h"
#include "cobot_command/robot/burden.h"
#include "cobot_command/robot/frame_watch.h"
#include "cobot_command/robot/loose_motion.h"
#include "cobot_command/robot/robot_watch.h"
#include "cobot_command/tables/table_store.h"

namespace cobot_command::command {

class Forecast {
 public:
  /// `arm`: nothing without a model; then nothing is planned. The others have to live longer.
  Forecast(std::shared_ptr<const arm::ArmModel> arm, robot::RobotWatch& robot,
           const tables::TableStore& tables, const SpeedOverride& speed, std::vector<Action>& actions);

  /// As it was given: its geometry, for as long as this lives.
  [[nodiscard]] const arm::ArmModel* arm() const { return arm_.get(); }
  /// With the limits that rule, which every plan is made with; nothing without a model.
  [[nodiscard]] const std::shared_ptr<const arm::ArmModel>& limitedArm() const { return limited_arm_; }
  /// From now on. Precondition: there is a model, and nothing is under way.
  void useLimits(std::shared_ptr<const arm::ArmModel> limited_arm);
  /// Of the speeds of what is planned now.
  [[nodiscard]] double speedShare() const { return speed_.share(); }
  /// That the next command will be taken in.
  [[nodiscard]] robot::ActiveFrames frames() const { return frames_.frames(); }
  /// What the tool holds, as far as it was commanded [kg].
  [[nodiscard]] std::optional<double> load() const { return burden_.load(); }
  /// Motions that no goal waits for.
  [[nodiscard]] const robot::LooseMotion& loose() const { return loose_; }

  // --- Plans.
  /// Where a command starts that is sent now.
  [[nodiscard]] Origin origin(Instant now) const;
  /// Why it is not known where the robot will stand then, for people. Precondition: it is not.
  [[nodiscard]] std::string whyStartUnknown() const;
  /// Why it goes out from there without a plan, for people; empty: it needs none. Precondition: it has none.
  [[nodiscard]] std::string whyUnplanned(const CommandOrder& order, const Origin& origin) const;
  /// The command as it goes out now, without tag and plan; else what speaks against it.
  [[nodiscard]] Result<CommandOrder, blocks::Failure> order(const blocks::Command& command) const;
  /// Its plan takes no time, if it has one.
  [[nodiscard]] bool isPlannedAtOnce(const CommandOrder& order) const;
  /// As it goes out from there. Precondition: it is known what its lines mean.
  [[nodiscard]] std::shared_ptr<PlannedCommand> plan(const CommandOrder& order, const Origin& origin) const;

  // --- The same as work that may be done on another thread: with copies of all it needs.
  /// Looked up when the work begins; nothing: nobody knows.
  using OriginAt = std::function<std::optional<Origin>(Instant now)>;
  [[nodiscard]] PlanDesk::MakeWork workFor(const CommandOrder& order, const Origin& origin) const;
  /// Of a goal that waits and is one command; no plan where its origin is not known.
  [[nodiscard]] PlanDesk::MakeWork workFor(const blocks::Command& command, const OriginAt& origin) const;
  /// Of a goal that is answered by its plan, or planned as a whole.
  /// `scene`: as far as the forecast does not know it.
  [[nodiscard]] PlanDesk::MakeWork workFor(const blocks::Goal& goal, const OriginAt& origin,
                                           const blocks::PlanningScene& scene) const;

  // --- What went out, and what became of it.
  void sent(const CommandOrder& order, Instant now);
  void accepted(const CommandOrder& order, Instant now);
  /// Its tag is complete.
  void arrived(const CommandOrder& order, Instant now);
  /// A status frame came, or the stream stopped. `patience`: for a robot that stands on its way.
  void robotChanged(Duration patience, Instant now);
  /// The robot stands, and its queue is empty.
  void stopped();
  /// Nobody can tell whether it does; `found`: why, `target`: of what was to be stopped.
  void stopFailed(const std::string& found, const std::optional<robot::Target>& target, Instant now);
  /// A stop went out that may have emptied the queue, or not.
  void queueMayBeEmptied();
  /// Where it goes is not known any more.
  void forgetPath() { queue_.forget(); }
  /// Nothing of ours is in the controller's queue.
  void queueDone() { burden_.queueDone(); }
  /// Behind the next connection there may be another robot, or a project that has begun anew.
  void disconnected();

 private:
  void takeBurden(const script::ScriptCommand& command, bool behind_motion);
  void weigh();
  /// For a marker.
  void tellPath(const CommandOrder& order);
  [[nodiscard]] std::optional<arm::Pose> baseAt(const std::optional<Origin>& origin) const;

  std::shared_ptr<const arm::ArmModel> arm_;
  std::shared_ptr<const arm::ArmModel> limited_arm_;
  robot::RobotWatch& robot_;
  const tables::TableStore& tables_;
  const SpeedOverride& speed_;
  std::vector<Action>& actions_;
  PlannedQueue queue_;
  robot::FrameWatch frames_;
  robot::Burden burden_;
  robot::LooseMotion loose_;
};

}  // namespace cobot_command::command
