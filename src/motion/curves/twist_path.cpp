#include "curves/twist_path.h"

#include <algorithm>
#include <limits>

namespace cobot_command::motion {

void TwistPath::append(double duration, const PathRate& from, const PathRate& to) {
  if (duration <= 0.0) {
    return;
  }
  pieces_.push_back({end_u_, duration, from, to, end_});
  end_u_ += duration;
  end_ = at(pieces_.back(), end_u_);
}

TwistPath TwistPath::part(double u, double less) const {
  TwistPath rest(*this);
  rest.begin_u_ = begin_u_ + u;
  rest.end_u_ = end_u_ - less;
  auto& pieces = rest.pieces_;
  while (!pieces.empty() && pieces.back().begin >= rest.end_u_) {
    pieces.pop_back();
  }
  const auto first = std::find_if(pieces.begin(), pieces.end(), [&](const Piece& piece) {
    return piece.begin + piece.duration > rest.begin_u_;
  });
  pieces.erase(pieces.begin(), first);
  rest.end_ = pieces.empty() ? at(u / duration()) : at(pieces.back(), rest.end_u_);
  return rest;
}

arm::Pose TwistPath::at(const Piece& piece, double u) {
  const double x = u - piece.begin;
  const double to_share = 0.5 * x * (x / piece.duration);
  const double from_share = x - to_share;
  arm::Pose pose = piece.start;
  pose.translation() += from_share * piece.from.head<3>() + to_share * piece.to.head<3>();
  pose.linear() = turnedBy(to_share * piece.to.tail<3>()) * turnedBy(from_share * piece.from.tail<3>()) *
                  piece.start.linear();
  return pose;
}

const TwistPath::Piece& TwistPath::pieceAt(double u) const {
  const auto behind = std::upper_bound(pieces_.begin(), pieces_.end(), u,
                                       [](double at, const Piece& piece) { return at < piece.begin; });
  return behind == pieces_.begin() ? *behind : *(behind - 1);
}

arm::Pose TwistPath::at(double progress) const {
  if (pieces_.empty()) {
    return end_;
  }
  const double u = parameter(progress);
  return at(pieceAt(u), u);
}

PathRate TwistPath::rateAt(double progress) const {
  if (pieces_.empty()) {
    return PathRate::Zero();
  }
  const double u = parameter(progress);
  const Piece& piece = pieceAt(u);
  const double x = u - piece.begin;
  const double to_rate = x / piece.duration;
  PathRate rate = (1.0 - to_rate) * piece.from + to_rate * piece.to;
  // What is turned first is turned on by what comes behind it.
  const Eigen::Vector3d from_turn = turnedBy(0.5 * x * to_rate * piece.to.tail<3>()) * piece.from.tail<3>();
  rate.tail<3>() = (1.0 - to_rate) * from_turn + to_rate * piece.to.tail<3>();
  return duration() * rate;
}

// The linear rate goes evenly from `from` to `to`. With x of the duration d behind the begin of the piece,
// the angular one is (1 - y) R f + y t, where y = x / d and R turns by y x / 2 t. So its derivative is (t - R
// f) / d + y (1 - y) t x R f. R f is off f by at most y x / 2 |t x f|, and |t x R f| = |t x f|, as t is the
// axis of R: together at most |t - f| / d + (1/2 + 1/4) |t x f|.
RateChange TwistPath::rateChange(double from, double to) const {
  RateChange most;
  if (pieces_.empty()) return most;
  const double end = parameter(to);
  for (const Piece* piece = &pieceAt(parameter(from)); piece->begin <= end; ++piece) {
    const PathRate gain = (piece->to - piece->from) / piece->duration;
    const double sideways = piece->to.tail<3>().cross(piece->from.tail<3>()).norm();
    most.linear = std::max(most.linear, gain.head<3>().norm());
    most.angular = std::max(most.angular, gain.tail<3>().norm() + 0.75 * sideways);
    if (piece == &pieces_.back()) break;
    if ((piece + 1)->begin <= end && !piece->to.isApprox((piece + 1)->from)) {
      most.linear = most.angular = std::numeric_limits<double>::infinity();
    }
  }
  return {duration() * duration() * most.linear, duration() * duration() * most.angular};
}

double TwistPath::length() const {
  double sum = 0.0;
  for (const Piece& piece : pieces_) {
    sum += 0.5 * piece.duration * (piece.from.head<3>().norm() + piece.to.head<3>().norm());
  }
  return sum;
}

double TwistPath::turn() const {
  double sum = 0.0;
  for (const Piece& piece : pieces_) {
    sum += 0.5 * piece.duration * (piece.from.tail<3>().norm() + piece.to.tail<3>().norm());
  }
  return sum;
}

}  // namespace cobot_command::motion
