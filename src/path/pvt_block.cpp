#include "cobot_command/path/pvt_block.h"

#include <algorithm>
#include <cmath>

#include "cobot_command/arm/controller_pose.h"
#include "cobot_command/common/units.h"

namespace cobot_command::path {
namespace {

using std::chrono::milliseconds;

constexpr Duration kMillisecond = milliseconds(1);

/// As it is sent: five decimals of a degree.
double sentDegrees(double radians) {
  constexpr double kDecimals = 1e5;
  return std::round(radToDeg(radians) * kDecimals) / kDecimals;
}

arm::JointVector asSent(const arm::JointVector& joints) {
  return joints.unaryExpr([](double radians) { return degToRad(sentDegrees(radians)); });
}

/// Where the acceleration may jump: ramps and overlaps begin or end. Whole milliseconds since the path began,
/// in order.
std::vector<Duration> edgesOf(const PathPlan& plan, std::size_t first, std::size_t last) {
  std::vector<Duration> edges;
  for (std::size_t i = first; i <= last; ++i) {
    const PlannedPoint& point = plan.points()[i];
    edges.insert(edges.end(), {point.start, point.start + point.motion->timeUp(),
                               point.end() - point.motion->timeDown(), point.end()});
  }
  for (Duration& edge : edges) edge -= edge % kMillisecond;
  std::sort(edges.begin(), edges.end());
  return edges;
}

/// Without those that are nearer than `segment` to the one before, but with the first and the last.
std::vector<Duration> apart(const std::vector<Duration>& edges, Duration segment) {
  std::vector<Duration> kept{edges.front()};
  for (const Duration edge : edges) {
    if (edge - kept.back() >= segment) kept.push_back(edge);
  }
  if (kept.size() > 1) {
    kept.back() = edges.back();  // the end: the phase in front of it becomes longer
  } else {
    kept.push_back(edges.back());
  }
  return kept;
}

/// Equal to within a millisecond, none shorter than `segment` unless the phase is.
std::vector<Duration> divided(Duration from, Duration to, Duration segment) {
  const auto count = std::max<Duration::rep>(1, (to - from) / segment);
  const Duration::rep whole = (to - from) / kMillisecond;
  std::vector<Duration> ends;
  for (Duration::rep i = 1; i <= count; ++i) ends.push_back(from + whole * i / count * kMillisecond);
  return ends;
}

motion::PvtJointPoint pointAt(const PathPlan& plan, Duration before, Duration time) {
  const motion::JointState state = plan.at(time);
  return {asSent(state.position), asSent(state.velocity), toSeconds(time - before)};
}

}  // namespace

std::size_t endOfBlock(const PathPlan& plan, std::size_t first) {
  std::size_t last = first;
  while (plan.points()[last].overlap > Duration::zero()) ++last;
  return last;
}

PvtBlock sampleBlock(const PathPlan& plan, std::size_t first, std::size_t last, Duration segment) {
  PvtBlock block;
  block.first = first;
  block.last = last;
  block.start = plan.points()[first].start;
  const Duration end = plan.points()[last].end();
  if (end == block.start) {
    for (std::size_t point = first; point <= last; ++point) block.ends[point] = 0;
    return block;
  }
  const std::vector<Duration> edges = apart(edgesOf(plan, first, last), segment);
  Duration before = block.start;
  std::size_t done = first;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    for (const Duration time : divided(edges[i - 1], edges[i], segment)) {
      block.points.push_back(pointAt(plan, before, time));
      before = time;
      while (done <= last && plan.points()[done].end() <= time) block.ends[done++] = block.points.size();
    }
  }
  block.points.back().velocity.setZero();  // within rounding it is
  return block;
}

std::vector<std::size_t> taggedPoints(std::size_t first, std::size_t last, std::size_t most) {
  const std::size_t count = last - first + 1;
  const std::size_t step = (count + most - 1) / most;
  std::vector<std::size_t> tagged;
  for (std::size_t point = first + step - 1; point < last; point += step) tagged.push_back(point);
  tagged.push_back(last);
  return tagged;
}

std::vector<script::ScriptCommand> scriptOf(const PvtBlock& block, const std::map<std::size_t, int>& tags) {
  std::vector<script::ScriptCommand> lines;
  lines.reserve(block.points.size() + tags.size() + 2);
  auto tag = tags.begin();
  const auto add_tags = [&](std::size_t done) {
    for (; tag != tags.end() && block.ends.at(tag->first) <= done; ++tag) {
      lines.emplace_back(script::QueueTag{tag->second, false});
    }
  };
  if (block.points.empty()) {
    add_tags(0);
    return lines;
  }
  lines.emplace_back(script::PvtEnter{});
  for (std::size_t i = 0; i < block.points.size(); ++i) {
    const motion::PvtJointPoint& point = block.points[i];
    lines.emplace_back(script::PvtPoint{arm::toControllerJoints(point.position),
                                        arm::toControllerJoints(point.velocity), point.duration});
    add_tags(i + 1);
  }
  lines.emplace_back(script::PvtExit{});
  return lines;
}

}  // namespace cobot_command::path
