// The script commands of the Listen node (thesis 4.3, I848-E-03 chapter 8) as types, and their text. What is
// known of each as a function of the robot stands in its row, src/script/*_functions.cpp.
//
// Units are the controller's own: mm, degrees, ms, %, mm/s, kg, kg mm^2. Numbers are written to the nearest
// millionth (a nanometre: a thousand times finer than what the arm can hold, and finer than the controller's
// 32-bit floats), without trailing zeros and exponent, whatever the locale;
// beyond nine billion as whole numbers.
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

/// Six numbers: X Y Z [mm] RX RY RZ [deg], or J1..J6 [deg], as the data format says.
using SixNumbers = std::array<double, 6>;

/// The three letters in front of a motion, e.g. "CPP".
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

/// How a motion is made; the same for all motion commands.
struct MotionOptions {
  int speed = 0;       ///< % or mm/s, as the format says
  int accel_time = 0;  ///< time to top speed [ms]
  int blending = 0;    ///< % or mm, as the format says; 0: none
  /// The controller's own sense: true switches precise positioning OFF (4.3.1).
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
struct PLine {  ///< JAP, CAP; nothing is said about precise positioning
  DataFormat format;
  SixNumbers target{};
  MotionOptions options;
};
struct MovePLine {  ///< CAP, TAP, JAP; nothing is said about precise positioning
  DataFormat format;
  SixNumbers offset{};
  MotionOptions options;
};
/// A trajectory of points: PVTEnter, its points and what is queued at them, PVTExit.
struct PvtEnter {
  bool cartesian = false;  ///< the points are poses of the TCP, not joints
};
struct PvtPoint {
  SixNumbers position{};
  SixNumbers velocity{};  ///< deg/s; or mm/s and deg/s
  double duration = 0;    ///< from the point before [s]
};
struct PvtExit {};
struct PvtPause {};
struct PvtResume {};
/// Continuous velocities, which need a licence (TM 2.2).
struct ContinueVJog {};
struct ContinueVLine {
  int zero_timeout = 0;  ///< without a new velocity the arm comes to rest [ms]
  int stop_timeout = 0;  ///< and the mode ends [ms]
};
struct SetContinueVJog {
  SixNumbers velocity{};  ///< of the joints [deg/s]
};
struct SetContinueVLine {
  SixNumbers velocity{};  ///< of the TCP [mm/s, deg/s]
};
struct StopContinueVmode {};
struct SuspendContinueVmode {};
/// What every project has: the robot base as a base, the flange as a TCP.
inline constexpr const char* kRobotBase = "RobotBase";
inline constexpr const char* kNoTool = "NOTOOL";

struct ChangeBase {
  std::variant<SixNumbers, std::string> base;  ///< value, or the name of a base in the project ("RobotBase")
};
struct ToolInertia {
  std::array<double, 3> moment{};  ///< Ixx, Iyy, Izz [kg mm^2]
  SixNumbers mass_center{};        ///< frame of the mass centre in the tool (the TCP's frame)
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
  std::optional<int> timeout;  ///< [ms]; absent or <= 0: for ever
};
struct StopAndClearBuffer {
  std::optional<int> mode;  ///< 0..2, TMflow 1.82 and later
};
struct Pause {};
struct Resume {};
struct ScriptExit {
  std::optional<int> mode;  ///< 0, 1, TMflow 1.82 and later
};

/// Where digital inputs and outputs are.
enum class IoModule { ControlBox, EndModule };
/// As it stands in scripts: "ControlBox".
[[nodiscard]] std::string_view toString(IoModule module);
[[nodiscard]] std::optional<IoModule> ioModule(std::string_view name);
/// How many digital outputs a module has, and as many inputs (TM 2.4).
[[nodiscard]] constexpr int ioCount(IoModule module) {
  return module == IoModule::ControlBox ? 16 : 4;
}
/// A digital output: IO["EndModule"].DO[0]=1 is queued behind the motions before it, InstantDO acts at once.
struct WriteOutput {
  IoModule module = IoModule::ControlBox;
  int index = 0;  ///< 0 .. ioCount(module) - 1
  bool on = false;
  bool instant = false;
};

/// What an analog output can give, either way [V].
inline constexpr double kMostVolt = 10;
/// The analog output of the control box, which has one (TM 2.4).
struct WriteAnalogOutput {
  double volt = 0;  ///< -kMostVolt .. kMostVolt
  bool instant = false;
};

using ScriptCommand =
    std::variant<Ptp, Line, Circle, MovePtp, MoveLine, ChangeBase, ChangeTcp, ChangeLoad, QueueTag,
                 WaitQueueTag, StopAndClearBuffer, Pause, Resume, ScriptExit, WriteOutput, WriteAnalogOutput,
                 PLine, MovePLine, PvtEnter, PvtPoint, PvtExit, PvtPause, PvtResume, ContinueVJog,
                 ContinueVLine, SetContinueVJog, SetContinueVLine, StopContinueVmode, SuspendContinueVmode>;

/// What can stand as the name of a base or TCP, isProjectName().
[[nodiscard]] bool isName(std::string_view name);
inline constexpr std::size_t kMaxNameLength = kLongestProjectName;

/// What can be sent as one line of script: UTF-8 without control characters other than tabs.
[[nodiscard]] bool isScriptLine(std::string_view line);

/// One line of script. Preconditions: all numbers are finite, names are isName(), the format is one that the
/// command takes, the module has the output, and optional parts stand only where the comments above allow
/// them.
[[nodiscard]] std::string toText(const ScriptCommand& command);
[[nodiscard]] std::string toText(const WriteOutput& write);
[[nodiscard]] std::string toText(const WriteAnalogOutput& write);
/// Lines joined by CR LF, without one at the end.
[[nodiscard]] std::string toText(const std::vector<ScriptCommand>& script);

}  // namespace cobot_command::script
