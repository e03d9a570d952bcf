#include "supervision/people_services.h"

#include <utility>

#include <boost/function.hpp>
#include <ros/console.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {

PeopleServices::PeopleServices(const ros::NodeHandle& node, cell::Supervision& core, Clock clock,
                               std::function<void(Instant now)> settle)
    : clock_(std::move(clock)), settle_(std::move(settle)) {
  OwnHandle handle(node);
  serve<std_srvs::SetBool>(handle, "hold", [&core](const auto& request, Instant now) {
    return core.hold(request.data != 0, now);
  });
  serve<std_srvs::SetBool>(handle, "finish", [&core](const auto& request, Instant now) {
    return core.finish(request.data != 0, now);
  });
  serve<std_srvs::Trigger>(handle, "stop",
                           [&core](const auto& /*request*/, Instant now) { return core.stop(now); });
  serve<cobot_command::RecoverRobot>(handle, "recover", [&core](const auto& request, Instant now) {
    return core.recover(request.robot, request.place, foreignText(request.person, kQuoteLimit), now);
  });
  serve<cobot_command::ConfirmClear>(handle, "confirm_clear", [&core](const auto& request, Instant now) {
    const std::string person = foreignText(request.person, kQuoteLimit);
    return core.confirmClear(request.robot, person, request.was_moved != 0, now);
  });
  serve<cobot_command::TakeOut>(handle, "take_out", [&core](const auto& request, Instant now) {
    return core.takeOut(request.robot, foreignText(request.person, kQuoteLimit), now);
  });
}

template <class Service, class Ask>
void PeopleServices::serve(OwnHandle& node, const char* name, Ask ask) {
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  const boost::function<bool(Request&, Response&)> answer = [this, name, ask](Request& request,
                                                                              Response& response) {
    const Instant now = clock_();
    const cell::PersonsAnswer answered = ask(request, now);
    response.success = static_cast<std::uint8_t>(answered.success);
    response.message = forPeople(answered.message);
    ROS_INFO_STREAM(name << ": " << forPeople(answered.message));
    settle_(now);
    return true;
  };
  servers_.push_back(node.advertiseService(name, answer));
}

}  // namespace cobot_command::ros_adapter
