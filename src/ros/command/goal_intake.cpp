#include "cobot_command/ros/command/goal_intake.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "cobot_command/blocks/list/goal_rules.h"
#include "cobot_command/blocks/shared/failure.h"
#include "cobot_command/command/waiting_goals.h"

namespace cobot_command::ros_adapter {
namespace {

/// It halts the robot, or goes out beside all others, or makes the connection: nothing of that must wait for
/// a frame.
bool neverWaits(const blocks::Goal& goal) {
  const blocks::Way way = blocks::GoalRules(goal).traits().way;
  return way == blocks::Way::Stop || way == blocks::Way::Beside || way == blocks::Way::Link ||
         way == blocks::Way::Configure;
}

blocks::Outcome cancelledHere(const std::string& why) {
  return blocks::commandAborted(
      why + " while a frame or a file was looked up for this goal, or for one that was received earlier");
}

}  // namespace

GoalIntake::GoalIntake(FrameLookup frames, FramePatience patience, FileSource files, Core core,
                       std::string world_frame)
    : frames_(std::move(frames)),
      patience_(std::move(patience)),
      files_(std::move(files)),
      core_(std::move(core)),
      world_frame_(std::move(world_frame)) {}

void GoalIntake::submit(IncomingGoal goal, Instant now) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    incoming_ = goal.id;  // from here on a cancel finds it
    incoming_is_cancelled_ = false;
  }
  Reading reading = readNow(goal.id, goal.read);
  std::optional<Ended> ended;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    ended = place(goal, reading, now);
    incoming_.reset();
  }
  if (ended) end(*std::move(ended));
}

std::optional<GoalIntake::Ended> GoalIntake::place(IncomingGoal& incoming, Reading& reading, Instant now) {
  const blocks::Block block = blockOf(reading.goal);
  const bool is_cancelled =
      incoming_is_cancelled_ || (incoming.is_cancelled != nullptr && incoming.is_cancelled());
  if (is_cancelled) {
    return Ended{block, incoming.id, blocks::commandAborted("cancelled before it was started")};
  }
  const bool complete = reading.has_frames && reading.has_file;
  const bool falls = command::fallsWithOthers(reading.goal);
  const bool is_full = waiting_.size() >= command::kMostWaiting;
  if (neverWaits(reading.goal) || (complete && waiting_.empty()) || (is_full && !falls)) {
    handOn(incoming.id, std::move(reading.goal));
    return std::nullopt;
  }
  if (falls && incoming.id <= fell_until_) return Ended{block, incoming.id, cancelledHere(fell_why_)};
  if (is_full) return Ended{block, incoming.id, command::refusedAsTooMany(block, waiting_.size())};
  waiting_.push_back(
      {block, incoming.id, std::move(incoming.read), now + patience_(), now + kFilePatience, falls});
  return std::nullopt;
}

void GoalIntake::cancel(blocks::GoalId id, blocks::GoalId newest) {
  std::optional<Ended> ended;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (incoming_ == id) {
      incoming_is_cancelled_ = true;
      return;
    }
    ended = takeCancelled(id);
    if (!ended) core_.cancel(id, newest);
  }
  if (ended) end(*std::move(ended));
}

std::optional<GoalIntake::Ended> GoalIntake::takeCancelled(blocks::GoalId id) {
  const auto waiting =
      std::find_if(waiting_.begin(), waiting_.end(), [id](const Waiting& w) { return w.id == id; });
  if (waiting == waiting_.end()) return std::nullopt;
  Ended ended{waiting->block, id, cancelledHere("cancelled")};
  waiting_.erase(waiting);
  return ended;
}

int GoalIntake::fall(blocks::GoalId newest, const std::string& why) {
  std::vector<Ended> ended;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (newest > fell_until_) {
      fell_until_ = newest;
      fell_why_ = why;
    }
    const auto fallen = std::stable_partition(
        waiting_.begin(), waiting_.end(), [newest](const Waiting& w) { return !w.falls || w.id > newest; });
    for (auto waiting = fallen; waiting != waiting_.end(); ++waiting) {
      ended.push_back({waiting->block, waiting->id, cancelledHere(why)});
    }
    waiting_.erase(fallen, waiting_.end());
  }
  for (Ended& one : ended) end(std::move(one));
  return static_cast<int>(ended.size());
}

bool GoalIntake::isWaiting() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return !waiting_.empty();
}

void GoalIntake::advance(Instant now) {
  while (const auto first = front()) {
    Reading reading = readNow(first->id, first->read);
    if (!reading.has_frames && now < first->frames_by) return;
    if (!reading.has_file && now < first->file_by) return;
    const std::lock_guard<std::mutex> lock(mutex_);
    if (waiting_.empty() || waiting_.front().id != first->id) {  // ended meanwhile
      files_.forget(first->id);
      continue;
    }
    waiting_.pop_front();
    handOn(first->id, std::move(reading.goal));
  }
}

std::optional<GoalIntake::Waiting> GoalIntake::front() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return waiting_.empty() ? std::nullopt : std::optional(waiting_.front());
}

GoalIntake::Reading GoalIntake::readNow(blocks::GoalId id, const GoalReader& read) const {
  Reading reading;
  const auto find_frame = [&](const std_msgs::Header& header) {
    FramePlace place = frames_(header);
    reading.has_frames = reading.has_frames && place.in_robot_base.has_value();
    return place;
  };
  const auto find_file = [&](FileKind kind, const std::string& location) {
    auto answer = files_.find(id, kind, location);
    reading.has_file = answer.has_value();
    return answer;
  };
  const auto find_steps = [&](const std::string& location) -> std::optional<StepsAnswer> {
    auto answer = find_file(FileKind::Steps, location);
    return answer ? std::make_optional(std::get<StepsAnswer>(std::move(*answer))) : std::nullopt;
  };
  const auto find_points = [&](const std::string& location) -> std::optional<PointsAnswer> {
    auto answer = find_file(FileKind::Points, location);
    return answer ? std::make_optional(std::get<PointsAnswer>(std::move(*answer))) : std::nullopt;
  };
  reading.goal = read({find_frame, find_steps, find_points, world_frame_});
  return reading;
}

void GoalIntake::handOn(blocks::GoalId id, blocks::Goal goal) {
  files_.forget(id);
  core_.submit(id, std::move(goal));
}

void GoalIntake::end(Ended ended) {
  files_.forget(ended.id);
  core_.end(ended.block, ended.id, std::move(ended.outcome));
}

}  // namespace cobot_command::ros_adapter
