#include "cobot_command/ros/shared/own_handle.h"

#include <map>
#include <mutex>
#include <optional>

#include <fmt/format.h>
#include <ros/init.h>
#include <ros/publication.h>
#include <ros/topic_manager.h>

namespace cobot_command::ros_adapter {
namespace {

/// The types by which this process listens to topics: roscpp tells those of what is published only.
class HeardTypes {
 public:
  static HeardTypes& ofProcess() {
    static HeardTypes types;
    return types;
  }
  void add(const std::string& topic, const std::string& type) {
    const std::lock_guard<std::mutex> lock(mutex_);
    types_.emplace(topic, type);
  }
  std::optional<std::string> of(const std::string& topic) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = types_.find(topic);
    return found == types_.end() ? std::nullopt : std::optional(found->second);
  }

 private:
  std::mutex mutex_;
  std::map<std::string, std::string> types_;
};

std::optional<std::string> publishedType(const std::string& topic) {
  const auto publication = ros::TopicManager::instance()->lookupPublication(topic);
  return publication ? std::optional(publication->getDataType()) : std::nullopt;
}

std::string named(const std::string& name, const std::string& resolved) {
  return fmt::format("{}, named '{}' in this node", resolved, name);
}

}  // namespace

void OwnHandle::requireType(const std::string& name, const std::string& type) const {
  const std::string topic = resolveName(name);
  for (const auto& other : {publishedType(topic), HeardTypes::ofProcess().of(topic)}) {
    if (!other || *other == type) continue;
    throw NameTaken(
        fmt::format("{}, has the type {}: this node already uses the name for something else, of type {}",
                    named(name, topic), type, *other));
  }
}

void OwnHandle::requireHad(bool is_there, const char* what_for, const std::string& name) const {
  if (is_there || ros::isShuttingDown()) return;
  throw NameTaken(fmt::format("{}, cannot be {}: this node already uses the name for something else",
                              named(name, resolveName(name)), what_for));
}

void OwnHandle::noteHeard(const std::string& name, const std::string& type) const {
  HeardTypes::ofProcess().add(resolveName(name), type);
}

}  // namespace cobot_command::ros_adapter
