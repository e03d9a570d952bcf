#include "cobot_command/arm/collision_shapes.h"

#include <cmath>
#include <map>
#include <optional>

#include "urdf_document.h"
#include <fmt/format.h>

#include "cobot_command/common/given.h"

namespace cobot_command::arm {
namespace {

/// Where a link hangs on the arm.
struct Anchor {
  std::size_t link = 0;
  Pose at = Pose::Identity();
};
/// By the names of links.
using Anchors = std::map<std::string, Anchor>;

Pose toPose(const urdf::Pose& origin) {
  const urdf::Rotation& turn = origin.rotation;
  Pose pose(Eigen::Quaterniond(turn.w, turn.x, turn.y, turn.z).normalized());
  pose.translation() = Eigen::Vector3d(origin.position.x, origin.position.y, origin.position.z);
  return pose;
}

/// Of the links of the arm itself.
Anchors anchorsOf(const UrdfDocument& document) {
  Anchors anchors;
  Anchor last;
  if (!document.path.empty()) anchors[document.path.front()->parent_link_name] = last;
  for (const auto& joint : document.path) {
    if (joint->type == urdf::Joint::FIXED) {
      last.at = last.at * toPose(joint->parent_to_joint_origin_transform);
    } else {
      last = {last.link + 1, Pose::Identity()};
    }
    anchors[joint->child_link_name] = last;
  }
  return anchors;
}

/// Of any link; nothing where it is not fixed to the arm.
std::optional<Anchor> anchorOf(const UrdfDocument& document, const Anchors& anchors, std::string link) {
  Pose behind = Pose::Identity();
  // A URDF may hide a ring of links beside its tree, hence the bound.
  for (std::size_t i = 0; i <= document.model->joints_.size(); ++i) {
    if (const auto found = anchors.find(link); found != anchors.end()) {
      return Anchor{found->second.link, found->second.at * behind};
    }
    const auto here = document.model->getLink(link);
    if (!here || !here->parent_joint || here->parent_joint->type != urdf::Joint::FIXED) return std::nullopt;
    behind = toPose(here->parent_joint->parent_to_joint_origin_transform) * behind;
    link = here->parent_joint->parent_link_name;
  }
  return std::nullopt;
}

/// Of a shape, and from its link's frame [m].
constexpr double kLongestShape = 100;

bool isLength(double value) {
  return value > 0 && value <= kLongestShape;
}

/// The dimensions are those of a shape as the header has them; else nothing, and `problem` says why.
std::optional<CollisionShape> shapeOf(const urdf::Geometry& geometry, std::string& problem) {
  CollisionShape shape;
  bool is_shape = false;
  switch (geometry.type) {
    case urdf::Geometry::CYLINDER: {
      const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
      shape.kind = CollisionCylinder{cylinder.radius, cylinder.length};
      is_shape = isLength(cylinder.radius) && isLength(cylinder.length);
      break;
    }
    case urdf::Geometry::BOX: {
      const urdf::Vector3& size = static_cast<const urdf::Box&>(geometry).dim;
      shape.kind = CollisionBox{{size.x, size.y, size.z}};
      is_shape = isLength(size.x) && isLength(size.y) && isLength(size.z);
      break;
    }
    case urdf::Geometry::SPHERE: {
      const auto& sphere = static_cast<const urdf::Sphere&>(geometry);
      shape.kind = CollisionSphere{sphere.radius};
      is_shape = isLength(sphere.radius);
      break;
    }
    case urdf::Geometry::MESH:
      problem = fmt::format("is the mesh {}, but bodies are made of primitives. Cover it by boxes",
                            quoted(static_cast<const urdf::Mesh&>(geometry).filename));
      return std::nullopt;
  }
  if (is_shape) return shape;
  problem =
      fmt::format("has a length that is not above 0 and up to {} m. Correct its <geometry>", kLongestShape);
  return std::nullopt;
}

Result<CollisionShape, ModelError> shapeOf(const urdf::Link& link, const urdf::Collision& collision,
                                           const std::optional<Anchor>& anchor) {
  std::string problem;
  auto shape = collision.geometry ? shapeOf(*collision.geometry, problem) : std::nullopt;
  if (!collision.geometry) problem = "has no <geometry>. Give it one";
  const urdf::Vector3& place = collision.origin.position;
  if (shape && !(std::hypot(place.x, place.y, place.z) <= kLongestShape)) {
    problem = fmt::format("is more than {} m from its link. Correct its <origin>", kLongestShape);
    shape.reset();
  }
  if (shape && !anchor) {
    problem = "is not fixed to a link of the arm, so its position is unknown. Make its joints \"fixed\"";
  }
  if (!shape || !anchor) {
    return refuse(
        ModelError{fmt::format("A <collision> of the link {} of the URDF {}.", quoted(link.name), problem)});
  }
  shape->link = anchor->link;
  shape->at = anchor->at * toPose(collision.origin);
  shape->link_name = link.name;
  return *shape;
}

}  // namespace

Result<std::vector<CollisionShape>, ModelError> collisionShapes(const std::string& urdf) {
  const auto document = readUrdfDocument(urdf);
  if (!document) return refuse(document.error());
  const Anchors anchors = anchorsOf(*document);
  std::vector<CollisionShape> shapes;
  for (const auto& [name, link] : document->model->links_) {
    if (link->collision_array.empty()) continue;
    const auto anchor = anchorOf(*document, anchors, name);
    for (const auto& collision : link->collision_array) {
      auto shape = shapeOf(*link, *collision, anchor);
      if (!shape) return refuse(shape.error());
      shapes.push_back(*shape);
    }
  }
  return shapes;
}

}  // namespace cobot_command::arm
