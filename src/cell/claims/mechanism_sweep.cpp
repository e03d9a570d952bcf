#include "claims/mechanism_sweep.h"

#include <cmath>
#include <utility>

#include "cobot_command/cell/claims/cell_bodies.h"

namespace cobot_command::cell {
namespace {

class MechanismSweep {
 public:
  MechanismSweep(const Parameters& parameters, const Mechanism& mechanism, MechanismBodies bodies)
      : parameters_(parameters),
        mechanism_(mechanism),
        bodies_(std::make_shared<const MechanismBodies>(std::move(bodies))) {}

  [[nodiscard]] RobotClaim pieces() const {
    RobotClaim claim;
    claim.name = mechanism_.name;
    for (const MechanismPosition& station : stationsOf(mechanism_)) {
      claim.stations.push_back(piece(Piece::Kind::Rest, station.value, station.value));
    }
    for (const MechanismPath& path : mechanism_.program) {
      const double to = find(mechanism_.positions, path.to)->value;
      PathClaim& of_path = claim.paths.emplace_back();
      claimMotion(find(mechanism_.positions, path.from)->value, to, of_path.pieces);
      of_path.pieces.push_back(piece(Piece::Kind::Rest, to, to));
    }
    return claim;
  }

 private:
  /// Nobody knows how fast it is where, so that it is cut by values of its axis, in the order in which it
  /// passes them.
  void claimMotion(double from, double to, std::vector<Piece>& pieces) const {
    if (bodies_->largestDisplacement(halfOf(from, to)) <= parameters_.step_bound) {
      pieces.push_back(piece(Piece::Kind::Motion, from, to));
      return;
    }
    const double middle = 0.5 * (from + to);
    claimMotion(from, middle, pieces);
    claimMotion(middle, to, pieces);
  }

  [[nodiscard]] Piece piece(Piece::Kind kind, double from, double to) const {
    Piece piece;
    piece.kind = kind;
    piece.posture = AxisPosture{from, to, bodies_};
    piece.displacement = bodies_->largestDisplacement(halfOf(from, to));
    return piece;
  }

  [[nodiscard]] static double halfOf(double from, double to) { return 0.5 * std::abs(to - from); }

  const Parameters& parameters_;
  const Mechanism& mechanism_;
  std::shared_ptr<const MechanismBodies> bodies_;
};

}  // namespace

Result<RobotClaim, std::string> piecesOfMechanism(const Parameters& parameters, const Mechanism& mechanism) {
  auto bodies = mechanismBodiesOf(parameters, mechanism);
  if (!bodies) return refuse(bodies.error().message);
  return MechanismSweep(parameters, mechanism, std::move(*bodies)).pieces();
}

}  // namespace cobot_command::cell
