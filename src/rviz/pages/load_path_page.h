// Load Path: a path from a file, how fast paths run, and their stop on the way.
#pragma once

#include "pages/command_page.h"

namespace cobot_command::rviz_plugin {

class TextBlock;

class LoadPathPage : public CommandPage {
 public:
  LoadPathPage();

 private:
  QWidget* makeFileButtons();
  QWidget* makeFeedrate();
  /// In a window that leaves the panel, and its STOP, at hand.
  void browse();
  /// Puts in how many points the file has.
  void takeAllPoints();
  void setFeedrate(double percent);
  void trigger(const char* service);

  TextBlock* answer_;
};

}  // namespace cobot_command::rviz_plugin
