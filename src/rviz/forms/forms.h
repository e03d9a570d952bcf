// The forms of the pages: what an operator enters for each block, as the blocks have it (action/*.action):
// same ranges, same units.
#pragma once

#include "forms/form.h"

namespace cobot_command::rviz_plugin {

[[nodiscard]] Form connectForm();
[[nodiscard]] Form changeBaseForm();
[[nodiscard]] Form changeTcpForm();
[[nodiscard]] Form moveAbsoluteForm();
/// For a form that has all of its fields, and more.
[[nodiscard]] Form::Rule moveAbsoluteRule();
[[nodiscard]] Form moveRelativeForm();
[[nodiscard]] Form moveCircleForm();
[[nodiscard]] Form loadPathForm();
[[nodiscard]] Form interfaceForm();
/// How to jog; where to is said by the button that is held.
[[nodiscard]] Form jogForm();

}  // namespace cobot_command::rviz_plugin
