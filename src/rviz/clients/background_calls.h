// Calls of services beside the user interface: a node that hangs does not hold it up.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <ros/service.h>

namespace cobot_command::rviz_plugin {

class BackgroundCalls {
 public:
  BackgroundCalls();
  BackgroundCalls(const BackgroundCalls&) = delete;
  BackgroundCalls& operator=(const BackgroundCalls&) = delete;
  /// Waits for nobody: what a call that hangs would have brought is dropped.
  ~BackgroundCalls();

  /// `job` runs on the other thread, behind those that came before, and what it returns in deliver(). One
  /// whose turn does not come within a second is dropped, as a call that comes late may surprise people, and
  /// `dropped` is delivered.
  void post(std::function<std::function<void()>()> job, std::function<void()> dropped = nullptr);
  /// On the thread of the user interface, often.
  void deliver();

  /// `then` gets whether there was an answer, and the answer.
  template <class Service>
  void call(const std::string& name, Service service, std::function<void(bool, const Service&)> then) {
    post(
        [name, service, then]() mutable -> std::function<void()> {
          const bool answered = ros::service::call(name, service);
          return [answered, service, then] { then(answered, service); };
        },
        [service, then] { then(false, service); });
  }

 private:
  struct Shared;

  std::shared_ptr<Shared> shared_;
};

}  // namespace cobot_command::rviz_plugin
