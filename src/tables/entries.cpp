#include "cobot_command/tables/entries.h"

namespace cobot_command::tables {
namespace {

bool isSame(const arm::Pose& a, const arm::Pose& b) {
  return a.matrix() == b.matrix();
}

bool isSame(const std::optional<arm::Pose>& a, const std::optional<arm::Pose>& b) {
  return a.has_value() == b.has_value() && (!a || isSame(*a, *b));
}

}  // namespace

std::string_view toString(Kind kind) {
  return kind == Kind::Tool ? "tool" : kind == Kind::Frame ? "frame" : "load";
}

bool operator==(const Tool& a, const Tool& b) {
  return a.name == b.name && isSame(a.pose, b.pose) && a.load == b.load;
}

bool operator==(const Frame& a, const Frame& b) {
  return a.name == b.name && isSame(a.pose, b.pose) && a.reference == b.reference;
}

bool operator==(const Load& a, const Load& b) {
  return a.mass == b.mass && a.inertia == b.inertia && isSame(a.centre, b.centre);
}

Entries::Entries() {
  tools[0] = Tool{"", arm::Pose::Identity(), 0};
  frames[0] = Frame{"", arm::Pose::Identity(), 0};
  loads[0] = Load{};
}

}  // namespace cobot_command::tables
