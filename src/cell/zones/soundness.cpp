#include "cobot_command/cell/zones/soundness.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include <fmt/format.h>

#include "cobot_command/cell/bodies/shape_capsules.h"
#include "cobot_command/common/units.h"

namespace cobot_command::cell {
namespace {

constexpr std::size_t kFaultsShown = 20;

/// A piece with what is needed of it here.
struct Posture {
  Capsules capsules;
  double displacement = 0.0;
  std::vector<bool> holds;  ///< by zone
  std::string name;
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
    if (count_ > kFaultsShown) found_.faults.push_back(fmt::format("and {} more", count_ - kFaultsShown));
    return std::move(found_);
  }

 private:
  void collect(RobotIndex robot, const RobotClaim& claim) {
    const RobotProgram& program = held_.program.robots[robot];
    const HeldRobot& held = held_.robots[robot];
    for (std::size_t station = 0; station < claim.stations.size(); ++station) {
      std::vector<bool> holds(held_.program.zones.size(), false);
      for (const ZoneIndex zone : held.at_stations[station]) holds[zone] = true;
      add(robot, claim.stations[station], std::move(holds),
          fmt::format("{} at {}", program.name, program.stations[station]));
    }
    for (std::size_t path = 0; path < claim.paths.size(); ++path) {
      for (std::size_t piece = 0; piece < claim.paths[path].pieces.size(); ++piece) {
        std::vector<bool> holds(held_.program.zones.size(), false);
        for (const Hold& hold : held.paths[path].holds) {
          if (hold.covers(piece)) holds[hold.zone] = true;
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

  void add(RobotIndex robot, const Piece& piece, std::vector<bool> holds, std::string name) {
    postures_[robot].push_back(
        {piece.capsulesAtCentre(), piece.displacement, std::move(holds), std::move(name)});
  }

  void comparePair(RobotIndex one, RobotIndex other) {
    for (const Posture& first : postures_[one]) {
      for (const Posture& second : postures_[other]) {
        if (isExcluded(first, second)) continue;
        ++found_.pairs;
        note(nearestOf(first.capsules, second.capsules).distance - first.displacement - second.displacement,
             first.name, second.name);
      }
    }
  }

  void compareWithObstacles(RobotIndex robot) {
    for (const Obstacle& obstacle : cell_.obstacles) {
      const auto capsules = capsulesOf(obstacle.shapes, cell_.parameters.body_cell);
      if (!capsules) {
        fault(fmt::format("obstacles.{}: {}", obstacle.name, capsules.error().message));
        continue;
      }
      for (const Posture& posture : postures_[robot]) {
        ++found_.pairs;
        note(nearestOf(posture.capsules, *capsules).distance - posture.displacement, posture.name,
             "the obstacle " + obstacle.name);
      }
    }
  }

  /// A zone is held in both, so that they never are there at once.
  [[nodiscard]] static bool isExcluded(const Posture& one, const Posture& other) {
    for (std::size_t zone = 0; zone < one.holds.size(); ++zone) {
      if (one.holds[zone] && other.holds[zone]) return true;
    }
    return false;
  }

  void note(double left, const std::string& one, const std::string& other) {
    if (left < found_.least) {
      found_.least = left;
      found_.worst = one + "; " + other;
    }
    if (left >= cell_.parameters.margin) return;
    double& least = faulty_.try_emplace({one, other}, std::numeric_limits<double>::infinity()).first->second;
    const bool is_new = std::isinf(least);
    least = std::min(least, left);
    if (is_new) {
      fault(fmt::format(
          "{}; {}: {:.1f} mm may be left between them, and no zone keeps them apart (margin {:.1f} mm)", one,
          other, mToMm(left), mToMm(cell_.parameters.margin)));
    }
  }

  void fault(std::string text) {
    if (++count_ <= kFaultsShown) found_.faults.push_back(std::move(text));
  }

  const Cell& cell_;
  const HeldCell& held_;
  std::vector<std::vector<Posture>> postures_;  ///< by robot
  std::map<std::pair<std::string, std::string>, double> faulty_;
  std::size_t count_ = 0;
  Soundness found_;
};

}  // namespace

Soundness checkSoundness(const Cell& cell, const std::vector<RobotClaim>& claims, const HeldCell& held) {
  return Check(cell, claims, held).run();
}

}  // namespace cobot_command::cell
