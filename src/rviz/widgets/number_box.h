// A box for a number that becomes the number that was typed, or stays as it was: never another one that is
// plausible, too.
#pragma once

#include <QDoubleSpinBox>

namespace cobot_command::rviz_plugin {

/// A comma is a decimal point, as a point is; 1e2 is 100. What is out of the range can be typed, and is taken
/// back when it is confirmed.
class NumberBox : public QDoubleSpinBox {
 public:
  using QDoubleSpinBox::QDoubleSpinBox;

  [[nodiscard]] QValidator::State validate(QString& text, int& place) const override;
  [[nodiscard]] double valueFromText(const QString& text) const override;
  [[nodiscard]] QString textFromValue(double value) const override;

 private:
  /// Without the unit, with a point.
  [[nodiscard]] QString plain(const QString& text) const;
};

}  // namespace cobot_command::rviz_plugin
