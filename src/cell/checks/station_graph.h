// Programs as graphs: stations, or positions of mechanisms, with paths between them.
#pragma once

#include <string>
#include <vector>

#include "checks/fault_list.h"

namespace cobot_command::cell {

struct Link {
  std::string path;
  std::string from;
  std::string to;
  Place place;
};
template <class Way>
[[nodiscard]] std::vector<Link> linksOf(const std::vector<Way>& program) {
  std::vector<Link> links;
  links.reserve(program.size());
  for (const Way& path : program) links.push_back({path.name, path.from, path.to, path.place});
  return links;
}

/// Each path has a name of its own, and from each station that a path begins or ends at, home included, every
/// other one is reached. `place`: of the program.
void checkGraph(const std::vector<Link>& links, const std::string& home, const Place& place,
                const std::string& field, FaultList& faults);

}  // namespace cobot_command::cell
