// The pages of the panel, as the thesis has them (6.3.1 to 6.3.8), and those of what came behind it.
#pragma once

#include <vector>

#include "pages/command_page.h"

class QLabel;

namespace cobot_command::rviz_plugin {

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
  QLabel* connection_;
};

/// Also sets how fast paths run, and stops them on their way.
class LoadPathPage : public CommandPage {
 public:
  LoadPathPage();

 private:
  QWidget* makeFeedrate();
  void setFeedrate(double percent);
  void trigger(const char* service);

  QLabel* answer_;
};

/// Also tells the state of the group (SRCI).
class InterfacePage : public CommandPage {
 public:
  InterfacePage();
  void look() override;

 private:
  QLabel* group_;
};

}  // namespace cobot_command::rviz_plugin
