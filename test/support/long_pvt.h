// A PVT of thousands of points, as a path is sent: joint 1 goes evenly to and fro.
#pragma once

#include <chrono>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>
#include <string>

#include "cobot_command/common/time.h"

namespace cobot_command::testing {

class LongPvt {
 public:
  static constexpr Duration kSegment = std::chrono::milliseconds(25);

  /// `points`: a multiple of 200, so that it ends at rest; from the start posture of the simulator on.
  explicit LongPvt(int points) : points_(points) {}

  /// Joint 1 at a point [deg], and its speed there [deg/s].
  [[nodiscard]] static double angle(int point) { return 30 * (1 - std::cos(phase(point))); }
  [[nodiscard]] static double speed(int point) {
    return 30 * std::sin(phase(point)) * kPhase / toSeconds(kSegment);
  }

  /// With tag 1 behind the point in the middle and tag 2 behind the end.
  [[nodiscard]] std::string script() const {
    std::ostringstream lines;
    lines.imbue(std::locale::classic());
    lines << std::fixed << std::setprecision(12) << "PVTEnter(0)\r\n";
    for (int i = 1; i <= points_; ++i) {
      lines << "PVTPoint(" << angle(i)
            << ",0.000000000001,90.000000000001,0.000000000001,90.000000000001,0.000000000001,"
            << (i == points_ ? 0.0 : speed(i)) << ",0.00000,0.00000,0.00000,0.00000,0.00000,0.025)\r\n";
      if (i == (points_ + 1) / 2) {
        lines << "QueueTag(1)\r\n";
      }
    }
    lines << "PVTExit()\r\nQueueTag(2)";
    return lines.str();
  }

 private:
  static constexpr double kPhase = 3.14159265358979323846 / 200;  ///< of a point
  [[nodiscard]] static double phase(int point) { return kPhase * point; }

  int points_;
};

}  // namespace cobot_command::testing
