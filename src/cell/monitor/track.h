// What is known of one thing that moves: where it was measured, when, and how fast.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "monitor/body_set.h"
#include <Eigen/Core>

#include "cobot_command/arm/types.h"
#include "cobot_command/common/time.h"

namespace cobot_command::cell::monitor {

class Track {
 public:
  enum class Taken { Yes, Malformed, Old };
  /// Of each axis; those of a robot are its joints. No memory is allocated for them.
  using Axes =
      Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, static_cast<int>(arm::kJointCount), 1>;

  /// By axis, how fast it can be at most; of those behind the end nobody knows.
  explicit Track(std::vector<double> most_speeds) : most_speeds_(std::move(most_speeds)) {}
  virtual ~Track() = default;
  Track(const Track&) = delete;
  Track& operator=(const Track&) = delete;

  /// Lets the bodies grow by what they may have moved since they were measured, at the speeds of then; of an
  /// axis for which there is one, at no more than that.
  void grow(Duration age, const std::vector<double>& most_speeds = {});

  [[nodiscard]] bool heard() const { return measured_.has_value(); }
  [[nodiscard]] Instant measured() const { return *measured_; }
  /// How old what is known is; never negative.
  [[nodiscard]] Duration age(Instant now) const;
  /// Whether an axis is faster than that [rad/s, or m/s of one that slides], by what is known of it, however
  /// old.
  [[nodiscard]] bool moves(double standing_speed) const;
  [[nodiscard]] const BodySet& set() const { return set_; }
  [[nodiscard]] virtual const std::string& bodyName(std::size_t body) const = 0;

 protected:
  /// Where the axes are, `age` before `now`; how fast is the greater one of what is told and of what they did
  /// since data that is older by more than some noise, and by no more than `most`, as far as they can: two
  /// that come at once after a pause look as if they had been measured at once. Precondition: the numbers are
  /// such as the thing can have.
  [[nodiscard]] Taken note(const Axes& values, const std::optional<Axes>& speeds, Duration age, Instant now,
                           Duration most);
  [[nodiscard]] const Axes& values() const { return values_; }
  /// With which the bodies grow; none is negative.
  [[nodiscard]] double speed(std::size_t axis) const { return growing_[static_cast<Eigen::Index>(axis)]; }
  [[nodiscard]] BodySet& bodies() { return set_; }

 private:
  /// Puts the bodies where the values say.
  virtual void place() = 0;
  /// How far no point of the body has moved, at the speeds of now [m].
  [[nodiscard]] virtual double displacement(std::size_t body, double seconds) const = 0;
  void derive(const Axes& values, Instant measured, Duration most);

  std::vector<double> most_speeds_;
  std::optional<Instant> measured_;
  Axes values_;
  Axes speeds_;
  Axes growing_;  ///< those, as far as they count
  bool speeds_known_ = false;
  Axes derived_;
  bool derived_known_ = false;
  /// What speeds are derived from.
  struct Reference {
    Instant measured;
    Axes values;
  };
  std::optional<Reference> reference_;
  BodySet set_;
};

}  // namespace cobot_command::cell::monitor
