#include "jog/jog_drives.h"

#include <algorithm>
#include <utility>

#include "cobot_command/common/deadline.h"

namespace cobot_command::blocks {
namespace {

/// The controller's own watch over velocities of the TCP sees one as often.
constexpr Duration kRenewEvery = std::chrono::milliseconds(100);
/// The place that a frame tells is of so long ago, and a command comes so much later.
constexpr Duration kLate = std::chrono::milliseconds(40);
/// Of an arm that should stand by now.
constexpr Duration kRestPatience = std::chrono::milliseconds(150);
/// So much of short moves the controller has at most.
constexpr Duration kAhead = std::chrono::milliseconds(200);
/// A drive that is as good as none [s].
constexpr double kNoDrive = 1e-6;

class VelocityDrive final : public JogDrive {
 public:
  explicit VelocityDrive(std::shared_ptr<const JogPlan> plan) : plan_(std::move(plan)) {}

  [[nodiscard]] JogMeans means() const override { return JogMeans::Velocity; }
  [[nodiscard]] Duration patience() const override {
    return kJogStandsWithin - kJogReserve - plan_->stop_time;
  }
  void look(Instant now, Instant /*kept*/) override { renews_ = renew_at_ && now >= *renew_at_; }

  [[nodiscard]] std::optional<JogOrder> next(JogWish wish) const override {
    if (sent_ == Sent::Left) return std::nullopt;
    if (sent_ == Sent::Nothing) {
      if (wish != JogWish::Drive) return std::nullopt;
      return JogOrder{plan_->enterVelocity(), true};
    }
    if (wish == JogWish::Leave) return JogOrder{JogPlan::leaveVelocity()};
    if (wish == JogWish::Rest && sent_ == Sent::Velocity) return JogOrder{plan_->setVelocity(true)};
    const bool drives_anew = has_room_ && (sent_ == Sent::Rest || renews_);
    if (wish == JogWish::Drive && drives_anew) return JogOrder{plan_->setVelocity(false)};
    return std::nullopt;
  }
  void started(JogWish wish) override {
    sent_ = wish == JogWish::Drive ? Sent::Velocity : wish == JogWish::Rest ? Sent::Rest : Sent::Left;
    renews_ = false;
    renew_at_.reset();
  }
  void sent(Instant now) override {
    if (sent_ == Sent::Velocity && !plan_->of_joints) renew_at_ = now + kRenewEvery;
  }

  void see(double drive, Instant now) override {
    const double override = plan_->setting.speed_override;
    const double left = (plan_->reach - drive) / override;
    brake_at_ = now + fromSeconds(left) - kLate - plan_->stop_time / 2;
    has_room_ = hasRoomForVelocity(*plan_, drive);
  }
  [[nodiscard]] bool isAtEnd(Instant now) const override {
    return (brake_at_ && now >= *brake_at_) || (sent_ == Sent::Rest && !has_room_);
  }
  [[nodiscard]] std::optional<Duration> timeToRest() const override {
    return plan_->stop_time + kRestPatience;
  }
  [[nodiscard]] std::optional<Instant> nextDeadline(JogWish wish) const override {
    // What is due already is not told of again: its plan may be under way.
    return wish == JogWish::Drive ? earlier(renews_ ? std::nullopt : renew_at_, brake_at_) : std::nullopt;
  }

 private:
  enum class Sent { Nothing, Velocity, Rest, Left };

  std::shared_ptr<const JogPlan> plan_;
  Sent sent_ = Sent::Nothing;
  bool has_room_ = true;
  bool renews_ = false;
  std::optional<Instant> renew_at_;
  std::optional<Instant> brake_at_;
};

class MovesDrive final : public JogDrive {
 public:
  explicit MovesDrive(std::shared_ptr<const JogPlan> plan)
      : plan_(std::move(plan)), left_(plan_->step.value_or(plan_->reach)) {}

  [[nodiscard]] JogMeans means() const override { return JogMeans::Moves; }
  /// The last moment from which one more move would end in time.
  [[nodiscard]] Duration patience() const override { return kMovesWithin - kJogPiece - kJogRamp; }

  void look(Instant now, Instant kept) override {
    const Instant rests_at = restBehindOneMore(now);
    const bool is_in_time = rests_at <= std::min(kept + kMovesWithin, now + kAhead);
    may_go_on_ = left_ > kNoDrive && (plan_->step || is_in_time);
    due_ = rests_at <= kept + kMovesWithin && !may_go_on_ ? std::optional(rests_at - kAhead) : std::nullopt;
  }
  [[nodiscard]] std::optional<JogOrder> next(JogWish wish) const override {
    if (wish != JogWish::Drive || !may_go_on_) return std::nullopt;
    return JogOrder{plan_->move(piece(), !plan_->step), true};
  }
  void started(JogWish /*wish*/) override {
    left_ -= piece();
    may_go_on_ = false;
    due_.reset();
  }
  void sent(Instant now) override { rests_at_ = restBehindOneMore(now); }

  void see(double /*drive*/, Instant /*now*/) override {}
  [[nodiscard]] bool isAtEnd(Instant /*now*/) const override { return left_ <= kNoDrive; }
  [[nodiscard]] std::optional<Duration> timeToRest() const override { return std::nullopt; }
  [[nodiscard]] std::optional<Instant> nextDeadline(JogWish wish) const override {
    return wish == JogWish::Drive ? due_ : std::nullopt;
  }

 private:
  static constexpr Duration kMovesWithin = kJogStandsWithin - kJogReserve;

  /// A lower project speed makes it shorter, and its time the same.
  [[nodiscard]] double piece() const {
    return plan_->step ? left_ : std::min(left_, toSeconds(kJogPiece) * plan_->setting.speed_override);
  }
  /// One that comes before the last one slows down takes over at its speed; else from rest.
  [[nodiscard]] Instant restBehindOneMore(Instant now) const {
    if (rests_at_ && now + kJogReserve / 2 <= *rests_at_ - kJogRamp) return *rests_at_ + kJogPiece;
    return std::max(now, rests_at_.value_or(now)) + kJogPiece + kJogRamp;
  }

  std::shared_ptr<const JogPlan> plan_;
  double left_;  ///< of the drive
  bool may_go_on_ = false;
  std::optional<Instant> rests_at_;  ///< behind all that was sent
  std::optional<Instant> due_;
};

}  // namespace

bool hasRoomForVelocity(const JogPlan& plan, double driven) {
  const double needed = 1.5 * toSeconds(plan.stop_time) + toSeconds(kLate + kJogReserve);
  return (plan.reach - driven) / plan.setting.speed_override > needed;
}

std::unique_ptr<JogDrive> velocityDrive(std::shared_ptr<const JogPlan> plan) {
  return std::make_unique<VelocityDrive>(std::move(plan));
}

std::unique_ptr<JogDrive> movesDrive(std::shared_ptr<const JogPlan> plan) {
  return std::make_unique<MovesDrive>(std::move(plan));
}

}  // namespace cobot_command::blocks
