// The outputs of a block on the screen: Busy, Done, Error, ErrorID with description and remedy, the tag, and
// how far it is.
#pragma once

#include <QGroupBox>

#include "clients/command.h"

class QLabel;
class QProgressBar;

namespace cobot_command::rviz_plugin {

class StatusBox : public QGroupBox {
 public:
  explicit StatusBox(QWidget* parent = nullptr);

  void show(const CommandState& state);

 private:
  QLabel* busy_;
  QLabel* done_;
  QLabel* error_;
  QLabel* aborted_;
  QLabel* error_id_;
  QLabel* ack_;
  QLabel* text_;
  QProgressBar* progress_;
};

/// As the pages write ids: 16#25; of paths decimal, from 1000 on, as their manual has them.
[[nodiscard]] QString errorIdText(int error_id);

}  // namespace cobot_command::rviz_plugin
