// Texts of several lines that come from outside. They wrap, also within a word that is too long, so that none
// of them makes the panel wider; they can be selected and copied.
#pragma once

#include <QTextEdit>

namespace cobot_command::rviz_plugin {

class TextBlock : public QTextEdit {
 public:
  /// `lines`: so many are shown, the others by scrolling; 0: all of them are.
  explicit TextBlock(const char* name, int lines = 0);

  void show(const QString& text);
  [[nodiscard]] QSize sizeHint() const override { return minimumSizeHint(); }
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void fit();

  int lines_;
};

}  // namespace cobot_command::rviz_plugin
