#include "cobot_command/automata/synthesis.h"

#include <algorithm>

#include "backward_edges.h"

namespace cobot_command::automata {
namespace {

using Number = StateSpace::Number;

/// Which states of `within` reach a marked one without leaving it.
std::vector<bool> reachingMarked(const StateSpace& space, const BackwardEdges& backward,
                                 const std::vector<bool>& within) {
  std::vector<bool> reaches(space.size(), false);
  std::vector<Number> open;
  for (Number state = 0; state < space.size(); ++state) {
    if (!within[state] || !space.isMarked(state)) continue;
    reaches[state] = true;
    open.push_back(state);
  }
  while (!open.empty()) {
    const Number state = open.back();
    open.pop_back();
    for (const auto& edge : backward.into(state)) {
      if (!within[edge.from] || reaches[edge.from]) continue;
      reaches[edge.from] = true;
      open.push_back(edge.from);
    }
  }
  return reaches;
}

/// Takes out what uncontrollable events lead out from; `out` are states that have just been taken out.
void spread(const BackwardEdges& backward, std::vector<bool>& good, std::vector<Number> out) {
  while (!out.empty()) {
    const Number state = out.back();
    out.pop_back();
    for (const auto& edge : backward.into(state)) {
      if (edge.is_controllable || !good[edge.from]) continue;
      good[edge.from] = false;
      out.push_back(edge.from);
    }
  }
}

std::vector<bool> reachedWithin(const StateSpace& space, const std::vector<bool>& good) {
  std::vector<bool> reached(space.size(), false);
  if (!good[0]) return reached;
  std::vector<Number> open = {0};
  reached[0] = true;
  while (!open.empty()) {
    const Number state = open.back();
    open.pop_back();
    for (const auto& edge : space.edges(state)) {
      if (!good[edge.to] || reached[edge.to]) continue;
      reached[edge.to] = true;
      open.push_back(edge.to);
    }
  }
  return reached;
}

}  // namespace

Synthesis::Synthesis(const StateSpace& space) : space_(space) {
  const BackwardEdges backward(space);
  std::vector<bool> good(space.size(), true);
  std::vector<Number> out;
  for (Number state = 0; state < space.size(); ++state) {
    if (!space.breaksSpec(state)) continue;
    good[state] = false;
    out.push_back(state);
  }
  do {
    spread(backward, good, std::move(out));
    out.clear();
    const std::vector<bool> reaches = reachingMarked(space, backward, good);
    for (Number state = 0; state < space.size(); ++state) {
      if (!good[state] || reaches[state]) continue;
      good[state] = false;
      out.push_back(state);
    }
  } while (!out.empty());
  contains_ = reachedWithin(space, good);
  count();
}

void Synthesis::count() {
  for (Number state = 0; state < space_.size(); ++state) {
    if (!contains_[state]) continue;
    ++counts_.states;
    if (space_.isMarked(state)) ++counts_.marked;
    counts_.refused_by_spec += space_.refusedBySpec(state);
    for (const auto& edge : space_.edges(state)) {
      if (contains_[edge.to]) {
        ++counts_.transitions;
      } else {
        ++counts_.refused_beyond_spec;
        frontier_.push_back(edge.to);
      }
    }
  }
  std::sort(frontier_.begin(), frontier_.end());
  frontier_.erase(std::unique(frontier_.begin(), frontier_.end()), frontier_.end());
  counts_.frontier = frontier_.size();
}

Troubles troublesOf(const StateSpace& space) {
  const std::vector<bool> reaches =
      reachingMarked(space, BackwardEdges(space), std::vector<bool>(space.size(), true));
  Troubles troubles;
  for (Number state = 0; state < space.size(); ++state) {
    if (space.isMarked(state)) ++troubles.marked;
    if (space.edges(state).empty() && !space.isMarked(state)) ++troubles.deadlocks;
    if (!reaches[state]) ++troubles.blocking;
    if (space.breaksSpec(state)) ++troubles.breaking_spec;
  }
  return troubles;
}

std::vector<EventIndex> shortestWayIntoConflict(const StateSpace& space) {
  const std::vector<bool> reaches =
      reachingMarked(space, BackwardEdges(space), std::vector<bool>(space.size(), true));
  struct Before {
    Number state = 0;
    EventIndex event = 0;
  };
  // Exploring numbers states by steps, so that the first edge into one is of a shortest way, and the first
  // conflict nearest.
  std::vector<Before> before(space.size());
  std::vector<bool> seen(space.size(), false);
  seen[0] = true;
  for (Number state = 0; state < space.size(); ++state) {
    if (space.breaksSpec(state) || !reaches[state]) {
      std::vector<EventIndex> way;
      for (Number at = state; at != 0; at = before[at].state) way.push_back(before[at].event);
      std::reverse(way.begin(), way.end());
      return way;
    }
    for (const auto& edge : space.edges(state)) {
      if (seen[edge.to]) continue;
      seen[edge.to] = true;
      before[edge.to] = {state, edge.event};
    }
  }
  return {};
}

}  // namespace cobot_command::automata
