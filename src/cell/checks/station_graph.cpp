#include "checks/station_graph.h"

#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace cobot_command::cell {

namespace {

using Names = std::set<std::string>;

Names reachedFrom(const std::string& start, std::vector<Link> links, bool backwards) {
  if (backwards) {
    for (Link& link : links) std::swap(link.from, link.to);
  }
  Names reached{start};
  for (bool grown = true; grown;) {
    grown = false;
    for (const Link& link : links) {
      if (reached.count(link.from) > 0) grown = reached.insert(link.to).second || grown;
    }
  }
  return reached;
}

void checkNames(const std::vector<Link>& links, const std::string& field, FaultList& faults) {
  std::map<std::string, Place> seen;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const auto [first, is_new] = seen.emplace(links[i].path, links[i].place);
    if (is_new) continue;
    faults.add(
        links[i].place, fmt::format("{}[{}]", field, i),
        {"path", fmt::format("is {}, the same as the path of line {}", links[i].path, first->second.line),
         "a different name for each path", "rename one of them"});
  }
}

}  // namespace

void checkGraph(const std::vector<Link>& links, const std::string& home, const Place& place,
                const std::string& field, FaultList& faults) {
  if (links.empty()) {
    faults.add(place, field, {"", "has no paths", "at least one path", "add paths away from home and back"});
    return;
  }
  checkNames(links, field, faults);
  const Names ahead = reachedFrom(home, links, false);
  const Names back = reachedFrom(home, links, true);
  if (ahead.size() == 1 && back.size() == 1 && links.front().from != home) {
    faults.add(place, field,
               {"", fmt::format("has no path from home, {}", home), "a program that begins and ends at home",
                "add paths from home and back"});
    return;
  }
  Names told;
  for (std::size_t i = 0; i < links.size(); ++i) {
    for (const std::string& station : {links[i].from, links[i].to}) {
      const bool found = ahead.count(station) > 0;
      if ((found && back.count(station) > 0) || !told.insert(station).second) continue;
      faults.add(links[i].place, fmt::format("{}[{}]", field, i),
                 {"",
                  fmt::format(found ? "has {}, from where no paths lead home, to {}"
                                    : "has {}, to where no paths lead from home, {}",
                              station, home),
                  "every station reached from home, and home from every station",
                  fmt::format("add a path {} {}", found ? "from" : "to", station)});
    }
  }
}

}  // namespace cobot_command::cell
