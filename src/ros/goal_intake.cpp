#include "cobot_command/ros/goal_intake.h"

#include <algorithm>
#include <utility>

namespace cobot_command::ros_adapter {

GoalIntake::GoalIntake(FrameLookup frames, FramePatience patience, FileSource files, Core core)
    : frames_(std::move(frames)),
      patience_(std::move(patience)),
      files_(std::move(files)),
      core_(std::move(core)) {}

void GoalIntake::submit(blocks::GoalId id, GoalReader read, Instant now) {
  Reading reading = readNow(id, read);
  // It must not overtake what came before it, and cannot wait for that; and handed on, that could begin to
  // move.
  if (std::holds_alternative<blocks::StopGoal>(reading.goal)) withdraw("stopped by the stop block");
  const bool never_waits = std::holds_alternative<blocks::ProgramControlGoal>(reading.goal);
  const bool complete = reading.has_frames && reading.has_file;
  if (never_waits || (complete && waiting_.empty())) {
    handOn(id, std::move(reading.goal));
  } else {
    waiting_.push_back({id, std::move(read), now + patience_(), now + kFilePatience});
  }
}

void GoalIntake::cancel(blocks::GoalId id, bool under_way) {
  const auto waiting =
      std::find_if(waiting_.begin(), waiting_.end(), [id](const Waiting& w) { return w.id == id; });
  if (waiting == waiting_.end()) {
    if (under_way) withdraw("what was under way was cancelled");
    core_.cancel(id);
    return;
  }
  waiting_.erase(waiting);
  endCancelled(id, "cancelled");
}

int GoalIntake::withdraw(const std::string& why) {
  int ended = 0;
  for (const Waiting& waiting : std::exchange(waiting_, {})) {
    Reading reading = readNow(waiting.id, waiting.read);
    if (std::holds_alternative<blocks::ConnectGoal>(reading.goal)) {
      handOn(waiting.id, std::move(reading.goal));
    } else {
      endCancelled(waiting.id, why);
      ++ended;
    }
  }
  return ended;
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
  const auto find_file = [&](const std::string& location) {
    auto answer = files_.find(id, location);
    reading.has_file = answer.has_value();
    return answer;
  };
  reading.goal = read({find_frame, find_file});
  return reading;
}

void GoalIntake::handOn(blocks::GoalId id, blocks::Goal goal) {
  files_.forget(id);
  core_.submit(id, std::move(goal));
}

void GoalIntake::endCancelled(blocks::GoalId id, const std::string& why) {
  files_.forget(id);
  core_.end_cancelled(id, why + " while a frame or a file was looked up for it, or for one in front of it");
}

}  // namespace cobot_command::ros_adapter
