#include "supervision/robot_contact.h"

#include <ros/console.h>
#include <ros/names.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {
namespace {

constexpr Duration kTellAgain = std::chrono::milliseconds(250);
/// For the connection to a node that has just come up. One that comes later is another story, unless the
/// robot moves still.
constexpr Duration kReachableWithin = std::chrono::seconds(5);

}  // namespace

void RobotContact::heardFrom(const std::string& publisher, bool moving, Instant now) {
  std::string fault;
  if (publisher != publisher_ && ros::names::validate(publisher, fault)) {
    publisher_ = publisher;
    space_ = ros::names::parentNamespace(publisher);
    stops_.moveTo(space_);
    MadeBeside<ProgramClient>& programs = programs_[space_];
    if (!programs.get()) {
      programs.begin([node = node_, action = ros::names::append(space_, "run_program")] {
        return std::make_shared<ProgramClient>(node, action);
      });
    }
    stop_told_.reset();  // the one before was told, and not this one
    ordered_at_ = now;
  }
  moves_ = moving;
  if (stop_told_ && now > *stop_told_ && !moving) is_stopping_ = false;
}

void RobotContact::stop(Instant now) {
  is_stopping_ = true;
  ordered_at_ = now;
  stop_told_.reset();
  settle(now);
}

void RobotContact::settle(Instant now) {
  if (is_stopping_ && !stop_told_ && !moves_ && now > ordered_at_ + kReachableWithin) {
    is_stopping_ = false;
    ROS_ERROR_STREAM("no stop could be sent for " << foreignText(publisher_, kQuoteLimit)
                                                  << ": no node subscribes to its stop");
  }
  if (!is_stopping_ || (stop_told_ && now < *stop_told_ + kTellAgain)) return;
  if (!stops_.isConnected()) return;
  stop_told_ = now;
  stops_.send();
}

std::shared_ptr<RobotContact::ProgramClient> RobotContact::programs() const {
  const auto known = programs_.find(space_);
  auto programs = being_made == 0 && known != programs_.end() ? known->second.get() : nullptr;
  return programs && programs->isServerConnected() ? programs : nullptr;
}

}  // namespace cobot_command::ros_adapter
