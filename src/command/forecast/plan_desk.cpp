#include "forecast/plan_desk.h"

#include <algorithm>
#include <utility>

namespace cobot_command::command {

PlanJobId PlanDesk::ask(blocks::Block block, blocks::GoalId goal, Haste haste, MakeWork make) {
  const PlanJobId id = ++last_;
  const auto place =
      haste == Haste::Check ? open_.end() : std::find_if(open_.begin(), open_.end(), [](const Open& open) {
        return open.haste == Haste::Check;
      });
  if (place != open_.end() && place->deadline) {
    drop(*place);
    place->job.id = ++last_;  // what comes of its first beginning is for nobody
    place->deadline.reset();
  }
  open_.insert(place, {{id, block, goal}, haste, std::move(make), nullptr, std::nullopt});
  return id;
}

PlanWork PlanDesk::begin(Open& open) {
  open.dropped = std::make_shared<std::atomic<bool>>(false);
  return open.make(open.dropped);
}

void PlanDesk::drop(Open& open) {
  if (open.dropped) *open.dropped = true;
}

PlanWork PlanDesk::takeWork(PlanJobId id) {
  return begin(*find(id));
}

std::deque<PlanDesk::Open>::iterator PlanDesk::find(PlanJobId id) {
  return std::find_if(open_.begin(), open_.end(), [id](const Open& open) { return open.job.id == id; });
}

void PlanDesk::proceed(Instant now) {
  if (open_.empty() || open_.front().deadline) return;
  Open& first = open_.front();
  first.deadline = now + budget_;
  actions_.emplace_back(PlanAsked{first.job.id, begin(first)});
}

PlanDesk::Job PlanDesk::remove(const std::deque<Open>::iterator& open) {
  const Job job = open->job;
  drop(*open);
  open_.erase(open);
  return job;
}

std::optional<PlanDesk::Job> PlanDesk::answered(PlanJobId id) {
  const auto open = find(id);
  return open == open_.end() ? std::nullopt : std::make_optional(remove(open));
}

std::optional<PlanDesk::Job> PlanDesk::drop(blocks::GoalId goal) {
  const auto open =
      std::find_if(open_.begin(), open_.end(), [goal](const Open& o) { return o.job.goal == goal; });
  return open == open_.end() ? std::nullopt : std::make_optional(remove(open));
}

std::vector<PlanDesk::Job> PlanDesk::dropAll() {
  std::vector<Job> jobs;
  for (Open& open : open_) {
    drop(open);
    jobs.push_back(open.job);
  }
  open_.clear();
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
