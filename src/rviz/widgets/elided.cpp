#include "widgets/elided.h"

#include <QPainter>
#include <QStyle>
#include <QStyleOptionButton>
#include <QStylePainter>
#include <QTextLayout>
#include <algorithm>

namespace cobot_command::rviz_plugin {
namespace {

constexpr int kFewest = 8;    // characters that are always shown
constexpr int kMargins = 24;  // of a button [pixels]

int widthOf(const QWidget& widget, const QString& text) {
  const QFontMetrics metrics = widget.fontMetrics();
  return std::min(metrics.horizontalAdvance(text), kFewest * metrics.averageCharWidth());
}

/// The last line ends with an ellipsis if the text is longer.
QStringList linesOf(const QWidget& widget, const QString& text, int most, int width) {
  QTextLayout layout(text, widget.font());
  QStringList lines;
  layout.beginLayout();
  for (QTextLine line = layout.createLine(); line.isValid(); line = layout.createLine()) {
    line.setLineWidth(width);
    const bool is_last = lines.size() + 1 == most;
    lines += is_last ? widget.fontMetrics().elidedText(text.mid(line.textStart()), Qt::ElideRight, width)
                     : text.mid(line.textStart(), line.textLength());
    if (is_last) break;
  }
  layout.endLayout();
  return lines;
}

}  // namespace

ElidedLabel::ElidedLabel(const char* name, int lines) : lines_(lines) {
  setObjectName(name);
  setTextFormat(Qt::PlainText);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
}

void ElidedLabel::show(const QString& text) {
  setText(text);
  setToolTip(text);
}

QSize ElidedLabel::minimumSizeHint() const {
  return {widthOf(*this, text()), lines_ * fontMetrics().lineSpacing() + 2};
}

void ElidedLabel::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  QRect line = contentsRect();
  line.setHeight(line.height() / lines_);
  for (const QString& shown : linesOf(*this, text(), lines_, line.width())) {
    style()->drawItemText(&painter, line, static_cast<int>(alignment()), palette(), isEnabled(), shown,
                          foregroundRole());
    line.translate(0, line.height());
  }
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
