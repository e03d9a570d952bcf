#include "forecast/plan_desk.h"

#include <algorithm>
#include <utility>

#include "cobot_command/common/deadline.h"

namespace cobot_command::command {
namespace {

void giveUp(const std::shared_ptr<std::atomic<bool>>& dropped) {
  if (dropped) *dropped = true;
}

}  // namespace

void PlanDesk::ask(Job job, Instant now) {
  Open open{++last_, std::move(job)};
  if (planning_ == Planning::AtOnce) {
    open.job.take(begin(open, now)());
  } else {
    laneOf(open.job.purpose).push_back(std::move(open));
  }
}

PlanWork PlanDesk::begin(Open& open, Instant now) {
  open.dropped = std::make_shared<std::atomic<bool>>(false);
  return open.job.make(open.dropped, now);
}

void PlanDesk::proceed(Instant now) {
  proceed(to_send_, PlanLane::Send, now);
  proceed(others_, PlanLane::Other, now);
}

void PlanDesk::proceed(Lane& lane, PlanLane name, Instant now) {
  if (lane.empty() || lane.front().deadline) return;
  Open& first = lane.front();
  if (first.job.is_ready && !first.job.is_ready()) return;
  first.deadline = now + budget_;
  actions_.emplace_back(PlanAsked{first.id, name, begin(first, now)});
}

PlanDesk::Job PlanDesk::remove(Lane& lane, const Lane::iterator& open) {
  giveUp(open->dropped);
  Job job = std::move(open->job);
  lane.erase(open);
  return job;
}

void PlanDesk::answered(PlanJobId id, PlanAnswer answer) {
  if (!answered(to_send_, id, answer)) static_cast<void>(answered(others_, id, answer));
}

bool PlanDesk::answered(Lane& lane, PlanJobId id, PlanAnswer& answer) {
  const auto open = std::find_if(lane.begin(), lane.end(), [id](const Open& o) { return o.id == id; });
  if (open == lane.end()) return false;
  remove(lane, open).take(std::move(answer));
  return true;
}

void PlanDesk::endOverdue(Instant now) {
  endOverdue(to_send_, now);
  endOverdue(others_, now);
}

void PlanDesk::endOverdue(Lane& lane, Instant now) {
  while (!lane.empty() && lane.front().deadline && now >= *lane.front().deadline) {
    remove(lane, lane.begin()).take(std::nullopt);
  }
}

std::optional<Instant> PlanDesk::nextDeadline() const {
  const auto of = [](const Lane& lane) { return lane.empty() ? std::nullopt : lane.front().deadline; };
  return earlier(of(to_send_), of(others_));
}

bool PlanDesk::plans(blocks::GoalId goal) const {
  const auto is_of_goal = [goal](const Open& open) {
    return open.job.goal == goal && open.job.purpose != Purpose::Check;
  };
  return std::any_of(to_send_.begin(), to_send_.end(), is_of_goal) ||
         std::any_of(others_.begin(), others_.end(), is_of_goal);
}

std::size_t PlanDesk::checks() const {
  return static_cast<std::size_t>(std::count_if(
      others_.begin(), others_.end(), [](const Open& open) { return open.job.purpose == Purpose::Check; }));
}

void PlanDesk::drop(blocks::GoalId goal) {
  drop(to_send_, goal);
  drop(others_, goal);
}

void PlanDesk::drop(Lane& lane, blocks::GoalId goal) {
  for (auto open = lane.begin(); open != lane.end();) {
    const bool dropped = open->job.goal == goal && open->job.purpose != Purpose::Check;
    if (dropped) giveUp(open->dropped);
    open = dropped ? lane.erase(open) : open + 1;
  }
}

std::optional<PlanDesk::Job> PlanDesk::dropCheck(blocks::GoalId goal) {
  const auto open = std::find_if(others_.begin(), others_.end(), [goal](const Open& o) {
    return o.job.goal == goal && o.job.purpose == Purpose::Check;
  });
  return open == others_.end() ? std::nullopt : std::make_optional(remove(others_, open));
}

std::vector<PlanDesk::Job> PlanDesk::dropChecks() {
  std::vector<Job> jobs;
  for (auto open = others_.begin(); open != others_.end();) {
    if (open->job.purpose != Purpose::Check) {
      ++open;
      continue;
    }
    giveUp(open->dropped);
    jobs.push_back(std::move(open->job));
    open = others_.erase(open);
  }
  return jobs;
}

}  // namespace cobot_command::command
