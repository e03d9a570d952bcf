#include "sending/trail.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/common/units.h"

namespace cobot_command::command {
namespace {

/// So much further than its plan says the robot may have come between two frames.
constexpr double kFaster = 1.5;
constexpr Duration kAhead = std::chrono::milliseconds(200);
constexpr Duration kStep = std::chrono::milliseconds(2);
/// So near to the nearest place another one is as good [rad].
constexpr double kSamePlace = degToRad(0.02);

/// What is left of the lines, in place of all of them.
blocks::Command withLines(blocks::Command command, std::vector<script::ScriptCommand> left) {
  command.order = [whole = std::move(command.order), left = std::move(left)](const arm::Pose& base) {
    blocks::Order order = whole(base);
    order.lines.clear();
    for (const script::ScriptCommand& line : left) order.lines.push_back(script::toText(line));
    order.commands = left;
    return order;
  };
  return command;
}

}  // namespace

void Trail::sent(const blocks::Command& command, const CommandOrder& order,
                 const robot::ActiveFrames& frames) {
  Step step;
  step.command = command;
  step.goal = order.goal;
  const blocks::Order at_full_speed = command.order(frames.base.value_or(arm::Pose::Identity()));
  step.has_own_flow = at_full_speed.has_exit || at_full_speed.pauses || at_full_speed.lets_go ||
                      at_full_speed.is_open_ended || !at_full_speed.commands;
  step.lines.commands = at_full_speed.commands.value_or(std::vector<script::ScriptCommand>());
  if (order.plan) step.lines.motions = order.plan->motions;
  step.lines.start.base = frames.base;
  step.lines.start.tcp = frames.tcp;
  steps_.push_back(std::move(step));
}

void Trail::ended(blocks::GoalId goal, blocks::CommandKey key, bool with_tag) {
  const auto step = std::find_if(steps_.begin(), steps_.end(), [&](const Step& s) {
    return !s.ended && s.goal == goal && s.command.key == key;
  });
  if (step == steps_.end()) return;
  if (with_tag) {
    drop(static_cast<std::size_t>(step - steps_.begin()) + 1);
  } else {
    step->ended = true;
  }
}

void Trail::drop(std::size_t steps) {
  steps_.erase(steps_.begin(), steps_.begin() + static_cast<std::ptrdiff_t>(steps));
  if (place_.step < steps) {
    place_ = Place();
  } else {
    place_.step -= steps;
  }
}

// --- Where the robot is.

const motion::Trajectory* Trail::motionAt(const Place& place) const {
  const auto& motions = steps_[place.step].lines.motions;
  return place.on_lines.motion < motions.size() ? motions[place.on_lines.motion].get() : nullptr;
}

bool Trail::goToMotion(Place& place) const {
  while (place.step < steps_.size()) {
    if (motionAt(place) != nullptr) return true;
    place = {place.step + 1, {}};
  }
  return false;
}

std::vector<Trail::Sample> Trail::samplesAhead(const arm::JointVector& joints, Duration most) const {
  std::vector<Sample> samples;
  std::optional<arm::JointVector> before;
  Place at = place_;
  for (Duration ahead{}; ahead <= most && goToMotion(at); ahead += kStep) {
    const motion::Trajectory& motion = *motionAt(at);
    const arm::JointVector position = motion.at(at.on_lines.time).position;
    const double step = before ? (position - *before).cwiseAbs().maxCoeff() : 0.0;
    samples.push_back({at, ahead, (position - joints).cwiseAbs().maxCoeff(), step});
    before = position;
    if (at.on_lines.time >= motion.duration()) {
      at.on_lines = {at.on_lines.motion + 1, Duration::zero()};
    } else {
      at.on_lines.time = std::min(at.on_lines.time + kStep, motion.duration());
    }
  }
  return samples;
}

/// Where a way turns back on itself, places on both sides of the corner are equally near: then the time says
/// which it is.
void Trail::see(const arm::JointVector& joints, bool moves, Instant now) {
  const Duration since = seen_at_ && moves ? now - *seen_at_ : Duration::zero();
  seen_at_ = now;
  const auto samples = samplesAhead(joints, kAhead + std::chrono::duration_cast<Duration>(since * kFaster));
  if (samples.empty()) return;
  const auto nearest = std::min_element(samples.begin(), samples.end(),
                                        [](const Sample& a, const Sample& b) { return a.away < b.away; });
  const auto early = [since](const Sample& sample) {
    return sample.ahead < since ? since - sample.ahead : sample.ahead - since;
  };
  const Sample* best = nullptr;
  for (auto sample = samples.begin(); sample != samples.end(); ++sample) {
    const bool is_behind_nearer = sample != samples.begin() && std::prev(sample)->away < sample->away;
    const bool is_before_nearer =
        std::next(sample) != samples.end() && std::next(sample)->away < sample->away;
    if (sample->away > nearest->away + kSamePlace + sample->step) continue;
    const bool is_nearest_around = !is_behind_nearer && !is_before_nearer;
    if (best == nullptr || (is_nearest_around && early(*sample) < early(*best))) best = &*sample;
    // What comes behind the end of a motion has not begun for certain, as long as the robot may be there
    // still.
    if (sample->place.on_lines.time >= motionAt(sample->place)->duration()) break;
  }
  place_ = best->place;
  std::size_t done = 0;
  while (done < place_.step && steps_[done].ended) ++done;
  drop(done);
}

// --- What is left.

std::optional<std::string> Trail::objection() const {
  for (std::size_t i = place_.step; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    if (step.has_own_flow) {
      return fmt::format("{} has lines that cannot be resumed", toString(step.command.block));
    }
    if (auto why = planning::whyNotResumable(step.lines)) {
      return fmt::format("{}: {}", toString(step.command.block), *why);
    }
  }
  return std::nullopt;
}

Left Trail::leftOf(const Step& step, const planning::PlaceOnLines& place, const arm::ArmModel& arm) {
  Left left{step.command, step.command, step.ended ? 0 : step.goal, std::nullopt};
  if (place.motion >= step.lines.motions.size()) return left;
  const motion::Trajectory& motion = *step.lines.motions[place.motion];
  const Duration almost = std::max(motion.duration() - Duration(1), Duration::zero());
  left.segment_end = motion.end().position;
  left.at_segment_end = withLines(step.command, restOf(step.lines, {place.motion, almost}, arm));
  return left;
}

std::deque<Left> Trail::left(const arm::ArmModel& arm) const {
  std::deque<Left> left;
  Place place = place_;
  if (!goToMotion(place)) place = Place();
  bool is_behind_motion = false;
  for (std::size_t i = place.step; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    const bool is_first = i == place.step;
    const bool moves = !step.lines.motions.empty();
    const bool is_over = is_first && moves && restOf(step.lines, place.on_lines, arm).empty();
    // With no motion in front of it, what the controller has accepted is done.
    const bool is_done = step.ended && (is_over || (!moves && !is_behind_motion));
    if (is_done) continue;
    const planning::PlaceOnLines at = is_first ? place.on_lines : planning::PlaceOnLines();
    left.push_back(leftOf(step, at, arm));
    // Also at its begin: the robot need not stand exactly where an offset was to begin.
    if (moves && !is_behind_motion) {
      left.back().command = withLines(step.command, restOf(step.lines, at, arm));
    }
    is_behind_motion = is_behind_motion || moves;
  }
  return left;
}

}  // namespace cobot_command::command
