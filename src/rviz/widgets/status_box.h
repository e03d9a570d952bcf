// The outputs of a block on the screen: Busy, Done, Error, ErrorID with description and remedy, the tag, and
// how far it is.
#pragma once

#include <QWidget>

#include "clients/command.h"

class QLabel;
class QProgressBar;

namespace cobot_command::rviz_plugin {

class TextBlock;

class StatusBox : public QWidget {
 public:
  explicit StatusBox(QWidget* parent = nullptr);

  /// `checks`: of a command that was only planned, which looks like no motion.
  void show(const CommandState& state, bool checks = false);

 private:
  QLabel* busy_;
  QLabel* checked_;
  QLabel* done_;
  QLabel* error_;
  QLabel* aborted_;
  QLabel* error_id_;
  QLabel* ack_;
  QProgressBar* progress_;
  TextBlock* text_;
};

/// As the pages write ids: 16#25; of paths decimal, from 1000 on, as their manual has them.
[[nodiscard]] QString errorIdText(int error_id);

}  // namespace cobot_command::rviz_plugin
