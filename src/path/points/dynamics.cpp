#include "points/dynamics.h"

#include <cmath>

#include <fmt/format.h>

#include "cobot_command/common/units.h"

namespace cobot_command::path {
namespace {

bool isInterpolation(int number) {
  return number >= static_cast<int>(Interpolation::Ptp) &&
         number <= static_cast<int>(Interpolation::Circular);
}

using Field = double Dynamics::*;
using PointField = double PathPoint::*;

struct Row {
  PointField given;
  Field kept;
  const char* name;
};

constexpr std::array<Row, 3> kRates{{{&PathPoint::speed, &Dynamics::speed, "speed"},
                                     {&PathPoint::acceleration, &Dynamics::acceleration, "acceleration"},
                                     {&PathPoint::deceleration, &Dynamics::deceleration, "deceleration"}}};
constexpr std::array<Row, 2> kJerks{
    {{&PathPoint::acceleration_jerk, &Dynamics::acceleration_jerk, "acceleration_jerk"},
     {&PathPoint::deceleration_jerk, &Dynamics::deceleration_jerk, "deceleration_jerk"}}};
constexpr std::array<Row, 3> kOrientationRates{
    {{&PathPoint::orientation_speed, &Dynamics::orientation_speed, "orientation_speed"},
     {&PathPoint::orientation_acceleration, &Dynamics::orientation_acceleration, "orientation_acceleration"},
     {&PathPoint::orientation_deceleration, &Dynamics::orientation_deceleration,
      "orientation_deceleration"}}};

/// Above 0; 0 where there is one to be kept.
template <std::size_t kCount>
std::optional<PathRefusal> takeRates(const std::array<Row, kCount>& rows, const PathPoint& point, int index,
                                     int error_id, Dynamics& kept) {
  for (const Row& row : rows) {
    const double given = point.*row.given;
    const bool keeps = given == 0.0 && kept.*row.kept > 0.0;
    if (!keeps && !(given > 0.0 && std::isfinite(given))) {
      return PathRefusal{error_id, index, -1,
                         fmt::format("{} is {}, allowed: above 0, or 0 if a point of the same kind (PTP or "
                                     "not) precedes it in the goal: give one",
                                     row.name, given)};
    }
    if (!keeps) kept.*row.kept = given;
  }
  return std::nullopt;
}

std::optional<PathRefusal> takeJerks(const PathPoint& point, int index, Dynamics& kept) {
  for (const Row& row : kJerks) {
    const double given = point.*row.given;
    if (!(given >= 0.0 && given <= 100.0)) {
      return PathRefusal{path_error::kJerk, index, -1,
                         fmt::format("{} is {} %, allowed: 0 to 100 % of the ramp's time: choose one in this "
                                     "range",
                                     row.name, given)};
    }
    if (given > 0.0) kept.*row.kept = given;
  }
  return std::nullopt;
}

/// Of a point whose interpolation is none, which is refused for that: what could be of no kind at all.
std::optional<PathRefusal> checkOfNoKind(const PathPoint& point, int index) {
  Dynamics any;
  any.speed = any.acceleration = any.deceleration = 1.0;
  auto refusal = takeRates(kRates, point, index, path_error::kDynamics, any);
  return refusal ? refusal : takeJerks(point, index, any);
}

motion::Rates timesFeedrate(const motion::Rates& rates, double feedrate) {
  return {rates.speed * feedrate, rates.acceleration * feedrate * feedrate,
          rates.deceleration * feedrate * feedrate};
}

}  // namespace

std::optional<PathRefusal> DynamicsOfGoal::take(const PathPoint& point, int index) {
  if (!isInterpolation(point.interpolation)) return checkOfNoKind(point, index);
  const bool is_ptp = is(point.interpolation, Interpolation::Ptp);
  const std::size_t number = is_ptp ? 0 : 1;
  std::optional<Dynamics>& kind = kinds_[number];
  Dynamics kept = kind.value_or(Dynamics{});
  auto refusal = takeRates(kRates, point, index, path_error::kDynamics, kept);
  if (!refusal) refusal = takeJerks(point, index, kept);
  if (!refusal && !is_ptp) {
    refusal = takeRates(kOrientationRates, point, index, path_error::kOrientationDynamics, kept);
  }
  if (refusal) return refusal;
  kind = kept;
  last_ = number;
  return std::nullopt;
}

motion::Rates jointRates(const Dynamics& dynamics, double feedrate) {
  return timesFeedrate(
      {degToRad(dynamics.speed), degToRad(dynamics.acceleration), degToRad(dynamics.deceleration)}, feedrate);
}

motion::PathRates pathRates(const Dynamics& dynamics, int profile_type, double feedrate) {
  return {timesFeedrate({mmToM(dynamics.speed), mmToM(dynamics.acceleration), mmToM(dynamics.deceleration)},
                        feedrate),
          timesFeedrate({degToRad(dynamics.orientation_speed), degToRad(dynamics.orientation_acceleration),
                         degToRad(dynamics.orientation_deceleration)},
                        feedrate),
          rampShape(dynamics, profile_type)};
}

motion::RampShape rampShape(const Dynamics& dynamics, int profile_type) {
  using motion::SpeedLaw;
  constexpr std::array<SpeedLaw, 4> kLaws{SpeedLaw::SCurve, SpeedLaw::Poly5, SpeedLaw::ModSine,
                                          SpeedLaw::SineSquared};
  return {kLaws.at(static_cast<std::size_t>(profile_type)), dynamics.acceleration_jerk / 100.0,
          dynamics.deceleration_jerk / 100.0};
}

}  // namespace cobot_command::path
