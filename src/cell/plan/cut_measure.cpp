#include "plan/cut_measure.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <variant>

#include "plan/path_planning.h"

#include "cobot_command/arm/forward_kinematics.h"
#include "cobot_command/blocks/shared/order.h"
#include "cobot_command/planning/sampling.h"
#include "cobot_command/planning/script_planner.h"
#include "cobot_command/script/script_reader.h"

namespace cobot_command::cell {
namespace {

constexpr std::size_t kSamples = 256;
/// Farther, and a joint has another turn, or the arm another posture [rad].
constexpr double kOtherPosture = 1e-3;

/// The one motion of a goal, as the controller reads its lines.
motion::TrajectoryPtr planAsRead(const StepGoal& goal, const arm::Pose& base,
                                 planning::ScriptPlanner& planner) {
  const bool keeps_rules = std::visit([](const auto& one) { return blocks::check(one).empty(); }, goal);
  if (!keeps_rules) return nullptr;
  const auto order = std::visit([&](const auto& one) { return blocks::orderOf(one, base); }, goal);
  std::string text;
  for (const std::string& line : order.lines) text += line + "\r\n";
  const auto read = script::readScript(text);
  if (!read || read->size() != 1) return nullptr;
  const auto planned = planner.append(read->front().command, planner.duration() + kLate);
  return planned ? planned->trajectory : nullptr;
}

class Comparison {
 public:
  explicit Comparison(const CutScene& scene) : scene_(scene), whole_(*scene.whole.trajectory) {}

  struct Distance {
    double metres = 0.0;
    double turn = 0.0;
  };

  /// From where the whole is at that progress.
  [[nodiscard]] Distance distance(const arm::JointVector& joints, double progress) const {
    const arm::JointVector wanted = whole_.at(timeOfProgress(whole_, progress)).position;
    if ((joints - wanted).cwiseAbs().maxCoeff() > kOtherPosture) {
      return {std::numeric_limits<double>::infinity(), 0.0};
    }
    const arm::Pose here = tcpAt(joints);
    const arm::Pose there = tcpAt(wanted);
    return {(here.translation() - there.translation()).norm(),
            Eigen::AngleAxisd(here.linear().transpose() * there.linear()).angle()};
  }

  /// A half, the way of which begins and ends at these places of the whole.
  void addHalf(const motion::Trajectory& half, double from, double to, CutMeasure& measure) const {
    for (const Duration time : planning::evenTimes(half.duration(), kSamples)) {
      const Distance found = distance(half.at(time).position, from + (to - from) * half.progress(time));
      measure.deviation = std::max(measure.deviation, found.metres);
      measure.turn = std::max(measure.turn, found.turn);
    }
  }

  void addPassage(const motion::TrajectoryPtr& before, const motion::TrajectoryPtr& behind,
                  CutMeasure& measure) const {
    const motion::Passage passage =
        motion::passInto(scene_.arm, before, behind, scene_.whole.tcp, motion::BlendShare{1.0});
    const Duration takes_over = before->duration() - passage.overlap;
    measure.longer = takes_over + passage.path->duration() - whole_.duration();
    for (const Duration time : planning::evenTimes(passage.overlap, kSamples)) {
      const double progress = scene_.progress * before->progress(takes_over + time) +
                              (1.0 - scene_.progress) * behind->progress(time);
      // Here the arm may be anywhere near: what it does is no half.
      const arm::Pose there = tcpAt(whole_.at(timeOfProgress(whole_, progress)).position);
      const arm::Pose here = tcpAt(passage.path->at(time).position);
      measure.corner = std::max(measure.corner, (here.translation() - there.translation()).norm());
    }
  }

 private:
  [[nodiscard]] arm::Pose tcpAt(const arm::JointVector& joints) const {
    return arm::forwardKinematics(scene_.arm, joints) * scene_.whole.tcp;
  }

  const CutScene& scene_;
  const motion::Trajectory& whole_;
};

}  // namespace

Duration timeOfProgress(const motion::Trajectory& motion, double progress) {
  if (progress >= 1.0) return motion.duration();
  Duration before{};
  Duration behind = motion.duration();
  while (behind - before > Duration(1)) {
    const Duration middle = before + (behind - before) / 2;
    (motion.progress(middle) < progress ? before : behind) = middle;
  }
  return before;
}

std::optional<CutMeasure> measureCut(const CutScene& scene, const StepGoal& before, const StepGoal& behind) {
  const PlannedMotion& whole = scene.whole;
  planning::ScriptPlanner planner(scene.arm, {whole.trajectory->at(Duration::zero()).position, whole.base,
                                              whole.tcp, scene.speed_override});
  const motion::TrajectoryPtr first = planAsRead(before, whole.base, planner);
  if (!first) return std::nullopt;
  const motion::TrajectoryPtr second = planAsRead(behind, whole.base, planner);
  if (!second) return std::nullopt;
  const Comparison comparison(scene);
  CutMeasure measure;
  comparison.addHalf(*first, 0.0, scene.progress, measure);
  comparison.addHalf(*second, scene.progress, 1.0, measure);
  comparison.addPassage(first, second, measure);
  return measure;
}

}  // namespace cobot_command::cell
