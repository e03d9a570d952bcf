#include "supervision/people_services.h"

#include <chrono>
#include <string>
#include <utility>

#include "shared/core_answer.h"
#include <boost/function.hpp>
#include <ros/console.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::ros_adapter {
namespace {

/// A disk that is busy answers sooner.
constexpr std::chrono::seconds kAnsweredWithin(10);
constexpr const char* kDiskBusy =
    "the disk of the journal has not answered for 10 s: the request is done when it does, and the state "
    "shows it";
constexpr const char* kSupervisorClosed = "the supervisor is shutting down";
constexpr const char* kStopped = "all robots are being stopped; they keep their zones";

}  // namespace

PeopleServices::PeopleServices(const ros::NodeHandle& node, ros::CallbackQueueInterface& stops,
                               ros::CallbackQueueInterface& questions, Ports ports)
    : ports_(std::move(ports)) {
  OwnHandle stopping(node);
  stopping.setCallbackQueue(&stops);
  using Trigger = std_srvs::Trigger;
  const boost::function<bool(Trigger::Request&, Trigger::Response&)> stop = [this](auto& /*request*/,
                                                                                   auto& response) {
    ports_.stop();
    response.success = 1;
    response.message = kStopped;
    ROS_INFO_STREAM("stop: " << kStopped);
    return true;
  };
  servers_.push_back(stopping.advertiseService("stop", stop));

  OwnHandle asking(node);
  asking.setCallbackQueue(&questions);
  serve<std_srvs::SetBool>(asking, "hold", [](const auto& request) -> Question {
    return [on = request.data != 0](auto& core, Instant now) { return core.hold(on, now); };
  });
  serve<std_srvs::SetBool>(asking, "finish", [](const auto& request) -> Question {
    return [on = request.data != 0](auto& core, Instant now) { return core.finish(on, now); };
  });
  serve<cobot_command::RecoverRobot>(asking, "recover", [](const auto& request) -> Question {
    return [request, person = foreignText(request.person, kQuoteLimit)](auto& core, Instant now) {
      return core.recover(request.robot, request.place, person, now);
    };
  });
  serve<cobot_command::ConfirmClear>(asking, "confirm_clear", [](const auto& request) -> Question {
    return [request, person = foreignText(request.person, kQuoteLimit)](auto& core, Instant now) {
      return core.confirmClear(request.robot, person, request.was_moved != 0, now);
    };
  });
  serve<cobot_command::TakeOut>(asking, "take_out", [](const auto& request) -> Question {
    return [request, person = foreignText(request.person, kQuoteLimit)](auto& core, Instant now) {
      return core.takeOut(request.robot, person, now);
    };
  });
}

template <class Service, class Ask>
void PeopleServices::serve(OwnHandle& node, const char* name, Ask ask) {
  using Request = typename Service::Request;
  using Response = typename Service::Response;
  const boost::function<bool(Request&, Response&)> answer = [this, name, ask](Request& request,
                                                                              Response& response) {
    const cell::PersonsAnswer answered = answerTo(ask(request));
    response.success = static_cast<std::uint8_t>(answered.success);
    response.message = forPeople(answered.message);
    ROS_INFO_STREAM(name << ": " << forPeople(answered.message));
    return true;
  };
  servers_.push_back(node.advertiseService(name, answer));
}

cell::PersonsAnswer PeopleServices::answerTo(Question question) const {
  std::string why;
  const auto answer =
      answerOf(ports_.ask(std::move(question)), why, kDiskBusy, kAnsweredWithin, kSupervisorClosed);
  return answer.value_or(cell::PersonsAnswer{false, why});
}

}  // namespace cobot_command::ros_adapter
