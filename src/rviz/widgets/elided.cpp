#include "widgets/elided.h"

#include <QPainter>
#include <QStyle>
#include <QStyleOptionButton>
#include <QStylePainter>
#include <algorithm>

namespace cobot_command::rviz_plugin {
namespace {

constexpr int kFewest = 8;    // characters that are always shown
constexpr int kMargins = 24;  // of a button [pixels]

int widthOf(const QWidget& widget, const QString& text) {
  const QFontMetrics metrics = widget.fontMetrics();
  return std::min(metrics.horizontalAdvance(text), kFewest * metrics.averageCharWidth());
}

}  // namespace

ElidedLabel::ElidedLabel(const char* name, QWidget* parent) : QLabel(parent) {
  setObjectName(name);
  setTextFormat(Qt::PlainText);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

void ElidedLabel::show(const QString& text) {
  setText(text);
  setToolTip(text);
}

QSize ElidedLabel::minimumSizeHint() const {
  return {widthOf(*this, text()), fontMetrics().height() + 2};
}

void ElidedLabel::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  const QString shown = fontMetrics().elidedText(text(), Qt::ElideRight, contentsRect().width());
  style()->drawItemText(&painter, contentsRect(), static_cast<int>(alignment()), palette(), isEnabled(),
                        shown, foregroundRole());
}

QSize ElidedButton::minimumSizeHint() const {
  return {widthOf(*this, text()) + kMargins, QPushButton::sizeHint().height()};
}

void ElidedButton::paintEvent(QPaintEvent* /*event*/) {
  QStylePainter painter(this);
  QStyleOptionButton option;
  initStyleOption(&option);
  option.text = fontMetrics().elidedText(text(), Qt::ElideMiddle, width() - kMargins);
  painter.drawControl(QStyle::CE_PushButton, option);
}

}  // namespace cobot_command::rviz_plugin
