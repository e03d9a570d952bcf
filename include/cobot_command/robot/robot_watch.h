// The present knowledge about the robot: the last frame of the status stream, while the stream delivers.
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

/// "error 0x14058: ...", as far as it is known.
[[nodiscard]] std::string errorText(const link::RobotStatus& status);

/// The position of the robot in one frame; nullopt: the frame did not have it.
struct StreamedPlace {
  std::optional<std::array<double, 6>> joints_deg;
  std::optional<std::array<double, 6>> tool_in_base_mm_deg;  ///< the active TCP in the active base
};

class RobotWatch {
 public:
  void update(const link::RobotStatus& status);
  /// The stream stopped: the state is unknown.
  void forget();

  [[nodiscard]] const std::optional<link::RobotStatus>& status() const { return status_; }

  /// nullopt: not known, or not known yet.
  [[nodiscard]] std::optional<bool> moving() const { return standstill_.moving(); }
  /// nullopt: not streamed, or not for long enough.
  [[nodiscard]] std::optional<Trend> trend() const { return trend_.trend(); }
  /// True: the stream shows whether the robot moves, if necessary after some frames.
  [[nodiscard]] bool tellsMotion() const { return status_ && (status_->joint_velocities || status_->joints); }
  /// True: this layer has paused the robot; false: no longer. Needed if the stream does not show the pause.
  void pausedByUs(bool paused) { paused_by_us_ = paused; }
  /// The project is paused, or a safeguard pauses the robot: motions wait as long as that lasts.
  [[nodiscard]] bool held() const;
  /// The script port is closed too.
  [[nodiscard]] bool projectStopped() const { return status_ && status_->project_running == false; }
  [[nodiscard]] bool paused() const { return status_ && status_->project_paused.value_or(false); }
  [[nodiscard]] bool tellsPause() const { return status_ && status_->project_paused; }
  /// True: the stream shows the operating mode, errors and the emergency stop.
  [[nodiscard]] bool tellsTrouble() const {
    return status_ && status_->operating_mode && status_->error && status_->emergency_stop;
  }
  [[nodiscard]] bool emergencyStop() const { return status_ && status_->emergency_stop.value_or(false); }
  /// Only the operator with the pendant may move the robot.
  [[nodiscard]] bool manualMode() const { return status_ && status_->operating_mode == kManual; }
  /// The controller is in an error that was not acknowledged.
  [[nodiscard]] bool inError() const { return showsError() && !error_acknowledged_; }
  [[nodiscard]] bool showsError() const { return status_ && status_->error.value_or(false); }
  /// The displayed error is acknowledged: it no longer counts, until it is gone or replaced by another one.
  void acknowledgeError() { error_acknowledged_ = showsError(); }
  void takeBackAcknowledgement() { error_acknowledged_ = false; }
  /// The same for the present status, with the payload if it is too heavy.
  [[nodiscard]] std::string errorText() const;
  /// nullopt: as far as is known, the payload is not too heavy for the arm.
  void carries(std::optional<TooMuch> too_much) { too_much_ = std::move(too_much); }
  [[nodiscard]] const std::optional<TooMuch>& tooMuch() const { return too_much_; }

  [[nodiscard]] std::optional<arm::JointVector> joints() const;
  /// Why joints() is nullopt, for people; empty: joints() is known.
  [[nodiscard]] std::string whyNoJoints() const;
  /// The active TCP in the flange, also from the poses of flange and tool; nullopt: the stream has neither.
  [[nodiscard]] std::optional<arm::Pose> tcp() const;
  [[nodiscard]] double speedOverride() const;

  [[nodiscard]] std::optional<std::array<double, 6>> jointsDeg() const;
  [[nodiscard]] std::optional<std::array<double, 6>> toolInBaseMmDeg() const;
  [[nodiscard]] StreamedPlace place() const { return {jointsDeg(), toolInBaseMmDeg()}; }

 private:
  static constexpr int kManual = 2;  // value of MA_Mode

  std::optional<link::RobotStatus> status_;
  Standstill standstill_;
  SpeedTrend trend_;
  bool error_acknowledged_ = false;
  bool paused_by_us_ = false;
  std::optional<TooMuch> too_much_;
};

}  // namespace cobot_command::robot
