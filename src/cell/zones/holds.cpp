#include "cobot_command/cell/zones/holds.h"

#include <algorithm>
#include <utility>

#include "zones/approach.h"
#include "zones/path_holds.h"
#include <fmt/format.h>

namespace cobot_command::cell {
namespace {

struct PlacedStep {
  ZoneStep step;
  ZonePlace place;
};

/// Bookings of one frame are one step, all or nothing; what is released comes before what is booked at the
/// same place.
std::vector<PlacedStep> stepsOf(const std::vector<Hold>& holds, const PathClaim& claim,
                                bool enters_by_itself) {
  std::vector<PlacedStep> steps;
  for (const Hold& hold : holds) {
    if (hold.last_piece) {
      steps.push_back(
          {{false, {hold.zone}, false}, {claim.pieces[*hold.last_piece].frame, *hold.last_piece}});
    }
    if (!hold.first_frame) continue;
    const auto same = std::find_if(steps.begin(), steps.end(), [&](const PlacedStep& other) {
      return other.step.books && other.place.frame == *hold.first_frame;
    });
    if (same != steps.end()) {
      same->step.zones.push_back(hold.zone);
    } else {
      steps.push_back({{true, {hold.zone}, enters_by_itself}, {*hold.first_frame, hold.first_piece}});
    }
  }
  std::stable_sort(steps.begin(), steps.end(), [](const PlacedStep& one, const PlacedStep& other) {
    const auto key = [](const PlacedStep& step) {
      return std::make_tuple(step.place.frame, step.step.books ? 0 : 1, step.place.piece);
    };
    return key(one) < key(other);
  });
  return steps;
}

/// What holds have to know of a robot or a mechanism besides its claims.
struct Course {
  struct Way {
    std::string name;
    std::size_t from = 0;
    std::size_t to = 0;
    const PlannedPath* planned = nullptr;  ///< none: of a mechanism
    bool goes_by_itself = false;
    bool enters_by_itself = false;
  };
  std::string name;
  std::vector<std::string> stations;
  std::size_t home = 0;
  bool holds = false;
  std::vector<Way> ways;
};

CourseNames namesOf(const Course& course) {
  CourseNames names{course.name, course.stations, {}, {}};
  for (const Course::Way& way : course.ways) {
    names.paths.push_back(way.name);
    std::vector<std::size_t>& steps = names.steps.emplace_back();
    if (way.planned == nullptr) continue;
    for (const PlannedFrame& frame : way.planned->frames) steps.push_back(frame.step);
  }
  return names;
}

Course courseOf(const Robot& robot, const PlannedRobot& planned) {
  Course course{planned.name, {}, planned.home, robot.holds, {}};
  for (const PlannedStation& station : planned.stations) course.stations.push_back(station.name);
  for (const PlannedPath& path : planned.paths) {
    course.ways.push_back({path.name, path.from, path.to, &path, false, false});
  }
  return course;
}

Course courseOf(const Mechanism& mechanism) {
  Course course{mechanism.name, {}, 0, mechanism.holds, {}};
  for (const MechanismPosition& station : stationsOf(mechanism)) course.stations.push_back(station.name);
  const auto station = [&](const std::string& name) {
    const auto at = std::find(course.stations.begin(), course.stations.end(), name);
    return static_cast<std::size_t>(at - course.stations.begin());
  };
  course.home = station(mechanism.home);
  for (const MechanismPath& path : mechanism.program) {
    course.ways.push_back({path.name, station(path.from), station(path.to), nullptr, !path.controllable_go,
                           !path.controllable_book});
  }
  return course;
}

class Holder {
 public:
  Holder(const Cell& cell, const std::vector<Course>& courses, RobotIndex robot,
         const std::vector<RobotClaim>& claims, const std::vector<Zone>& zones,
         std::vector<std::string>& faults)
      : cell_(cell),
        courses_(courses),
        course_(courses[robot]),
        claims_(claims),
        claim_(claims[robot]),
        zones_(zones),
        faults_(faults) {
    // A zone of others is nothing to it, wherever it may be: what keeps it apart from each of them is a zone
    // of its own.
    for (ZoneIndex zone = 0; zone < zones.size(); ++zone) {
      if (std::binary_search(zones[zone].users.begin(), zones[zone].users.end(), robot)) {
        used_.push_back(zone);
      }
    }
  }

  HeldRobot held;
  RobotProgram program;

  void find() {
    program.name = course_.name;
    program.home = course_.home;
    program.stations = course_.stations;
    for (const Piece& rest : claim_.stations) held.at_stations.push_back(touchedBy(rest));
    checkHome();
    for (std::size_t path = 0; path < course_.ways.size(); ++path) findOnPath(path);
    checkLeaving();
  }

 private:
  [[nodiscard]] std::vector<ZoneIndex> touchedBy(const Piece& piece) const {
    std::vector<ZoneIndex> touched;
    for (const ZoneIndex zone : used_) {
      if (piece.claim.touches(zones_[zone].voxels)) touched.push_back(zone);
    }
    return touched;
  }

  void checkHome() {
    const auto& at_home = held.at_stations[course_.home];
    if (course_.holds) {
      program.held_at_home = at_home;
      return;
    }
    for (const ZoneIndex zone : at_home) {
      faults_.push_back(fmt::format(
          "{} is in {} at its home {}, which {} share ({}): choose another home, or let it hold the "
          "zone from the start (holds: true); {}",
          course_.name, zones_[zone].name, course_.stations[course_.home], usersOf(zone),
          boxOf(zones_[zone], cell_.parameters.voxel), othersIn(zone)));
    }
  }

  void findOnPath(std::size_t index) {
    const Course::Way& way = course_.ways[index];
    HeldPath on_path;
    for (const ZoneIndex zone : used_) {
      const auto has = [&](std::size_t station) {
        const auto& touched = held.at_stations[station];
        return std::binary_search(touched.begin(), touched.end(), zone);
      };
      for (Hold& hold :
           holdsOnPath({way.planned, claim_.paths[index], zones_[zone].voxels, has(way.from), has(way.to)})) {
        hold.zone = zone;
        on_path.holds.push_back(hold);
      }
    }
    PathProgram of_path{way.name, way.from, way.to, {}, way.goes_by_itself};
    for (PlacedStep& placed : stepsOf(on_path.holds, claim_.paths[index], way.enters_by_itself)) {
      of_path.steps.push_back(std::move(placed.step));
      on_path.places.push_back(placed.place);
    }
    held.paths.push_back(std::move(on_path));
    program.paths.push_back(std::move(of_path));
  }

  /// One that is in it wherever it rests and moves can let nobody else in.
  void checkLeaving() {
    for (const ZoneIndex zone : used_) {
      const auto is_inside = [&](const Piece& piece) { return piece.claim.touches(zones_[zone].voxels); };
      bool leaves = !std::all_of(claim_.stations.begin(), claim_.stations.end(), is_inside);
      for (const PathClaim& path : claim_.paths) {
        leaves = leaves || !std::all_of(path.pieces.begin(), path.pieces.end(), is_inside);
      }
      if (leaves) continue;
      faults_.push_back(
          fmt::format("{} never leaves {}, which {} share ({}): with this margin, its base or its program "
                      "keeps it inside permanently; at its home {}",
                      course_.name, zones_[zone].name, usersOf(zone),
                      boxOf(zones_[zone], cell_.parameters.voxel), othersIn(zone)));
    }
  }

  /// How near they come to its home.
  [[nodiscard]] std::string othersIn(ZoneIndex zone) const {
    std::vector<std::string> others;
    for (const RobotIndex user : zones_[zone].users) {
      if (&claims_[user] == &claim_) continue;
      others.push_back(nearestApproach(claim_.stations[course_.home], claims_[user], namesOf(courses_[user]),
                                       cell_.parameters));
    }
    return fmt::format("{}", fmt::join(others, "; "));
  }

  [[nodiscard]] std::string usersOf(ZoneIndex zone) const {
    std::vector<std::string> names;
    for (const RobotIndex user : zones_[zone].users) names.push_back(claims_[user].name);
    return fmt::format("{}", fmt::join(names, " and "));
  }

  const Cell& cell_;
  const std::vector<Course>& courses_;
  const Course& course_;
  const std::vector<RobotClaim>& claims_;
  const RobotClaim& claim_;
  const std::vector<Zone>& zones_;
  std::vector<ZoneIndex> used_;  ///< zones that are its own, too
  std::vector<std::string>& faults_;
};

}  // namespace

Result<HeldCell, std::vector<std::string>> holdZones(const Cell& cell,
                                                     const std::vector<PlannedRobot>& planned,
                                                     const std::vector<RobotClaim>& claims,
                                                     const std::vector<Zone>& zones) {
  std::vector<std::string> faults;
  HeldCell held;
  held.program.name = cell.name;
  for (const Zone& zone : zones) held.program.zones.push_back(zone.name);
  std::vector<Course> courses;
  for (RobotIndex robot = 0; robot < planned.size(); ++robot) {
    courses.push_back(courseOf(cell.robots[robot], planned[robot]));
  }
  for (const Mechanism& mechanism : cell.mechanisms) courses.push_back(courseOf(mechanism));
  for (RobotIndex robot = 0; robot < courses.size(); ++robot) {
    Holder holder(cell, courses, robot, claims, zones, faults);
    holder.find();
    held.robots.push_back(std::move(holder.held));
    held.program.robots.push_back(std::move(holder.program));
  }
  if (!faults.empty()) return refuse(faults);
  return held;
}

}  // namespace cobot_command::cell
