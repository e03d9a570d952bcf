#include "agent/program_walk.h"

#include <algorithm>
#include <cassert>

namespace cobot_command::cell {

using Kind = NumberedEvent::Kind;

ProgramWalk::ProgramWalk(const CellModel& model, RobotIndex robot)
    : model_(model), robot_(robot), place_(model.problem.automata[robot].initial) {}

automata::EventIndex ProgramWalk::goOf(PathIndex path) const {
  for (const auto& transition : model_.problem.automata[robot_].transitions) {
    if (transition.from == place_ && model_.events[transition.event].path == path) return transition.event;
  }
  assert(false && "no such path leads from here");
  return 0;
}

automata::EventIndex ProgramWalk::next() const {
  assert(!place().station);
  const auto& transitions = model_.problem.automata[robot_].transitions;
  const auto found = std::find_if(transitions.begin(), transitions.end(),
                                  [this](const auto& transition) { return transition.from == place_; });
  assert(found != transitions.end());
  return found->event;
}

automata::StateIndex ProgramWalk::behind(automata::EventIndex event) const {
  for (const auto& transition : model_.problem.automata[robot_].transitions) {
    if (transition.from == place_ && transition.event == event) return transition.to;
  }
  assert(false && "no such event is possible here");
  return place_;
}

void ProgramWalk::tell(Kind kind, automata::EventIndex event) {
  events_.push_back({++number_, kind, event});
}

void ProgramWalk::want(automata::EventIndex event) {
  assert(!wanted_);
  granted_.reset();
  tell(Kind::Wanted, event);
  wanted_ = events_.back();
}

void ProgramWalk::happened(automata::EventIndex event) {
  assert(!wanted_);
  granted_.reset();
  tell(Kind::Happened, event);
  place_ = behind(event);
}

void ProgramWalk::withdraw() {
  if (wanted_) {
    tell(Kind::Withdrawn, wanted_->event);
    wanted_.reset();
  } else if (granted_) {
    tell(Kind::Withdrawn, granted_->event);
    place_ = granted_->before;
    granted_.reset();
  }
}

void ProgramWalk::acknowledge(std::uint64_t number) {
  const auto is_told = [number](const NumberedEvent& event) { return event.number <= number; };
  events_.erase(std::remove_if(events_.begin(), events_.end(), is_told), events_.end());
  if (!wanted_ || wanted_->number > number) return;
  granted_ = Granted{wanted_->event, place_};
  place_ = behind(wanted_->event);
  wanted_.reset();
}

bool ProgramWalk::restart(const std::string& name, std::uint64_t number) {
  const auto& places = model_.places[robot_];
  const auto place =
      std::find_if(places.begin(), places.end(), [&](const CellPlace& one) { return one.name == name; });
  if (place == places.end()) return false;
  place_ = static_cast<automata::StateIndex>(place - places.begin());
  number_ = number;
  events_.clear();
  wanted_.reset();
  granted_.reset();
  return true;
}

}  // namespace cobot_command::cell
