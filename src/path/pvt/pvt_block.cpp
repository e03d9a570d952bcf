#include "cobot_command/path/pvt_block.h"

#include <algorithm>

#include "pvt/pvt_knots.h"

#include "cobot_command/arm/controller_pose.h"

namespace cobot_command::path {
namespace {

/// Points up to one that is told of in any case, and the parts that they are told of in.
struct Stretch {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t parts = 1;

  [[nodiscard]] double pointsOfAPart() const {
    return static_cast<double>(last - first + 1) / static_cast<double>(parts);
  }
};

/// Up to the last point, and to those that end a goal, at most so many of these.
std::vector<Stretch> stretchesOf(const PathPlan& plan, std::size_t most_ends) {
  const auto& points = plan.points();
  std::vector<Stretch> stretches(1);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    stretches.back().last = i + 1;
    if (points[i].goal == points[i + 1].goal || stretches.size() > most_ends) continue;
    stretches.back().last = i;
    stretches.push_back({i + 1, i + 1});
  }
  return stretches;
}

}  // namespace

/// What has no way takes no time: a thousand of these in front of a rest are passed with it.
std::size_t endOfBlock(const PathPlan& plan, std::size_t first) {
  const auto& points = plan.points();
  std::size_t last = first;
  while (points[last].overlap > Duration::zero()) ++last;
  while (last + 1 < points.size() && points[last + 1].motion->duration() == Duration::zero()) ++last;
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
  Duration before = block.start;
  std::size_t done = first;
  const std::vector<PvtKnot> knots = knotsOf(plan, first, last, segment);
  for (auto knot = knots.begin() + 1; knot != knots.end(); ++knot) {
    block.points.push_back(pvtPointAt(plan, before, *knot));
    before = knot->time;
    while (done <= last && plan.points()[done].end() <= before) block.ends[done++] = block.points.size();
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

std::vector<std::size_t> markedPoints(const PathPlan& plan, std::size_t most) {
  std::vector<Stretch> stretches = stretchesOf(plan, most);
  const auto is_finer = [](const Stretch& one, const Stretch& other) {
    return one.pointsOfAPart() < other.pointsOfAPart();
  };
  for (std::size_t marks = stretches.size() - 1; marks < most; ++marks) {
    ++std::max_element(stretches.begin(), stretches.end(), is_finer)->parts;
  }
  std::vector<std::size_t> marked;
  for (const Stretch& stretch : stretches) {
    for (const std::size_t point : taggedPoints(stretch.first, stretch.last, stretch.parts)) {
      if (point + 1 < plan.points().size()) marked.push_back(point);
    }
  }
  return marked;
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
