#include "reading/shape_reading.h"

#include <cmath>

#include "checks/fault_list.h"
#include <fmt/format.h>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/units.h"
#include "cobot_command/files/steps/steps_file.h"

namespace cobot_command::cell {

namespace {

using files::YamlMap;

/// How far what is given as a rotation may be from one: that of numbers with six digits.
constexpr double kRotationTolerance = 1e-6;

void requireWithin(const YAML::Node& node, const std::string& field, double value, double highest) {
  if (std::abs(value) > highest) {
    refuseAt(node.Mark(), {field, files::isShown(node), fmt::format("{} to {}", -highest, highest), ""});
  }
}

Eigen::Vector3d pointIn(const YamlMap& map, const char* key) {
  const auto values = coordinates(map.required(key), key, 3);
  return {mmToM(values[0]), mmToM(values[1]), mmToM(values[2])};
}

[[noreturn]] void refuseRotation(const YAML::Node& node, const std::string& field, const std::string& found,
                                 const char* allowed) {
  refuseAt(node.Mark(), {field, "is not a rotation: " + found, allowed,
                         "give more digits, or write the pose as [x, y, z, rx, ry, rz]"});
}

Eigen::Matrix3d toRotation(const YAML::Node& node, const std::string& field) {
  Eigen::Matrix3d rotation;
  const YAML::Node rows = files::toList(node, field, 3);
  for (int row = 0; row < 3; ++row) {
    const auto values = coordinates(rows[row], fmt::format("{}[{}]", field, row), 3);
    for (int column = 0; column < 3; ++column) {
      rotation(row, column) = values[static_cast<std::size_t>(column)];
    }
  }
  const Eigen::Matrix3d product = rotation * rotation.transpose();
  const double error = (product - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (error > kRotationTolerance || rotation.determinant() < 0) {
    refuseRotation(node, field,
                   rotation.determinant() < 0 ? "it mirrors"
                                              : fmt::format("its rows are {:.2g} from orthonormal", error),
                   "three rows of unit length at right angles, right-handed, to 1e-6");
  }
  return Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
}

Eigen::Matrix3d quaternionIn(const YAML::Node& node, const std::string& field) {
  const auto values = coordinates(node, field, 4);
  const Eigen::Quaterniond quaternion(values[3], values[0], values[1], values[2]);
  if (std::abs(quaternion.norm() - 1) > kRotationTolerance) {
    refuseRotation(node, field, fmt::format("its length is {:.9g}", quaternion.norm()),
                   "[x, y, z, w] of length 1, to 1e-6");
  }
  return quaternion.normalized().toRotationMatrix();
}

arm::Pose poseOfMap(const YAML::Node& node) {
  const YamlMap map(node, "a pose", {"position", "quaternion", "rotation"});
  arm::Pose pose = arm::Pose::Identity();
  pose.translation() = pointIn(map, "position");
  if (map.has("quaternion") == map.has("rotation")) {
    refuseAt(map.mark(), {"", map.has("rotation") ? "has quaternion and rotation" : "has no rotation",
                          "position with one of: quaternion, rotation", ""});
  }
  pose.linear() = map.has("rotation") ? toRotation(map.required("rotation"), "rotation")
                                      : quaternionIn(map.required("quaternion"), "quaternion");
  return pose;
}

/// What stands below the name of a shape's kind.
std::variant<CapsuleShape, SphereShape, CylinderShape, BoxShape> toKind(const YamlMap& shape) {
  if (shape.has("capsule")) {
    const YamlMap map(shape.required("capsule"), "a capsule", {"from", "to", "radius"});
    return CapsuleShape{pointIn(map, "from"), pointIn(map, "to"), lengthIn(map, "radius")};
  }
  if (shape.has("sphere")) {
    const YamlMap map(shape.required("sphere"), "a sphere", {"radius"});
    return SphereShape{lengthIn(map, "radius")};
  }
  if (shape.has("cylinder")) {
    const YamlMap map(shape.required("cylinder"), "a cylinder", {"radius", "length"});
    return CylinderShape{lengthIn(map, "radius"), lengthIn(map, "length")};
  }
  const YamlMap map(shape.required("box"), "a box", {"size"});
  const BoxShape box{pointIn(map, "size")};
  if (box.size.minCoeff() <= 0) {
    refuseAt(map.required("size").Mark(), {"size", "is not above 0", "three lengths above 0 [mm]", ""});
  }
  return box;
}

const char* kindIn(const YAML::Node& node, const YamlMap& map) {
  const char* found = nullptr;
  for (const char* kind : {"capsule", "sphere", "cylinder", "box"}) {
    if (!map.has(kind)) continue;
    if (found != nullptr) {
      refuseAt(node.Mark(),
               {"", fmt::format("is a {} and a {}", found, kind), "one kind each", "write two shapes"});
    }
    found = kind;
  }
  if (found == nullptr) {
    refuseAt(node.Mark(), {"", "has no kind", "one of: capsule, sphere, cylinder, box", ""});
  }
  return found;
}

void refuseMesh(const YAML::Node& node) {
  if (!node.IsMap()) return;
  for (const auto& entry : node) {
    const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "";
    if (key != "mesh" && key != "stl" && key != "file") continue;
    refuseAt(entry.first.Mark(), {key, "is a mesh", "capsule, sphere, cylinder, box",
                                  "cover the mesh by boxes, as tm_cell cover proposes them: a cell can only "
                                  "be verified with closed bodies"});
  }
}

Shape toShape(const YAML::Node& node) {
  refuseMesh(node);
  const YamlMap map(node, "a shape", {"capsule", "sphere", "cylinder", "box", "at"});
  Shape shape;
  shape.kind = within(kindIn(node, map), [&map] { return toKind(map); });
  shape.at = poseIn(map, "at");
  return shape;
}

}  // namespace

std::vector<double> coordinates(const YAML::Node& node, const std::string& field, std::size_t count) {
  const YAML::Node list = files::toList(node, field, count);
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) {
    const std::string place = fmt::format("{}[{}]", field, i);
    values.push_back(files::toNumber(list[i], place));
    requireWithin(list[i], place, values.back(), arm::kMaxCoordinate);
  }
  return values;
}

arm::Pose toPose(const YAML::Node& node, const std::string& field) {
  if (!node.IsMap()) {
    const auto values = coordinates(node, field, 6);
    return arm::toPose({values[0], values[1], values[2], values[3], values[4], values[5]});
  }
  return within(field, [&node] { return poseOfMap(node); });
}

arm::Pose poseIn(const YamlMap& map, const char* key) {
  return map.has(key) ? toPose(map.required(key), key) : arm::Pose::Identity();
}

blocks::SixValues frameIn(const YamlMap& map, const char* key, const char* kind) {
  const YAML::Node node = map.required(key);
  if (node.IsScalar()) {
    refuseAt(node.Mark(),
             {key, fmt::format("{}, the name of a {} of the project", files::isShown(node), kind),
              "[x, y, z, rx, ry, rz]",
              "write its value: the value of a name in the project is unknown here, and can change"});
  }
  return node.IsSequence() ? files::toSix(map, key) : arm::toControllerPose(toPose(node, key));
}

double lengthIn(const YamlMap& map, const char* key) {
  const double length = map.number(key);
  if (length <= 0 || length > arm::kMaxCoordinate) {
    const YAML::Node node = map.required(key);
    refuseAt(node.Mark(),
             {key, files::isShown(node), fmt::format("above 0, at most {} mm", arm::kMaxCoordinate), ""});
  }
  return mmToM(length);
}

std::vector<Shape> toShapes(const YAML::Node& node, const std::string& field) {
  if (!node.IsSequence() || node.size() > kMostShapes) {
    refuseAt(node.Mark(),
             {field, files::isShown(node), fmt::format("a list of at most {} shapes", kMostShapes), ""});
  }
  std::vector<Shape> shapes;
  for (std::size_t i = 0; i < node.size(); ++i) {
    shapes.push_back(within(fmt::format("{}[{}]", field, i), [&] { return toShape(node[i]); }));
  }
  return shapes;
}

}  // namespace cobot_command::cell
