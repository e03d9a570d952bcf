// Poses: X Y Z [mm] RX RY RZ [deg], R = Rz Ry Rx, computed in double.
#include <cmath>

#include "library/library.h"
#include <Eigen/Geometry>

#include "cobot_command/common/units.h"

namespace cobot_command::tm_script {

namespace {

struct Frame {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
};

Frame operator*(const Frame& a, const Frame& b) {
  return {a.position + a.rotation * b.position, a.rotation * b.rotation};
}

Frame inverse(const Frame& frame) {
  const Eigen::Matrix3d turned_back = frame.rotation.transpose();
  return {-(turned_back * frame.position), turned_back};
}

Eigen::Vector3d pointAt(const Arguments& arguments, std::size_t place) {
  const auto numbers = itemsAt<float>(arguments, place);
  return {numbers[0], numbers[1], numbers[2]};
}

Frame frameAt(const Arguments& arguments, std::size_t place) {
  const auto pose = itemsAt<float>(arguments, place);
  const auto turn = [&](std::size_t angle, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(degToRad(double{pose[angle]}), axis);
  };
  return {pointAt(arguments, place), (turn(5, Eigen::Vector3d::UnitZ()) * turn(4, Eigen::Vector3d::UnitY()) *
                                      turn(3, Eigen::Vector3d::UnitX()))
                                         .toRotationMatrix()};
}

/// Where RY is +-90 degrees, only one angle more is determined: RZ is then 0.
Value poseOf(const Frame& frame) {
  constexpr double kGimbalLock = 1e-10;
  const Eigen::Matrix3d& r = frame.rotation;
  const double cos_ry = std::hypot(r(0, 0), r(1, 0));
  const double rz = cos_ry > kGimbalLock ? std::atan2(r(1, 0), r(0, 0)) : 0.0;
  const double rx = std::atan2(std::sin(rz) * r(0, 2) - std::cos(rz) * r(1, 2),
                               std::cos(rz) * r(1, 1) - std::sin(rz) * r(0, 1));
  const double ry = std::atan2(-r(2, 0), cos_ry);
  std::vector<float> pose;
  for (const double number : {frame.position.x(), frame.position.y(), frame.position.z(), radToDeg(rx),
                              radToDeg(ry), radToDeg(rz)}) {
    pose.push_back(static_cast<float>(number + 0.0));
  }
  return arrayOf(pose);
}

/// How one pose lies to another, in the axes of their common base.
Computed trans(const Arguments& arguments) {
  const Frame from = frameAt(arguments, 0);
  const Frame to = frameAt(arguments, 1);
  return poseOf({to.position - from.position, to.rotation * from.rotation.transpose()});
}

/// What trans() found, put on a pose.
Computed applyTrans(const Arguments& arguments) {
  const Frame from = frameAt(arguments, 0);
  const Frame step = frameAt(arguments, 1);
  return poseOf({from.position + step.position, step.rotation * from.rotation});
}

/// A pose in one base (RobotBase, when it is left out) as it is in another.
Computed changeRef(const Arguments& arguments) {
  if (arguments.size() == 2) return poseOf(inverse(frameAt(arguments, 1)) * frameAt(arguments, 0));
  return poseOf(inverse(frameAt(arguments, 2)) * frameAt(arguments, 1) * frameAt(arguments, 0));
}

/// On the straight line from the first to the second, turning about one axis.
Computed interPoint(const Arguments& arguments) {
  const Frame from = frameAt(arguments, 0);
  const Frame to = frameAt(arguments, 1);
  const double ratio = scalarAt<float>(arguments, 2);
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(from.rotation.transpose() * to.rotation));
  return poseOf({from.position + ratio * (to.position - from.position),
                 from.rotation * Eigen::AngleAxisd(ratio * turn.angle(), turn.axis()).toRotationMatrix()});
}

/// Origin, a point on the X axis, a point of the XY plane on the side of Y.
Computed pointsToCoord(const Arguments& arguments) {
  constexpr double kLeast = 1e-6;  // mm, or mm^2: the floats of the points hold no less
  const Eigen::Vector3d origin = pointAt(arguments, 0);
  const Eigen::Vector3d along = pointAt(arguments, 1) - origin;
  const Eigen::Vector3d normal = along.cross(pointAt(arguments, 2) - origin);
  if (!(along.norm() > kLeast && normal.norm() > kLeast)) {
    return refuse(std::string("three points on one line"));
  }
  Frame frame{origin, {}};
  frame.rotation.col(0) = along.normalized();
  frame.rotation.col(2) = normal.normalized();
  frame.rotation.col(1) = frame.rotation.col(2).cross(frame.rotation.col(0));
  return poseOf(frame);
}

Computed norm2(const Arguments& arguments) {
  double sum = 0;
  for (const float number : itemsAt<float>(arguments, 0)) sum += double{number} * double{number};
  return Scalar(std::sqrt(sum));
}

}  // namespace

void definePoseFunctions(FunctionTable& table) {
  constexpr Version kSinceCoordinates{1, 82};
  table.define("double norm2(float[])", kSinceEver, norm2);
  table.define("double dist(float[6], float[6])", kSinceEver, [](const Arguments& arguments) -> Computed {
    return Scalar((pointAt(arguments, 0) - pointAt(arguments, 1)).norm());
  });
  table.define("float[] trans(float[6], float[6])", kSinceEver, trans);
  table.define("float[] inversetrans(float[6])", kSinceEver,
               [](const Arguments& arguments) -> Computed { return poseOf(inverse(frameAt(arguments, 0))); });
  table.define("float[] applytrans(float[6], float[6])", kSinceEver, applyTrans);
  table.define("float[] interpoint(float[6], float[6], float)", kSinceEver, interPoint);
  table.define("float[] changeref(float[6], float[6], float[6]?)", kSinceEver, changeRef);
  table.define("float[] points2coord(float[6], float[6], float[6])", kSinceCoordinates, pointsToCoord);
}

}  // namespace cobot_command::tm_script
