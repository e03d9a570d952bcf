// A node handle for what a node itself publishes, serves and listens to.
//
// Two things of a node can come to one name: somebody has renamed one of them. roscpp then throws where both
// are subscriptions, and else goes on without a word to the caller: a topic that cannot be published on,
// which is an assertion as soon as it is tried, a service that nobody answers, a topic of two types.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include <ros/exceptions.h>
#include <ros/message_traits.h>
#include <ros/node_handle.h>
#include <ros/parameter_adapter.h>

namespace cobot_command::ros_adapter {

/// Another thing of this node has the name already.
class NameTaken : public ros::Exception {
 public:
  using ros::Exception::Exception;
};

/// Throws NameTaken where roscpp cannot do as it is asked. A node that is shut down meanwhile gets nothing,
/// as of roscpp. From any thread.
class OwnHandle : public ros::NodeHandle {
 public:
  using ros::NodeHandle::NodeHandle;
  OwnHandle(const ros::NodeHandle& node) : ros::NodeHandle(node) {}  // NOLINT(google-explicit-constructor)

  /// For what a library publishes and listens to, and does not tell.
  void requireType(const std::string& name, const std::string& type) const;

  template <class Message, class... Rest>
  ros::Publisher advertise(const std::string& name, Rest&&... rest) {
    auto publisher = ros::NodeHandle::advertise<Message>(name, std::forward<Rest>(rest)...);
    requireHad(static_cast<bool>(publisher), "published on", name);
    requireType(name, ros::message_traits::datatype<Message>());
    return publisher;
  }

  template <class Message, class... Rest>
  ros::Subscriber subscribe(const std::string& name, Rest&&... rest) {
    return subscribed<Message>(
        name, [&] { return ros::NodeHandle::subscribe<Message>(name, std::forward<Rest>(rest)...); });
  }
  template <class Taken, class Owner>
  ros::Subscriber subscribe(const std::string& name, std::uint32_t queue_size, void (Owner::*take)(Taken),
                            Owner* owner, const ros::TransportHints& hints = ros::TransportHints()) {
    return subscribed<typename ros::ParameterAdapter<Taken>::Message>(
        name, [&] { return ros::NodeHandle::subscribe(name, queue_size, take, owner, hints); });
  }

  template <class... Rest>
  ros::ServiceServer advertiseService(const std::string& name, Rest&&... rest) {
    auto service = ros::NodeHandle::advertiseService(name, std::forward<Rest>(rest)...);
    requireHad(static_cast<bool>(service), "served", name);
    return service;
  }

 private:
  template <class Message, class Subscribe>
  ros::Subscriber subscribed(const std::string& name, const Subscribe& subscribe) {
    ros::Subscriber subscriber;
    try {
      subscriber = subscribe();
    } catch (const ros::ConflictingSubscriptionException&) {  // it tells the types, and not the name
    }
    requireHad(static_cast<bool>(subscriber), "listened to", name);
    noteHeard(name, ros::message_traits::datatype<Message>());
    return subscriber;
  }

  void requireHad(bool is_there, const char* what_for, const std::string& name) const;
  void noteHeard(const std::string& name, const std::string& type) const;
};

}  // namespace cobot_command::ros_adapter
