// A node handle for the topics and services of a node itself.
//
// Two of them can get the same name if one is remapped. roscpp throws if both are subscriptions. Otherwise it
// continues without a message to the caller. The result is a topic on which publishing is a failed assertion,
// a service that is never called, or a topic with two types.
#pragma once

#include <cstdint>
#include <string>
#include <utility>

#include <ros/exceptions.h>
#include <ros/message_traits.h>
#include <ros/node_handle.h>
#include <ros/parameter_adapter.h>

namespace cobot_command::ros_adapter {

/// Another topic or service of this node already has the name.
class NameTaken : public ros::Exception {
 public:
  using ros::Exception::Exception;
};

/// Throws NameTaken if roscpp cannot do what is requested. During a shutdown the returned handle is empty, as
/// with roscpp. Callable from any thread.
class OwnHandle : public ros::NodeHandle {
 public:
  using ros::NodeHandle::NodeHandle;
  OwnHandle(const ros::NodeHandle& node) : ros::NodeHandle(node) {}  // NOLINT(google-explicit-constructor)

  /// For topics that a library publishes or subscribes to without this handle.
  void requireType(const std::string& name, const std::string& type) const;

  template <class Message, class... Rest>
  ros::Publisher advertise(const std::string& name, std::uint32_t queue_size, Rest&&... rest) {
    auto publisher = ros::NodeHandle::advertise<Message>(name, queue_size, std::forward<Rest>(rest)...);
    requireHad(static_cast<bool>(publisher), "published on", name);
    requireType(name, ros::message_traits::datatype<Message>());
    return publisher;
  }

  template <class Message, class... Rest>
  ros::Subscriber subscribe(const std::string& name, std::uint32_t queue_size, Rest&&... rest) {
    return subscribed<Message>(name, [&] {
      return ros::NodeHandle::subscribe<Message>(name, queue_size, std::forward<Rest>(rest)...);
    });
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
    } catch (const ros::ConflictingSubscriptionException&) {  // it contains the types, but not the name
    }
    requireHad(static_cast<bool>(subscriber), "subscribed to", name);
    noteHeard(name, ros::message_traits::datatype<Message>());
    return subscriber;
  }

  void requireHad(bool is_there, const char* what_for, const std::string& name) const;
  void noteHeard(const std::string& name, const std::string& type) const;
};

}  // namespace cobot_command::ros_adapter
