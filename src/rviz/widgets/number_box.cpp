#include "widgets/number_box.h"

#include <QLocale>
#include <QRegularExpression>

namespace cobot_command::rviz_plugin {

QString NumberBox::plain(const QString& text) const {
  QString number = text;
  if (!suffix().isEmpty() && number.endsWith(suffix())) number.chop(suffix().size());
  return number.trimmed().replace(',', '.');
}

QValidator::State NumberBox::validate(QString& text, int& /*place*/) const {
  static const QRegularExpression begun(R"(^[+-]?\d*\.?\d*([eE][+-]?\d*)?$)");
  const QString number = plain(text);
  if (!begun.match(number).hasMatch()) return QValidator::Invalid;
  bool is_number = false;
  const double value = QLocale::c().toDouble(number, &is_number);
  const bool is_taken = is_number && value >= minimum() && value <= maximum();
  return is_taken ? QValidator::Acceptable : QValidator::Intermediate;
}

double NumberBox::valueFromText(const QString& text) const {
  return QLocale::c().toDouble(plain(text));
}

QString NumberBox::textFromValue(double value) const {
  return QString::number(value, 'f', decimals());
}

}  // namespace cobot_command::rviz_plugin
