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

}  // namespace

GoalIntake::GoalIntake(FrameLookup frames, FramePatience patience, FileSource files, Core core,
                       std::string world_frame)
    : frames_(std::move(frames)),
      patience_(std::move(patience)),
      files_(std::move(files)),
      core_(std::move(core)),
      world_frame_(std::move(world_frame)) {}

void GoalIntake::submit(blocks::GoalId id, GoalReader read, Instant now) {
  Reading reading = readNow(id, read);
  const bool complete = reading.has_frames && reading.has_file;
  const bool falls = command::fallsWithOthers(reading.goal);
  const bool is_full = waiting_.size() >= command::kMostWaiting;
  if (neverWaits(reading.goal) || (complete && waiting_.empty()) || (is_full && !falls)) {
    handOn(id, std::move(reading.goal));
  } else if (is_full) {
    const blocks::Block block = blockOf(reading.goal);
    end(block, id, command::refusedAsTooMany(block, waiting_.size()));
  } else {
    waiting_.push_back(
        {blockOf(reading.goal), id, std::move(read), now + patience_(), now + kFilePatience, falls});
  }
}

void GoalIntake::cancel(blocks::GoalId id) {
  const auto waiting =
      std::find_if(waiting_.begin(), waiting_.end(), [id](const Waiting& w) { return w.id == id; });
  if (waiting == waiting_.end()) {
    core_.cancel(id);
    return;
  }
  const Waiting cancelled = std::move(*waiting);
  waiting_.erase(waiting);
  endCancelled(cancelled, "cancelled");
}

int GoalIntake::fall(blocks::GoalId newest, const std::string& why) {
  const auto fallen = std::stable_partition(waiting_.begin(), waiting_.end(),
                                            [newest](const Waiting& w) { return !w.falls || w.id > newest; });
  const auto count = static_cast<int>(std::distance(fallen, waiting_.end()));
  for (auto waiting = fallen; waiting != waiting_.end(); ++waiting) endCancelled(*waiting, why);
  waiting_.erase(fallen, waiting_.end());
  return count;
}

void GoalIntake::advance(Instant now) {
  while (!waiting_.empty()) {
    const Waiting& front = waiting_.front();
    const blocks::GoalId id = front.id;
    Reading reading = readNow(id, front.read);
    if (!reading.has_frames && now < front.frames_by) return;
    if (!reading.has_file && now < front.file_by) return;
    waiting_.pop_front();
    handOn(id, std::move(reading.goal));
  }
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

void GoalIntake::end(blocks::Block block, blocks::GoalId id, blocks::Outcome outcome) {
  files_.forget(id);
  core_.end(block, id, std::move(outcome));
}

void GoalIntake::endCancelled(const Waiting& waiting, const std::string& why) {
  end(waiting.block, waiting.id,
      blocks::commandAborted(why +
                             " while a frame or a file was looked up for it, or for one in front of it"));
}

}  // namespace cobot_command::ros_adapter
