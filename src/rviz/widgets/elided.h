// Texts that come from outside, in one line or a few: as much as there is room for, so that none of them
// makes the panel wider. All of it is in the tooltip.
#pragma once

#include <QLabel>
#include <QPushButton>

namespace cobot_command::rviz_plugin {

class ElidedLabel : public QLabel {
 public:
  explicit ElidedLabel(const char* name, int lines = 1);

  /// Text and tooltip.
  void show(const QString& text);
  /// As high with a text as without one: nothing moves when one comes.
  [[nodiscard]] QSize sizeHint() const override { return minimumSizeHint(); }
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  int lines_;
};

/// Both ends of its text can be read.
class ElidedButton : public QPushButton {
 public:
  using QPushButton::QPushButton;

  [[nodiscard]] QSize sizeHint() const override { return minimumSizeHint(); }
  [[nodiscard]] QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace cobot_command::rviz_plugin
