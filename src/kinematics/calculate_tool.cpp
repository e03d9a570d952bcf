#include "cobot_command/kinematics/calculate_tool.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "question_checks.h"
#include "rounding.h"
#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include "cobot_command/common/units.h"

namespace cobot_command::kinematics {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

std::optional<Refusal> wrongCount(std::size_t count) {
  const bool is_few = count < kFewestTouches;
  if (!is_few && count <= kMostTouches) return std::nullopt;
  return Refusal{is_few ? kinematics_error::kTooFew : kinematics_error::kTooMany,
                 fmt::format("there are {} poses; allowed: {} to {}. Touch the point {} times", count,
                             kFewestTouches, kMostTouches, is_few ? "more" : "fewer")};
}

Result<double, Refusal> mostErrorOf(const ToolQuestion& question) {
  const double given = question.most_error;
  if (given >= 0 && given <= arm::kMaxCoordinate) return given > 0 ? given : kUsualError;
  const int id = std::isfinite(given) ? kinematics_error::kCoordinateRange : kinematics_error::kNotFinite;
  return refuse(Refusal{id, fmt::format("most_error is {} mm; allowed: 0 to {}; 0 means {} mm", given,
                                        arm::kMaxCoordinate, kUsualError)});
}

Result<std::vector<arm::Pose>, Refusal> posesOf(const ToolQuestion& question) {
  std::vector<arm::Pose> poses;
  for (const arm::ControllerPose& flange : question.flanges) {
    const auto pose = poseInRange(fmt::format("pose {}", poses.size() + 1), flange);
    if (!pose) return refuse(pose.error());
    poses.push_back(*pose);
  }
  return poses;
}

std::optional<Refusal> turnedTooLittle(const std::vector<arm::Pose>& poses) {
  for (std::size_t i = 0; i < poses.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const Matrix3d difference = poses[j].linear().transpose() * poses[i].linear();
      const double turn = radToDeg(Eigen::AngleAxisd(difference).angle());
      if (turn >= kLeastTurn) continue;
      return Refusal{
          kinematics_error::kTooNear,
          fmt::format("the poses {} and {} are turned by {:.3f} degrees against each other; allowed: "
                      "{} degrees and more. Turn the flange further about the point",
                      j + 1, i + 1, turn, kLeastTurn)};
    }
  }
  return std::nullopt;
}

/// What is least of the sum of the squares of the touches from their mean: R t + p - mean(R t + p).
struct LeastSquares {
  Matrix3d mean_turn = Matrix3d::Zero();
  Vector3d mean_place = Vector3d::Zero();
  Matrix3d square = Matrix3d::Zero();
  Vector3d side = Vector3d::Zero();

  explicit LeastSquares(const std::vector<arm::Pose>& poses) {
    const auto count = static_cast<double>(poses.size());
    for (const arm::Pose& pose : poses) {
      mean_turn += pose.linear() / count;
      mean_place += pose.translation() / count;
    }
    for (const arm::Pose& pose : poses) {
      const Matrix3d turn = pose.linear() - mean_turn;
      square += turn.transpose() * turn / count;
      side -= turn.transpose() * (pose.translation() - mean_place) / count;
    }
  }
};

Refusal aboutOneAxis(double spread) {
  return {kinematics_error::kOnOneLine,
          fmt::format("the poses are turned about one axis, or nearly so: along it the TCP is not determined "
                      "(spread {:.4f}; allowed: {} and more). Turn the flange about other axes, too",
                      spread, kLeastSpread)};
}

ToolAnswer answerOf(const std::vector<arm::Pose>& poses, const LeastSquares& squares, const Vector3d& tcp) {
  const Vector3d point = squares.mean_turn * tcp + squares.mean_place;
  ToolAnswer answer;
  double sum = 0;
  for (const arm::Pose& pose : poses) {
    const double error = mToMm((pose * tcp - point).norm());
    sum += error * error;
    answer.worst_error = std::max(answer.worst_error, error);
  }
  answer.mean_error = std::sqrt(sum / static_cast<double>(poses.size()));
  const auto placed = [](const Vector3d& place) {
    return shown({mToMm(place.x()), mToMm(place.y()), mToMm(place.z()), 0, 0, 0});
  };
  answer.tcp = placed(tcp);
  answer.point = placed(point);
  return answer;
}

}  // namespace

Result<ToolAnswer, Refusal> calculateTool(const ToolQuestion& question) {
  if (auto refusal = wrongCount(question.flanges.size())) return refuse(*std::move(refusal));
  const auto poses = posesOf(question);
  if (!poses) return refuse(poses.error());
  const auto most_error = mostErrorOf(question);
  if (!most_error) return refuse(most_error.error());
  if (auto refusal = turnedTooLittle(*poses)) return refuse(*std::move(refusal));
  const LeastSquares squares(*poses);
  const Eigen::SelfAdjointEigenSolver<Matrix3d> axes(squares.square);
  const double spread = std::sqrt(std::max(axes.eigenvalues()[0], 0.0));
  if (spread < kLeastSpread) return refuse(aboutOneAxis(spread));
  const Vector3d tcp = squares.square.ldlt().solve(squares.side);
  ToolAnswer answer = answerOf(*poses, squares, tcp);
  if (answer.worst_error > *most_error) {
    return refuse(
        Refusal{kinematics_error::kNotPossible,
                fmt::format("the touches are up to {:.3f} mm from one point; allowed: {} mm. Touch the "
                            "same point with each pose, or allow more",
                            answer.worst_error, *most_error)});
  }
  return answer;
}

}  // namespace cobot_command::kinematics
