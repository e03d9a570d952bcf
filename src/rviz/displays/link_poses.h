// Where the links of an arm are when its joints are so: what a display needs to draw an arm that is nowhere
// in tf.
#pragma once

#include <map>
#include <string>

#include <Eigen/Geometry>
#include <urdf_model/model.h>

namespace cobot_command::rviz_plugin {

/// Of each link in the root of the model [m]. Joints that are not named stand at 0. `joints` [rad, m].
[[nodiscard]] std::map<std::string, Eigen::Isometry3d> linkPoses(const urdf::ModelInterface& model,
                                                                 const std::map<std::string, double>& joints);

}  // namespace cobot_command::rviz_plugin
