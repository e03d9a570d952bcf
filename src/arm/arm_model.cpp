#include "cobot_command/arm/arm_model.h"

#include <algorithm>
#include <cassert>

#include "embedded_urdfs.h"
#include "family_geometry.h"
#include "urdf/urdf_chain.h"
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::arm {
namespace {

constexpr double kLimitTolerance = 1e-9;

struct NamedRatings {
  const char* name;
  Ratings ratings;
};

/// Data sheet: payload, reach, typical TCP speed. It has no line of its own for the S series, which carries
/// the same payload over the same reach as its elder namesake; the speed of that one is taken too.
constexpr std::array<NamedRatings, 6> kRatings = {{{"tm5-700", {6, 0.7, 1.1}},
                                                   {"tm5-900", {4, 0.9, 1.4}},
                                                   {"tm12", {12, 1.3, 1.3}},
                                                   {"tm14", {14, 1.1, 1.1}},
                                                   {"tm12s", {12, 1.3, 1.3}},
                                                   {"tm14s", {14, 1.1, 1.1}}}};

const Ratings* ratingsOf(std::string_view name) {
  for (const NamedRatings& entry : kRatings) {
    if (entry.name == name) return &entry.ratings;
  }
  return nullptr;
}

ModelError unknownName(std::string_view name) {
  return {fmt::format("There is no robot model \"{}\". Known models: {}.", foreignText(name, kQuoteLimit),
                      fmt::join(ArmModel::knownNames(), ", "))};
}

}  // namespace

Result<ArmModel, ModelError> ArmModel::named(std::string_view name) {
  const auto& names = knownNames();
  if (std::find(names.begin(), names.end(), name) == names.end()) return refuse(unknownName(name));
  return fromUrdf(urdfOf(name));
}

Result<ArmModel, ModelError> ArmModel::fromUrdf(const std::string& urdf) {
  auto read = readUrdfChain(urdf);
  if (!read) return refuse(read.error());
  const Ratings* ratings = ratingsOf(read->robot_name);
  if (ratings == nullptr) return refuse(unknownName(read->robot_name));
  const auto lengths = lengthsOfFamilyMember(read->chain);
  if (!lengths) return refuse(lengths.error());

  ArmModel model;
  model.name_ = read->robot_name;
  model.lengths_ = *lengths;
  model.limits_ = read->limits;
  model.ratings_ = *ratings;
  model.chain_ = read->chain;
  model.joint_names_ = read->joint_names;
  return model;
}

ArmModel ArmModel::turning(double turn_speed) const {
  assert(turn_speed > 0);
  ArmModel model(*this);
  model.ratings_.turn_speed = turn_speed;
  return model;
}

ArmModel ArmModel::limitedTo(const JointVector& lower, const JointVector& upper) const {
  ArmModel model(*this);
  for (std::size_t i = 0; i < kJointCount; ++i) {
    const auto joint = static_cast<Eigen::Index>(i);
    assert(lower[joint] < upper[joint]);
    assert(lower[joint] >= limits_[i].lower && upper[joint] <= limits_[i].upper);
    model.limits_[i].lower = lower[joint];
    model.limits_[i].upper = upper[joint];
  }
  return model;
}

const std::vector<std::string>& ArmModel::knownNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> result;
    for (const EmbeddedUrdf& urdf : embeddedUrdfs()) result.push_back(urdf.name);
    return result;
  }();
  return names;
}

const std::string& ArmModel::urdfOf(std::string_view name) {
  const auto& urdfs = embeddedUrdfs();
  const auto found = std::find_if(urdfs.begin(), urdfs.end(),
                                  [name](const EmbeddedUrdf& urdf) { return urdf.name == name; });
  assert(found != urdfs.end());
  return found->text;
}

int ArmModel::firstJointOutsideLimits(const JointVector& joints) const {
  for (std::size_t i = 0; i < kJointCount; ++i) {
    const double joint = joints[static_cast<Eigen::Index>(i)];
    const bool inside =
        joint >= limits_[i].lower - kLimitTolerance && joint <= limits_[i].upper + kLimitTolerance;
    if (!inside) return static_cast<int>(i);  // also when it is not a number
  }
  return -1;
}

}  // namespace cobot_command::arm
