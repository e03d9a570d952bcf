// The script commands of the Listen node (thesis 4.3, I848-E-03 chapter 8) as types, and their text.
// src/script/*_functions.cpp describes each command as a function of the robot.
//
// Units are the controller's: mm, degrees, ms, %, mm/s, kg, kg mm^2. Numbers are rounded to the nearest
// millionth (a nanometre: a thousand times finer than the arm's accuracy, and finer than the controller's
// 32-bit floats). They are written without trailing zeros and exponent in every locale; beyond nine billion
// as whole numbers.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "cobot_command/common/project_name.h"

namespace cobot_command::script {

/// Six numbers: X Y Z [mm] RX RY RZ [deg], or J1..J6 [deg], according to the data format.
using SixNumbers = std::array<double, 6>;

/// The three letters before a motion, e.g. "CPP".
struct DataFormat {
  enum class Target : char { Joint = 'J', Cartesian = 'C', Tool = 'T' };
  enum class Speed : char { Percent = 'P', Absolute = 'A' };   ///< % or mm/s
  enum class Blending : char { Percent = 'P', Radius = 'R' };  ///< % or mm
  Target target = Target::Cartesian;
  Speed speed = Speed::Percent;
  Blending blending = Blending::Percent;

  [[nodiscard]] std::string text() const;
  friend bool operator==(const DataFormat& a, const DataFormat& b) {
    return a.target == b.target && a.speed == b.speed && a.blending == b.blending;
  }
};

/// Options that all motion commands share.
struct MotionOptions {
  int speed = 0;       ///< % or mm/s, according to the format
  int accel_time = 0;  ///< time to top speed [ms]
  int blending = 0;    ///< % or mm, according to the format; 0: none
  /// As on the controller: true switches precise positioning OFF (4.3.1).
  bool disable_precise_positioning = false;
};

struct Ptp {  ///< JPP, CPP
  DataFormat format;
  SixNumbers target{};
  MotionOptions options;
  std::optional<std::array<int, 3>> pose_bits;  ///< Config1..3, only with CPP
};
struct Line {  ///< CPP, CPR, CAP, CAR
  DataFormat format;
  SixNumbers target{};
  MotionOptions options;
};
struct Circle {  ///< CPP, CAP
  DataFormat format;
  SixNumbers via{};
  SixNumbers end{};
  MotionOptions options;
  int arc_angle = 0;  ///< [deg]; 0: to the end point
};
struct MovePtp {  ///< CPP, TPP, JPP
  DataFormat format;
  SixNumbers offset{};
  MotionOptions options;
};
struct MoveLine {  ///< CPP, CPR, CAP, CAR, TPP, TPR, TAP, TAR
  DataFormat format;
  SixNumbers offset{};
  MotionOptions options;
};
struct PLine {  ///< JAP, CAP; precise positioning is not documented
  DataFormat format;
  SixNumbers target{};
  MotionOptions options;
};
struct MovePLine {  ///< CAP, TAP, JAP; precise positioning is not documented
  DataFormat format;
  SixNumbers offset{};
  MotionOptions options;
};
/// A trajectory of points: PVTEnter, the points and the commands queued at them, PVTExit.
struct PvtEnter {
  bool cartesian = false;  ///< the points are poses of the TCP, not joints
};
struct PvtPoint {
  SixNumbers position{};
  SixNumbers velocity{};  ///< deg/s; or mm/s and deg/s
  double duration = 0;    ///< since the previous point [s]
};
struct PvtExit {};
struct PvtPause {};
struct PvtResume {};
/// Continuous velocities, which need a licence (TM 2.2).
struct ContinueVJog {};
struct ContinueVLine {
  int zero_timeout = 0;  ///< without a new velocity in this time the arm stops [ms]
  int stop_timeout = 0;  ///< without a new velocity in this time the mode ends [ms]
};
struct SetContinueVJog {
  SixNumbers velocity{};  ///< of the joints [deg/s]
};
struct SetContinueVLine {
  SixNumbers velocity{};  ///< of the TCP [mm/s, deg/s]
};
struct StopContinueVmode {};
struct SuspendContinueVmode {};
/// Names in every project: the robot base as a base, the flange as a TCP.
inline constexpr const char* kRobotBase = "RobotBase";
inline constexpr const char* kNoTool = "NOTOOL";

struct ChangeBase {
  std::variant<SixNumbers, std::string> base;  ///< value, or the name of a base in the project ("RobotBase")
};
struct ToolInertia {
  std::array<double, 3> moment{};  ///< Ixx, Iyy, Izz [kg mm^2]
  SixNumbers mass_center{};        ///< frame of the centre of mass in the TCP frame
};
struct ChangeTcp {
  std::variant<SixNumbers, std::string> tcp;  ///< value, or the name of a TCP in the project ("NOTOOL")
  std::optional<double> weight;               ///< [kg]; only with a value
  std::optional<ToolInertia> inertia;         ///< only with a weight
};
struct ChangeLoad {
  double weight = 0;  ///< [kg]
};
struct QueueTag {
  int tag = 1;  ///< 1..15
  bool wait = false;
};
struct WaitQueueTag {
  int tag = 1;
  std::optional<int> timeout;  ///< [ms]; absent or <= 0: no timeout
};
struct StopAndClearBuffer {
  std::optional<int> mode;  ///< 0..2, TMflow 1.82 and later
};
struct Pause {};
struct Resume {};
struct ScriptExit {
  std::optional<int> mode;  ///< 0, 1, TMflow 1.82 and later
};

/// The modules with digital inputs and outputs.
enum class IoModule { ControlBox, EndModule };
/// Its name in scripts: "ControlBox".
[[nodiscard]] std::string_view toString(IoModule module);
[[nodiscard]] std::optional<IoModule> ioModule(std::string_view name);
/// The number of digital outputs of a module; it has as many inputs (TM 2.4).
[[nodiscard]] constexpr int ioCount(IoModule module) {
  return module == IoModule::ControlBox ? 16 : 4;
}
/// A digital output. IO["EndModule"].DO[0]=1 is queued after the motions before it; InstantDO takes effect
/// immediately.
struct WriteOutput {
  IoModule module = IoModule::ControlBox;
  int index = 0;  ///< 0 .. ioCount(module) - 1
  bool on = false;
  bool instant = false;
};

/// Largest voltage of an analog output, positive or negative [V].
inline constexpr double kMostVolt = 10;
/// The only analog output of the control box (TM 2.4).
struct WriteAnalogOutput {
  double volt = 0;  ///< -kMostVolt .. kMostVolt
  bool instant = false;
};

using ScriptCommand =
    std::variant<Ptp, Line, Circle, MovePtp, MoveLine, ChangeBase, ChangeTcp, ChangeLoad, QueueTag,
                 WaitQueueTag, StopAndClearBuffer, Pause, Resume, ScriptExit, WriteOutput, WriteAnalogOutput,
                 PLine, MovePLine, PvtEnter, PvtPoint, PvtExit, PvtPause, PvtResume, ContinueVJog,
                 ContinueVLine, SetContinueVJog, SetContinueVLine, StopContinueVmode, SuspendContinueVmode>;

/// A valid name of a base or TCP, isProjectName().
[[nodiscard]] bool isName(std::string_view name);
inline constexpr std::size_t kMaxNameLength = kLongestProjectName;

/// A valid script line: UTF-8 without control characters other than tabs.
[[nodiscard]] bool isScriptLine(std::string_view line);

/// One line of script. Preconditions: all numbers are finite, names satisfy isName(), the command accepts the
/// format, the module has the output, and optional parts are only present where the comments above allow
/// them.
[[nodiscard]] std::string toText(const ScriptCommand& command);
[[nodiscard]] std::string toText(const WriteOutput& write);
[[nodiscard]] std::string toText(const WriteAnalogOutput& write);
/// Lines joined by CR LF, without one at the end.
[[nodiscard]] std::string toText(const std::vector<ScriptCommand>& script);

}  // namespace cobot_command::script
