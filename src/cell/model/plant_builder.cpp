#include "model/plant_builder.h"

#include <algorithm>

#include <fmt/format.h>

namespace cobot_command::cell {

PlantBuilder::PlantBuilder(CellModel& model, RobotIndex robot, std::vector<std::string>& faults)
    : model_(model), robot_(robot), program_(model.program.robots[robot]), faults_(faults) {
  plant_.name = program_.name;
}

void PlantBuilder::build() {
  model_.places.emplace_back();
  if (!areIndicesInRange()) return;
  checkRoundTrips();
  const std::size_t before = faults_.size();
  findHoldsOfStations();
  if (faults_.size() != before) return;
  // Stations have the first states, so that paths can lead to those that come later.
  for (std::size_t station = 0; station < program_.stations.size(); ++station) {
    CellPlace place;
    place.station = station;
    place.holds = held_at_[station].value_or(Zones());
    place.name = program_.stations[station];
    addPlace(std::move(place));
  }
  for (PathIndex path = 0; path < program_.paths.size(); ++path) addPath(path);
  plant_.initial = static_cast<automata::StateIndex>(program_.home);
  plant_.marked = {plant_.initial};
  model_.places.back() = std::move(places_);
  model_.problem.automata.push_back(std::move(plant_));
}

bool PlantBuilder::areIndicesInRange() {
  const auto is_zone = [&](ZoneIndex zone) { return zone < model_.program.zones.size(); };
  const auto is_station = [&](std::size_t station) { return station < program_.stations.size(); };
  bool fits = is_station(program_.home) &&
              std::all_of(program_.held_at_home.begin(), program_.held_at_home.end(), is_zone);
  for (const PathProgram& path : program_.paths) {
    fits = fits && is_station(path.from) && is_station(path.to);
    for (const ZoneStep& step : path.steps) {
      fits = fits && !step.zones.empty() && std::all_of(step.zones.begin(), step.zones.end(), is_zone);
    }
  }
  if (!fits) {
    faults_.push_back(
        fmt::format("{}: its program names a station or zone that does not exist", program_.name));
  }
  return fits;
}

/// From home along all paths; where a station is reached with other zones than before, they disagree.
void PlantBuilder::findHoldsOfStations() {
  held_at_.resize(program_.stations.size());
  held_at_[program_.home] = program_.held_at_home;
  std::sort(held_at_[program_.home]->begin(), held_at_[program_.home]->end());
  std::vector<std::size_t> open = {program_.home};
  while (!open.empty()) {
    const std::size_t station = open.back();
    open.pop_back();
    for (const PathProgram& path : program_.paths) {
      if (path.from != station) continue;
      Zones held = *held_at_[station];
      for (const ZoneStep& step : path.steps) {
        if (!applyStep(path, step, held)) return;
      }
      auto& known = held_at_[path.to];
      if (!known) {
        known = held;
        open.push_back(path.to);
      } else if (*known != held) {
        faults_.push_back(fmt::format("{}: at {} it holds {} if it arrives by {}, but {} otherwise",
                                      program_.name, program_.stations[path.to], zoneNames(held), path.name,
                                      zoneNames(*known)));
      }
    }
  }
}

bool PlantBuilder::applyStep(const PathProgram& path, const ZoneStep& step, Zones& held) {
  for (const ZoneIndex zone : step.zones) {
    const auto at = std::lower_bound(held.begin(), held.end(), zone);
    const bool is_held = at != held.end() && *at == zone;
    if (is_held == step.books) {
      faults_.push_back(fmt::format("{}: on {} it {} {}, which it {}", program_.name, path.name,
                                    step.books ? "books" : "releases", model_.program.zones[zone],
                                    step.books ? "already holds" : "does not hold"));
      return false;
    }
    if (step.books) {
      held.insert(at, zone);
    } else {
      held.erase(at);
    }
  }
  return true;
}

automata::StateIndex PlantBuilder::addPlace(CellPlace place) {
  plant_.states.push_back(fmt::format("{}.{}", program_.name, place.name));
  places_.push_back(std::move(place));
  return static_cast<automata::StateIndex>(plant_.states.size() - 1);
}

void PlantBuilder::addPath(PathIndex index) {
  const PathProgram& path = program_.paths[index];
  Zones held = places_[path.from].holds;
  const auto add_place_behind = [&](std::size_t steps) {
    CellPlace place;
    place.path = index;
    place.behind = steps;
    place.holds = held;
    place.name = steps == 0 ? path.name + ">" : fmt::format("{}>{}", path.name, steps);
    return addPlace(std::move(place));
  };
  automata::StateIndex at = add_place_behind(0);
  addEvent({CellEvent::Kind::Go, robot_, index, {}}, !path.uncontrollable_go,
           static_cast<automata::StateIndex>(path.from), at);
  for (std::size_t step = 0; step < path.steps.size(); ++step) {
    const ZoneStep& zone_step = path.steps[step];
    if (!applyStep(path, zone_step, held)) return;
    const automata::StateIndex next = add_place_behind(step + 1);
    addEvent(
        {zone_step.books ? CellEvent::Kind::Book : CellEvent::Kind::Release, robot_, index, zone_step.zones},
        zone_step.books && !zone_step.uncontrollable, at, next);
    at = next;
  }
  addEvent({CellEvent::Kind::Reached, robot_, index, {}}, false, at,
           static_cast<automata::StateIndex>(path.to));
}

void PlantBuilder::addEvent(CellEvent event, bool controllable, automata::StateIndex from,
                            automata::StateIndex to) {
  const auto index = static_cast<automata::EventIndex>(model_.events.size());
  model_.problem.events.push_back({eventName(event), controllable});
  model_.events.push_back(std::move(event));
  plant_.alphabet.push_back(index);
  plant_.transitions.push_back({from, index, to});
}

std::string PlantBuilder::eventName(const CellEvent& event) {
  const std::string& path = program_.paths[event.path].name;
  std::string name;
  switch (event.kind) {
    case CellEvent::Kind::Go:
      name = fmt::format("{}_g_{}", program_.name, path);
      break;
    case CellEvent::Kind::Book:
      name = fmt::format("{}_b_{}", program_.name, zoneNames(event.zones));
      break;
    case CellEvent::Kind::Release:
      name = fmt::format("{}_u_{}", program_.name, zoneNames(event.zones));
      break;
    case CellEvent::Kind::Reached:
      name = fmt::format("{}_r_{}", program_.name, path);
      break;
  }
  const int count = ++names_[name];
  return count == 1 ? name : fmt::format("{}#{}", name, count);
}

std::vector<bool> PlantBuilder::reached(std::size_t station, bool forward) const {
  std::vector<bool> reached(program_.stations.size(), false);
  std::vector<std::size_t> open = {station};
  reached[station] = true;
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    for (const PathProgram& path : program_.paths) {
      const std::size_t next = forward ? path.to : path.from;
      if ((forward ? path.from : path.to) != at || reached[next]) continue;
      reached[next] = true;
      open.push_back(next);
    }
  }
  return reached;
}

void PlantBuilder::checkRoundTrips() {
  const auto out = reached(program_.home, true);
  const auto back = reached(program_.home, false);
  for (std::size_t station = 0; station < program_.stations.size(); ++station) {
    if (out[station] && back[station]) continue;
    faults_.push_back(
        fmt::format("{}: no paths lead {} {}: each station needs a path from home and a path back",
                    program_.name, out[station] ? "home from" : "from home to", program_.stations[station]));
  }
}

std::string PlantBuilder::zoneNames(const Zones& zones) const {
  if (zones.empty()) return "nothing";
  std::vector<std::string> names;
  for (const ZoneIndex zone : zones) names.push_back(model_.program.zones[zone]);
  return fmt::format("{}", fmt::join(names, "+"));
}

}  // namespace cobot_command::cell
