#include "cobot_command/cell/zones/soundness.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/cell/bodies/shape_capsules.h"
#include "cobot_command/common/units.h"

namespace cobot_command::cell {
namespace {

constexpr std::size_t kFaultsShown = 20;

/// Zones, as bits.
class HeldZones {
 public:
  explicit HeldZones(std::size_t zones) : words_((zones + 63) / 64) {}
  void add(ZoneIndex zone) { words_[zone / 64] |= std::uint64_t{1} << (zone % 64); }
  [[nodiscard]] bool meets(const HeldZones& other) const {
    for (std::size_t word = 0; word < words_.size(); ++word) {
      if ((words_[word] & other.words_[word]) != 0) return true;
    }
    return false;
  }

 private:
  std::vector<std::uint64_t> words_;
};

/// A piece with what is needed of it here.
struct Posture {
  Capsules capsules;
  AlignedBox box;
  double displacement = 0.0;
  HeldZones holds;
  std::string name;
  const std::vector<Body>* bodies = nullptr;  ///< of an arm, by capsule

  [[nodiscard]] std::string bodyOf(std::size_t capsule) const {
    return bodies != nullptr ? fmt::format(" ({})", (*bodies)[capsule].name) : "";
  }
};

/// Without what it may stand with on an obstacle.
std::vector<std::size_t> movingOf(const Posture& posture) {
  std::vector<std::size_t> moving;
  for (std::size_t i = 0; i < posture.capsules.size(); ++i) {
    if (posture.bodies == nullptr || !isFixed((*posture.bodies)[i])) moving.push_back(i);
  }
  return moving;
}

/// The least that may be left between two of that name, and of which bodies.
struct Shortfall {
  double left = 0.0;
  std::string bodies;
};

class Check {
 public:
  Check(const Cell& cell, const std::vector<RobotClaim>& claims, const HeldCell& held)
      : cell_(cell), held_(held), postures_(claims.size()) {
    found_.least = std::numeric_limits<double>::infinity();
    for (RobotIndex robot = 0; robot < claims.size(); ++robot) collect(robot, claims[robot]);
  }

  Soundness run() {
    for (RobotIndex one = 0; one < postures_.size(); ++one) {
      for (RobotIndex other = one + 1; other < postures_.size(); ++other) comparePair(one, other);
      compareWithObstacles(one);
    }
    tellFaults();
    return std::move(found_);
  }

 private:
  void collect(RobotIndex robot, const RobotClaim& claim) {
    const RobotProgram& program = held_.program.robots[robot];
    const HeldRobot& held = held_.robots[robot];
    for (std::size_t station = 0; station < claim.stations.size(); ++station) {
      HeldZones holds(held_.program.zones.size());
      for (const ZoneIndex zone : held.at_stations[station]) holds.add(zone);
      add(robot, claim.stations[station], std::move(holds),
          fmt::format("{} at {}", program.name, program.stations[station]));
    }
    for (std::size_t path = 0; path < claim.paths.size(); ++path) {
      for (std::size_t piece = 0; piece < claim.paths[path].pieces.size(); ++piece) {
        HeldZones holds(held_.program.zones.size());
        for (const Hold& hold : held.paths[path].holds) {
          if (hold.covers(piece)) holds.add(hold.zone);
        }
        const Piece& of_path = claim.paths[path].pieces[piece];
        add(robot, of_path, std::move(holds),
            nameOn(program.name + " on " + program.paths[path].name, of_path));
      }
    }
  }

  [[nodiscard]] static std::string nameOn(std::string path, const Piece& piece) {
    if (piece.isOfMechanism()) return path;
    return fmt::format("{}, step {}", path, piece.frame + 1);
  }

  void add(RobotIndex robot, const Piece& piece, HeldZones holds, std::string name) {
    Capsules capsules = piece.capsulesAtCentre();
    const AlignedBox box = boxAround(capsules);
    const auto* arm = std::get_if<ArmPosture>(&piece.posture);
    postures_[robot].push_back({std::move(capsules), box, piece.displacement, std::move(holds),
                                std::move(name), arm != nullptr ? &arm->bodies->bodies() : nullptr});
  }

  void comparePair(RobotIndex one, RobotIndex other) {
    for (const Posture& first : postures_[one]) {
      for (const Posture& second : postures_[other]) {
        // A zone is held in both, so that they never are there at once.
        if (first.holds.meets(second.holds)) continue;
        ++found_.pairs;
        const double displacement = first.displacement + second.displacement;
        // Nearer than their boxes they are not.
        if (isOfNoConcern(leastDistance(first.box, second.box) - displacement)) continue;
        const Nearest nearest = nearestOf(first.capsules, second.capsules);
        note(nearest.distance - displacement, {first.name, second.name},
             first.bodyOf(nearest.first) + second.bodyOf(nearest.second));
      }
    }
  }

  void compareWithObstacles(RobotIndex robot) {
    for (const Obstacle& obstacle : cell_.obstacles) {
      const auto capsules = capsulesOf(obstacle.shapes, cell_.parameters.body_cell);
      if (!capsules) {
        found_.faults.push_back(fmt::format("obstacles.{}: {}", obstacle.name, capsules.error().message));
        continue;
      }
      for (const Posture& posture : postures_[robot]) {
        ++found_.pairs;
        const std::vector<std::size_t> moving = movingOf(posture);
        Capsules bodies;
        for (const std::size_t capsule : moving) bodies.push_back(posture.capsules[capsule]);
        const Nearest nearest = nearestOf(bodies, *capsules);
        note(nearest.distance - posture.displacement, {posture.name, "the obstacle " + obstacle.name},
             moving.empty() ? "" : posture.bodyOf(moving[nearest.first]));
      }
    }
  }

  /// So much at least is left between them.
  [[nodiscard]] bool isOfNoConcern(double left) const {
    return left >= found_.least && left >= cell_.parameters.margin;
  }

  void note(double left, const std::pair<std::string, std::string>& names, const std::string& bodies) {
    if (left < found_.least) {
      found_.least = left;
      found_.worst = names.first + "; " + names.second;
    }
    if (left >= cell_.parameters.margin) return;
    Shortfall& least = faulty_.try_emplace(names, Shortfall{left, bodies}).first->second;
    if (left < least.left) least = {left, bodies};
  }

  void tellFaults() {
    for (const auto& [names, least] : faulty_) {
      found_.faults.push_back(
          fmt::format("{}; {}: only {:.1f} mm remain between them{}, and no zone separates them (margin "
                      "{:.1f} mm): {:.1f} mm more are needed",
                      names.first, names.second, mToMm(least.left), least.bodies,
                      mToMm(cell_.parameters.margin), mToMm(cell_.parameters.margin - least.left)));
    }
    if (found_.faults.size() <= kFaultsShown) return;
    const std::size_t more = found_.faults.size() - kFaultsShown;
    found_.faults.resize(kFaultsShown);
    found_.faults.push_back(fmt::format("and {} more", more));
  }

  const Cell& cell_;
  const HeldCell& held_;
  std::vector<std::vector<Posture>> postures_;  ///< by robot
  std::map<std::pair<std::string, std::string>, Shortfall> faulty_;
  Soundness found_;
};

}  // namespace

Soundness checkSoundness(const Cell& cell, const std::vector<RobotClaim>& claims, const HeldCell& held) {
  return Check(cell, claims, held).run();
}

}  // namespace cobot_command::cell
