#include "dynamics/speed_desk.h"

#include <fmt/format.h>

#include "cobot_command/common/units.h"

namespace cobot_command::command {
namespace {

using Holder = PauseDesk::Holder;

}  // namespace

void SpeedDesk::set(double percent, const OverrideReply& reply, Instant now) {
  if (!(percent >= 0 && percent <= kPercent)) {
    OverrideAnswer refusal;
    refusal.error_id = kSpeedOverrideRange;
    refusal.message = fmt::format(
        "the speed override is {} %, allowed: 0 to {}: choose one in this range; {:.6g} % remains in effect",
        percent, kPercent, core_.speed.percent());
    refusal.effective = effective();
    reply(refusal);
    return;
  }
  const double share = core_.speed.share();
  core_.speed.set(percent + 0.0);  // no "-0 %"
  if (core_.speed.share() != share) core_.speeds_changed();
  if (core_.speed.isZero()) {
    hold(reply, now);
  } else {
    letGo(reply, now);
  }
}

/// A robot that stands needs no pause: nothing is sent to it.
void SpeedDesk::hold(const OverrideReply& reply, Instant now) {
  if (!core_.pause.isHeldBy(Holder::Override) && !core_.may_move()) {
    answerWith(reply, {true, 0, ""}, "no motion is running, and nothing is sent until it is above 0");
    return;
  }
  const auto done = [this, reply](const PauseDesk::Answer& answer) {
    answerWith(reply, answer, "the robot is paused, and nothing is sent until it is above 0");
  };
  core_.pause.hold(Holder::Override, done, now);
}

void SpeedDesk::letGo(const OverrideReply& reply, Instant now) {
  if (!core_.pause.isHeldBy(Holder::Override)) {
    answerWith(reply, {true, 0, core_.pause.heldByOthers()}, textOfNow());
    return;
  }
  const auto done = [this, reply](const PauseDesk::Answer& answer) {
    // What the stream shows of the pause is of before the Resume() that has just been taken.
    const bool goes_on = answer.done && answer.message.empty() && !isSafeguarded();
    answerWith(reply, answer, textOfNow(), goes_on ? speedOfNow() : effective());
  };
  core_.pause.letGo(Holder::Override, done, now);
}

bool SpeedDesk::isSafeguarded() const {
  return core_.robot.status() && core_.robot.status()->safeguard.value_or(false);
}

std::string SpeedDesk::textOfNow() const {
  const auto share = core_.window.speedShare();
  if (!share && !core_.may_move()) return "it applies from the next motion on";
  return "motions at the controller keep their speed; it applies from the next motion on";
}

void SpeedDesk::answerWith(const OverrideReply& reply, const PauseDesk::Answer& answer,
                           const std::string& text) const {
  answerWith(reply, answer, text, effective());
}

void SpeedDesk::answerWith(const OverrideReply& reply, const PauseDesk::Answer& answer,
                           const std::string& text, double effective) const {
  OverrideAnswer given;
  given.success = answer.done;
  given.error_id = answer.error_id;
  given.message = answer.message.empty() ? text : answer.message;
  if (answer.done && !answer.message.empty()) given.message = text + "; " + answer.message;
  given.effective = effective;
  reply(given);
}

double SpeedDesk::effective() const {
  const bool is_held = core_.robot.held() || core_.pause.stands();
  return is_held ? 0 : speedOfNow();
}

double SpeedDesk::speedOfNow() const {
  const auto moving = core_.window.speedShare();
  if (core_.speed.isZero() && !moving) return 0;
  const double project = kPercent * core_.robot.speedOverride();
  if (!moving) return project * core_.speed.share();
  return project * core_.turn.pace().running.value_or(*moving);
}

}  // namespace cobot_command::command
