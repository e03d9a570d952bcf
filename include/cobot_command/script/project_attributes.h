// Attributes of TCPs and bases in the controller's project, and the script lines that read and write them:
// poses of TCPs and bases, mass properties of TCPs (TM 2.4). src/script/project_attributes.cpp has one row
// per attribute.
//
// A read is ListenSend() of the attribute: the controller sends it as floats (protocol/float_payload.h) on
// the channel of its row. A write is an assignment. It lasts until the project run ends, and takes effect at
// the next ChangeTCP() or ChangeBase(). Units are the controller's: mm, degrees, kg, kg mm^2.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "cobot_command/tm_script/functions.h"

namespace cobot_command::script {

enum class ProjectAttribute {
  TcpValue,       ///< X Y Z [mm] RX RY RZ [deg] in the flange
  TcpMass,        ///< [kg]
  TcpMoment,      ///< Ixx, Iyy, Izz [kg mm^2]
  TcpMassCenter,  ///< frame of the centre of mass in the TCP frame, as TcpValue
  BaseValue       ///< X Y Z [mm] RX RY RZ [deg] in the robot base
};

/// First version whose scripts can read and write them. An older controller answers the ListenSend() with
/// ERROR.
inline constexpr tm_script::Version kAttributesSince{1, 76};

/// The number of values: six, one, three, six, six.
[[nodiscard]] std::size_t numbersOf(ProjectAttribute attribute);
/// The channel of its ListenSend(): 90 for values, 91 Mass, 92 MOI, 93 MCF.
[[nodiscard]] int channelOf(ProjectAttribute attribute);
[[nodiscard]] bool isAttributeChannel(int channel);

/// A valid key of an attribute: isName() without two single quotes. The controller replaces a variable
/// between single quotes (I848-E-03 1.2), so the key would name another TCP.
[[nodiscard]] bool isAttributeKey(std::string_view name);

struct AttributeRead {
  ProjectAttribute attribute = ProjectAttribute::TcpValue;
  std::string name;  ///< isAttributeKey()

  friend bool operator==(const AttributeRead& a, const AttributeRead& b) {
    return a.attribute == b.attribute && a.name == b.name;
  }
};
/// For messages: `TCP["gripper"].Value`.
[[nodiscard]] std::string describe(const AttributeRead& read);

struct AttributeWrite {
  ProjectAttribute attribute = ProjectAttribute::TcpValue;
  std::string name;             ///< isAttributeKey()
  std::vector<double> numbers;  ///< finite; as many as numbersOf()
};

/// Reads everything at one instant, in this order. Its first line sends the mark. Data after the mark, up to
/// the OK, belongs to this script, because the controller runs the scripts of all clients one after the
/// other.
struct ReadingScript {
  std::string mark;  ///< isAttributeKey(), and sent by no other client: a name and a counter
  std::vector<AttributeRead> reads;
};
/// Channel of the mark. Other clients do not use it.
inline constexpr int kMarkChannel = 99;
/// The line of reads[0]; the mark is on the line before.
inline constexpr int kFirstReadLine = 2;

/// One line without line end.
[[nodiscard]] std::string toText(const AttributeRead& read);
[[nodiscard]] std::string toText(const AttributeWrite& write);
/// Lines joined by CR LF, without one at the end.
[[nodiscard]] std::string toText(const ReadingScript& script);
[[nodiscard]] std::string toText(const std::vector<AttributeWrite>& script);

}  // namespace cobot_command::script
