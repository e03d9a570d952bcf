#include "profiles/ramp.h"

#include <array>
#include <cmath>

#include "cobot_command/common/units.h"

namespace cobot_command::motion {
namespace {

/// Of a ramp whose acceleration varies all the time, with its time and top speed as units. Each law is given
/// for the first half.
struct Law {
  double (*speed)(double time);
  double (*way)(double time);
  double steepest;  ///< acceleration in the middle
};

double cubed(double x) {
  return x * x * x;
}

namespace s_curve {
double speed(double t) {
  return t * t * (3.0 - 2.0 * t);
}
double way(double t) {
  return cubed(t) * (1.0 - 0.5 * t);
}
}  // namespace s_curve

namespace poly5 {
double speed(double t) {
  return cubed(t) * (10.0 + t * (6.0 * t - 15.0));
}
double way(double t) {
  return cubed(t) * t * (2.5 + t * (t - 3.0));
}
}  // namespace poly5

/// Modified sine: a quarter of a sine up to an eighth of the time, then three times as slow.
namespace mod_sine {
constexpr double kShare = 1.0 / (4.0 + kPi);
constexpr double kEighth = 0.125;

double speed(double t) {
  const double turn = 4.0 * kPi * t;
  return t <= kEighth ? kShare * (kPi * t - 0.25 * std::sin(turn))
                      : kShare * (2.0 + kPi * t - 2.25 * std::sin((turn + kPi) / 3.0));
}
double way(double t) {
  const double turn = 4.0 * kPi * t;
  if (t <= kEighth) return kShare * (0.5 * kPi * t * t + (std::cos(turn) - 1.0) / (16.0 * kPi));
  return kShare * (2.0 * t + 0.5 * kPi * t * t + 27.0 / (16.0 * kPi) * std::cos((turn + kPi) / 3.0) - 0.25 -
                   1.0 / (16.0 * kPi));
}
}  // namespace mod_sine

namespace sine_squared {
double speed(double t) {
  return t - std::sin(2.0 * kPi * t) / (2.0 * kPi);
}
double way(double t) {
  return 0.5 * t * t + (std::cos(2.0 * kPi * t) - 1.0) / (4.0 * kPi * kPi);
}
}  // namespace sine_squared

/// In the order of SpeedLaw.
const std::array<Law, 4> kLaws{{{s_curve::speed, s_curve::way, 1.5},
                                {poly5::speed, poly5::way, 1.875},
                                {mod_sine::speed, mod_sine::way, 4.0 * kPi / (4.0 + kPi)},
                                {sine_squared::speed, sine_squared::way, 2.0}}};

const Law& lawOf(SpeedLaw law) {
  return kLaws[static_cast<std::size_t>(law)];
}

}  // namespace

Ramp::Ramp(SpeedLaw law, double varying)
    : law_(law), varying_(varying), stretch_(1.0 / (1.0 - varying * (1.0 - 1.0 / lawOf(law).steepest))) {}

// Up to varying / 2 as the law's first half, up to the middle at the highest acceleration, then the same
// turned about the middle.
double Ramp::speed(double share) const {
  if (share > 0.5) return 1.0 - speed(1.0 - share);
  const Law& law = lawOf(law_);
  const double scale = stretch_ * varying_ / law.steepest;
  if (share < 0.5 * varying_) return scale * law.speed(share / varying_);
  return 0.5 - stretch_ * (0.5 - share);
}

double Ramp::way(double share) const {
  if (share > 0.5) return share - 0.5 + way(1.0 - share);
  const Law& law = lawOf(law_);
  const double scale = stretch_ * varying_ / law.steepest;
  if (share < 0.5 * varying_) return scale * varying_ * law.way(share / varying_);
  const double since = share - 0.5 * varying_;
  const double varied = varying_ > 0.0 ? scale * varying_ * law.way(0.5) : 0.0;
  return varied + since * (0.5 * scale + 0.5 * stretch_ * since);
}

}  // namespace cobot_command::motion
