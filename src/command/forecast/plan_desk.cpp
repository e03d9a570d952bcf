#include "forecast/plan_desk.h"

#include <algorithm>
#include <utility>

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
    open_.insert(placeFor(open.job.purpose), std::move(open));
  }
}

PlanDesk::Place PlanDesk::placeFor(Purpose purpose) {
  if (purpose != Purpose::Send) return open_.end();
  const auto place = std::find_if(open_.begin(), open_.end(),
                                  [](const Open& open) { return open.job.purpose != Purpose::Send; });
  if (place != open_.end() && place->deadline) {
    giveUp(place->dropped);
    place->id = ++last_;  // what comes of its first beginning is for nobody
    place->deadline.reset();
  }
  return place;
}

PlanWork PlanDesk::begin(Open& open, Instant now) {
  open.dropped = std::make_shared<std::atomic<bool>>(false);
  return open.job.make(open.dropped, now);
}

void PlanDesk::proceed(Instant now) {
  if (open_.empty() || open_.front().deadline) return;
  Open& first = open_.front();
  first.deadline = now + budget_;
  actions_.emplace_back(PlanAsked{first.id, begin(first, now)});
}

PlanDesk::Job PlanDesk::remove(Place open) {
  giveUp(open->dropped);
  Job job = std::move(open->job);
  open_.erase(open);
  return job;
}

void PlanDesk::answered(PlanJobId id, PlanAnswer answer) {
  const auto open = std::find_if(open_.begin(), open_.end(), [id](const Open& o) { return o.id == id; });
  if (open != open_.end()) remove(open).take(std::move(answer));
}

void PlanDesk::endOverdue(Instant now) {
  while (!open_.empty() && open_.front().deadline && now >= *open_.front().deadline) {
    remove(open_.begin()).take(std::nullopt);
  }
}

std::optional<Instant> PlanDesk::nextDeadline() const {
  return open_.empty() ? std::nullopt : open_.front().deadline;
}

std::size_t PlanDesk::checks() const {
  return static_cast<std::size_t>(std::count_if(
      open_.begin(), open_.end(), [](const Open& open) { return open.job.purpose == Purpose::Check; }));
}

void PlanDesk::drop(blocks::GoalId goal) {
  for (auto open = open_.begin(); open != open_.end();) {
    const bool dropped = open->job.goal == goal && open->job.purpose != Purpose::Check;
    if (dropped) giveUp(open->dropped);
    open = dropped ? open_.erase(open) : open + 1;
  }
}

std::optional<PlanDesk::Job> PlanDesk::dropCheck(blocks::GoalId goal) {
  const auto open = std::find_if(open_.begin(), open_.end(), [goal](const Open& o) {
    return o.job.goal == goal && o.job.purpose == Purpose::Check;
  });
  return open == open_.end() ? std::nullopt : std::make_optional(remove(open));
}

std::vector<PlanDesk::Job> PlanDesk::dropChecks() {
  std::vector<Job> jobs;
  for (auto open = open_.begin(); open != open_.end();) {
    if (open->job.purpose != Purpose::Check) {
      ++open;
      continue;
    }
    giveUp(open->dropped);
    jobs.push_back(std::move(open->job));
    open = open_.erase(open);
  }
  return jobs;
}

}  // namespace cobot_command::command
