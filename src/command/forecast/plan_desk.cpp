#include "forecast/plan_desk.h"

#include <algorithm>
#include <utility>

namespace cobot_command::command {

PlanJobId PlanDesk::ask(blocks::Block block, blocks::GoalId goal, const MakeWork& make) {
  auto dropped = std::make_shared<std::atomic<bool>>(false);
  PlanWork work = make(dropped);
  open_.push_back({{++last_, block, goal}, std::move(work), std::move(dropped), std::nullopt});
  return last_;
}

PlanWork PlanDesk::takeWork(PlanJobId id) {
  const auto open = std::find_if(open_.begin(), open_.end(), [id](const Open& o) { return o.job.id == id; });
  return std::move(open->work);
}

void PlanDesk::proceed(Instant now) {
  if (open_.empty() || open_.front().deadline) return;
  Open& first = open_.front();
  first.deadline = now + budget_;
  actions_.emplace_back(PlanAsked{first.job.id, std::move(first.work)});
}

PlanDesk::Job PlanDesk::remove(std::deque<Open>::iterator open) {
  const Job job = open->job;
  *open->dropped = true;
  open_.erase(open);
  return job;
}

std::optional<PlanDesk::Job> PlanDesk::answered(PlanJobId id) {
  const auto open = std::find_if(open_.begin(), open_.end(), [id](const Open& o) { return o.job.id == id; });
  return open == open_.end() ? std::nullopt : std::make_optional(remove(open));
}

std::optional<PlanDesk::Job> PlanDesk::drop(blocks::GoalId goal) {
  const auto open =
      std::find_if(open_.begin(), open_.end(), [goal](const Open& o) { return o.job.goal == goal; });
  return open == open_.end() ? std::nullopt : std::make_optional(remove(open));
}

std::vector<PlanDesk::Job> PlanDesk::dropAll() {
  std::vector<Job> jobs;
  for (const Open& open : std::exchange(open_, {})) {
    *open.dropped = true;
    jobs.push_back(open.job);
  }
  return jobs;
}

std::vector<PlanDesk::Job> PlanDesk::takeOverdue(Instant now) {
  std::vector<Job> jobs;
  while (!open_.empty() && open_.front().deadline && now >= *open_.front().deadline) {
    jobs.push_back(remove(open_.begin()));
  }
  return jobs;
}

std::optional<Instant> PlanDesk::nextDeadline() const {
  return open_.empty() ? std::nullopt : open_.front().deadline;
}

}  // namespace cobot_command::command
