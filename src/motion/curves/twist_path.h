// A TCP curve in pieces of constant velocity, and of velocity that passes evenly from one to the next: chains
// of lines with rounded corners, and velocities that are set one after the other.
#pragma once

#include <vector>

#include "curves/tcp_curve.h"

namespace cobot_command::motion {

/// Its parameter u is a time [s]: that at top speed, whatever the profile makes of it. Immutable but for
/// append().
class TwistPath final : public TcpCurve {
 public:
  /// Begins at `start` with u = 0.
  explicit TwistPath(const arm::Pose& start) : end_(start) {}

  /// Behind all before it, for `duration` of u (0: nothing) the velocity goes evenly from `from` to `to`
  /// [m/s, rad/s, in the frame of the path]: p = start + a from + b to, R = R(b to) R(a from) R(start), with
  /// a = u - u^2 / (2 duration), b = u^2 / (2 duration). Position and velocity are continuous.
  void append(double duration, const PathRate& from, const PathRate& to);
  /// At one velocity.
  void append(double duration, const PathRate& velocity) { append(duration, velocity, velocity); }

  /// The rest of it from u on, whose u begins with 0, without the last `less` of u. Precondition: what is cut
  /// off at the end is part of a piece of constant velocity.
  [[nodiscard]] TwistPath part(double u, double less) const;

  /// The end of u.
  [[nodiscard]] double duration() const { return end_u_ - begin_u_; }
  [[nodiscard]] arm::Pose end() const { return end_; }

  [[nodiscard]] double length() const override;
  [[nodiscard]] double turn() const override;
  [[nodiscard]] arm::Pose at(double progress) const override;
  [[nodiscard]] PathRate rateAt(double progress) const override;
  [[nodiscard]] RateChange rateChange(double from, double to) const override;

 private:
  struct Piece {
    double begin;
    double duration;
    PathRate from;
    PathRate to;
    arm::Pose start;
  };
  [[nodiscard]] static arm::Pose at(const Piece& piece, double u);
  [[nodiscard]] const Piece& pieceAt(double u) const;
  [[nodiscard]] double parameter(double progress) const { return begin_u_ + progress * duration(); }

  std::vector<Piece> pieces_;
  double begin_u_ = 0.0;
  double end_u_ = 0.0;
  arm::Pose end_;
};

}  // namespace cobot_command::motion
