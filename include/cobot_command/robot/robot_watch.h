// What is known of the robot at this moment: the last frame of the status stream, while the stream delivers.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>

#include "cobot_command/link/robot_status.h"
#include "cobot_command/robot/burden.h"
#include "cobot_command/robot/speed_trend.h"
#include "cobot_command/robot/standstill.h"

namespace cobot_command::robot {

/// "error 0x14058: ..." as far as it is known.
[[nodiscard]] std::string errorText(const link::RobotStatus& status);

/// Where one frame has shown the robot; nothing of what it did not have.
struct StreamedPlace {
  std::optional<std::array<double, 6>> joints_deg;
  std::optional<std::array<double, 6>> tool_in_base_mm_deg;  ///< the active TCP in the active base
};

class RobotWatch {
 public:
  void update(const link::RobotStatus& status);
  /// The stream stopped: nothing is known any more.
  void forget();

  [[nodiscard]] const std::optional<link::RobotStatus>& status() const { return status_; }

  /// Nothing when it cannot be told, or not yet.
  [[nodiscard]] std::optional<bool> moving() const { return standstill_.moving(); }
  /// Nothing when it is not streamed, or not yet.
  [[nodiscard]] std::optional<Trend> trend() const { return trend_.trend(); }
  /// There is a stream of which it can be told, if need be after some frames.
  [[nodiscard]] bool tellsMotion() const { return status_ && (status_->joint_velocities || status_->joints); }
  /// Or not any more: it is held, though a stream without that says nothing of it.
  void pausedByUs(bool paused) { paused_by_us_ = paused; }
  /// The project is paused, or a safeguard holds the robot: motions take as long as that lasts.
  [[nodiscard]] bool held() const;
  /// With it the script port is closed.
  [[nodiscard]] bool projectStopped() const { return status_ && status_->project_running == false; }
  [[nodiscard]] bool paused() const { return status_ && status_->project_paused.value_or(false); }
  [[nodiscard]] bool tellsPause() const { return status_ && status_->project_paused; }
  /// The stream says whether it is in automatic mode, in an error, and stopped in an emergency.
  [[nodiscard]] bool tellsTrouble() const {
    return status_ && status_->operating_mode && status_->error && status_->emergency_stop;
  }
  [[nodiscard]] bool emergencyStop() const { return status_ && status_->emergency_stop.value_or(false); }
  /// Nobody but who holds the pendant may move the robot.
  [[nodiscard]] bool manualMode() const { return status_ && status_->operating_mode == kManual; }
  /// The controller is in an error that nobody has acknowledged.
  [[nodiscard]] bool inError() const { return showsError() && !error_acknowledged_; }
  [[nodiscard]] bool showsError() const { return status_ && status_->error.value_or(false); }
  /// Somebody answers for the error that is shown: it counts no more, until it is gone or is another one.
  void acknowledgeError() { error_acknowledged_ = showsError(); }
  void takeBackAcknowledgement() { error_acknowledged_ = false; }
  /// The same, and what it carries if that is too much.
  [[nodiscard]] std::string errorText() const;
  /// Nothing: what the arm carries is not too much for it, as far as is known.
  void carries(std::optional<TooMuch> too_much) { too_much_ = std::move(too_much); }
  [[nodiscard]] const std::optional<TooMuch>& tooMuch() const { return too_much_; }

  [[nodiscard]] std::optional<arm::JointVector> joints() const;
  /// For people; empty: joints() are known.
  [[nodiscard]] std::string whyNoJoints() const;
  /// The active TCP in the flange, also from the poses of flange and tool; nothing when neither is told.
  [[nodiscard]] std::optional<arm::Pose> tcp() const;
  [[nodiscard]] double speedOverride() const;

  [[nodiscard]] std::optional<std::array<double, 6>> jointsDeg() const;
  [[nodiscard]] std::optional<std::array<double, 6>> toolInBaseMmDeg() const;
  [[nodiscard]] StreamedPlace place() const { return {jointsDeg(), toolInBaseMmDeg()}; }

 private:
  static constexpr int kManual = 2;  // of MA_Mode

  std::optional<link::RobotStatus> status_;
  Standstill standstill_;
  SpeedTrend trend_;
  bool error_acknowledged_ = false;
  bool paused_by_us_ = false;
  std::optional<TooMuch> too_much_;
};

}  // namespace cobot_command::robot
