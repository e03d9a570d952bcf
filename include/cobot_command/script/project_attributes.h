// What a project of the controller keeps under a name, and the lines of script that read and write it: values
// of its TCPs and bases, and what its TCPs weigh (TM 2.4). One row for each in
// src/script/project_attributes.cpp.
//
// A read is ListenSend() of the attribute: the controller sends it as floats (protocol/float_payload.h) under
// the channel of its row. A write is an assignment, which ends with the run of the project, and counts from
// the next ChangeTCP() or ChangeBase(). Units are the controller's own: mm, degrees, kg, kg mm^2.
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
  TcpMassCenter,  ///< frame of the mass centre in that of the TCP, as TcpValue
  BaseValue       ///< X Y Z [mm] RX RY RZ [deg] in the robot base
};

/// Since when scripts can do both; the controller answers an older version's ListenSend() with ERROR.
inline constexpr tm_script::Version kAttributesSince{1, 76};

/// How many numbers it has: six, one, three, six, six.
[[nodiscard]] std::size_t numbersOf(ProjectAttribute attribute);
/// Under which ListenSend() sends it: 90 a value, 91 Mass, 92 MOI, 93 MCF.
[[nodiscard]] int channelOf(ProjectAttribute attribute);
[[nodiscard]] bool isAttributeChannel(int channel);

/// What can stand as the key of an attribute: isName(), without two single quotes, as the controller replaces
/// a variable between them (I848-E-03 1.2), and another TCP would be meant.
[[nodiscard]] bool isAttributeKey(std::string_view name);

struct AttributeRead {
  ProjectAttribute attribute = ProjectAttribute::TcpValue;
  std::string name;  ///< isAttributeKey()

  friend bool operator==(const AttributeRead& a, const AttributeRead& b) {
    return a.attribute == b.attribute && a.name == b.name;
  }
};
/// In messages: `TCP["gripper"].Value`.
[[nodiscard]] std::string describe(const AttributeRead& read);

struct AttributeWrite {
  ProjectAttribute attribute = ProjectAttribute::TcpValue;
  std::string name;             ///< isAttributeKey()
  std::vector<double> numbers;  ///< finite, numbersOf()
};

/// Reads everything at one instant, in this order. Its first line sends the mark: what comes behind it, up to
/// the OK, is of this script, as the controller runs the scripts of all clients one after the other.
struct ReadingScript {
  std::string mark;  ///< isAttributeKey(), and what no other client sends: a name and a counter
  std::vector<AttributeRead> reads;
};
/// Under which the mark comes. Others leave it to us.
inline constexpr int kMarkChannel = 99;
/// The line of reads[0]; the mark stands on the one before.
inline constexpr int kFirstReadLine = 2;

/// Lines without line end.
[[nodiscard]] std::string toText(const AttributeRead& read);
[[nodiscard]] std::string toText(const AttributeWrite& write);
/// Lines joined by CR LF, without one at the end.
[[nodiscard]] std::string toText(const ReadingScript& script);
[[nodiscard]] std::string toText(const std::vector<AttributeWrite>& script);

}  // namespace cobot_command::script
