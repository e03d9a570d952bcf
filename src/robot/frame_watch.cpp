#include "cobot_command/robot/frame_watch.h"

#include <tuple>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/overloaded.h"

namespace cobot_command::robot {
namespace {

/// How long the stream may show the old frame of a robot that stands.
constexpr Duration kPatience = std::chrono::seconds(1);

bool same(const std::optional<arm::Pose>& a, const std::optional<arm::Pose>& b) {
  return a.has_value() == b.has_value() && (!a || a->matrix() == b->matrix());
}

template <class Change>
std::pair<std::optional<arm::Pose>, std::string> targetOf(const Change& change, const char* zero_name) {
  if (const auto* values = std::get_if<script::SixNumbers>(&change)) return {arm::toPose(*values), ""};
  const auto& name = std::get<std::string>(change);
  if (name == zero_name) return {arm::Pose::Identity(), name};
  return {std::nullopt, name};
}

}  // namespace

bool operator==(const ActiveFrames& a, const ActiveFrames& b) {
  return same(a.base, b.base) && same(a.tcp, b.tcp) &&
         std::tie(a.base_name, a.tcp_name, a.tool_mass) == std::tie(b.base_name, b.tcp_name, b.tool_mass);
}

void FrameWatch::accepted(const script::ScriptCommand& command, bool behind_motion, Instant now) {
  std::visit(Overloaded{[&](const script::ChangeBase& change) {
                          auto [pose, name] = targetOf(change.base, script::kRobotBase);
                          base_ = Commanded{pose, name, std::nullopt, behind_motion, now};
                        },
                        [&](const script::ChangeTcp& change) {
                          auto [pose, name] = targetOf(change.tcp, script::kNoTool);
                          tcp_ = Commanded{pose, name, change.weight, behind_motion, now};
                        },
                        [](const auto&) {}},
             command);
}

bool FrameWatch::isOver(const Commanded& commanded, const std::optional<arm::Pose>& streamed,
                        const std::optional<std::string>& streamed_name, const RobotWatch& robot,
                        Instant now) {
  if (!streamed) return false;
  const bool shown = commanded.pose ? arm::isSamePose(*commanded.pose, *streamed)
                                    : streamed_name.value_or("") == commanded.name;
  const bool settled = now - commanded.since > kPatience && robot.moving() == false && !robot.held();
  return shown || settled;
}

void FrameWatch::robotChanged(const RobotWatch& robot, Instant now) {
  streamed_ = ActiveFrames{};
  if (!robot.status()) return;
  const link::RobotStatus& status = *robot.status();
  streamed_.base = status.base;
  streamed_.base_name = status.base_name.value_or("");
  streamed_.tcp = robot.tcp();
  streamed_.tcp_name = status.tcp_name.value_or("");
  streamed_.tool_mass = status.tcp_mass;
  if (base_ && isOver(*base_, status.base, status.base_name, robot, now)) base_.reset();
  if (tcp_ && isOver(*tcp_, streamed_.tcp, status.tcp_name, robot, now)) tcp_.reset();
}

void FrameWatch::stopped() {
  if (base_ && base_->behind_motion) base_.reset();
  if (tcp_ && tcp_->behind_motion) tcp_.reset();
}

ActiveFrames FrameWatch::frames() const {
  ActiveFrames frames = streamed_;
  if (base_) {
    frames.base = base_->pose;
    frames.base_name = base_->name;
  }
  if (tcp_) {
    frames.tcp = tcp_->pose;
    frames.tcp_name = tcp_->name;
    frames.tool_mass = tcp_->mass;
  }
  return frames;
}

}  // namespace cobot_command::robot
