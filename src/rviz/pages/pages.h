// The pages of the panel, as the thesis has them (6.3.1 to 6.3.8), and those of what came after it.
#pragma once

#include <vector>

#include "pages/command_page.h"

namespace cobot_command::rviz_plugin {

class TextBlock;

/// The pages that are a form and nothing else.
[[nodiscard]] CommandPageSpec changeBasePage();
[[nodiscard]] CommandPageSpec changeTcpPage();
[[nodiscard]] CommandPageSpec moveRelativePage();
[[nodiscard]] CommandPageSpec moveCirclePage();

/// Also tells how the connection is, since when, and when it was lost.
class ConnectPage : public CommandPage {
 public:
  ConnectPage();
  void look() override;

 private:
  TextBlock* connection_;
};

/// Also tells the state of the group (SRCI).
class InterfacePage : public CommandPage {
 public:
  InterfacePage();
  void look() override;

 private:
  TextBlock* group_;
};

}  // namespace cobot_command::rviz_plugin
