#include "runs/evidence.h"

#include <fmt/format.h>

namespace cobot_command::command {

std::optional<robot::Gap> Evidence::gap() const {
  const auto& status = robot_.status();
  if (!status || !target_) return std::nullopt;
  return robot::gapTo(*target_, *status, arm_, {settings_.position_tolerance, settings_.angle_tolerance});
}

bool Evidence::stalledOnTheWay() const {
  if (!stalled()) return false;
  const auto to_go = gap();
  return !to_go || !to_go->closed;
}

std::string Evidence::stallText(int tag) const {
  const auto to_go = gap();
  return fmt::format(
      "the robot is at standstill{}, no pause and no safeguard stops it, and the controller no longer knows "
      "tag {}: another client or the project has stopped the robot",
      to_go ? ", " + to_go->text : "", tag);
}

bool Evidence::confirms() {
  if (!robot_.tellsMotion()) return true;  // the tag is all that is known
  const auto to_go = gap();
  if (to_go && !to_go->closed) return false;
  if (robot_.moving() == false) {
    reached_.reset();
    return true;
  }
  if (to_go && !target_->is_the_start && !reached_) reached_ = robot_.place();
  return false;
}

std::string Evidence::whyUnseen() const {
  if (reached_) return "";
  if (!robot_.tellsMotion()) {
    return "only its queue tag reports that it is done, because " + robot_.whyNoJoints();
  }
  const bool shows_no_place = target_ && !gap();
  return shows_no_place
             ? "the robot is at standstill, but its position is not known, because " + robot_.whyNoJoints()
             : "";
}

/// It was at its target, and moves on at once: that is another client's motion, and none of this goal's
/// business.
Evidence::Verdict Evidence::verdict() const {
  if (reached_) return Verdict::Confirmed;
  const auto to_go = gap();
  const bool away = to_go && !to_go->closed;
  return !away && !robot_.moving() ? Verdict::Open : Verdict::Contradicted;
}

std::string Evidence::contradiction(int tag) const {
  const auto to_go = gap();
  return fmt::format("tag {} was reported complete, but {}", tag,
                     to_go && !to_go->closed ? to_go->text : "the robot still moves");
}

}  // namespace cobot_command::command
