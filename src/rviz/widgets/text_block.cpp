#include "widgets/text_block.h"

#include <cmath>

namespace cobot_command::rviz_plugin {
namespace {

constexpr int kFewest = 8;  // characters

}  // namespace

TextBlock::TextBlock(const char* name, int lines) : lines_(lines) {
  setObjectName(name);
  setReadOnly(true);
  setAcceptRichText(false);
  setTabChangesFocus(true);
  setFocusPolicy(Qt::ClickFocus);
  setFrameShape(QFrame::NoFrame);
  setWordWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
  setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  if (lines_ == 0) setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  document()->setDocumentMargin(0);
  viewport()->setAutoFillBackground(false);
  fit();
}

void TextBlock::show(const QString& text) {
  if (toPlainText() == text) return;  // what is selected stays so
  setPlainText(text);
  fit();
}

QSize TextBlock::minimumSizeHint() const {
  return {kFewest * fontMetrics().averageCharWidth(), fontMetrics().lineSpacing()};
}

void TextBlock::resizeEvent(QResizeEvent* event) {
  QTextEdit::resizeEvent(event);
  fit();
}

void TextBlock::fit() {
  const double needed = lines_ == 0 ? document()->size().height() : lines_ * fontMetrics().lineSpacing();
  setFixedHeight(static_cast<int>(std::ceil(needed)) + 2);
}

}  // namespace cobot_command::rviz_plugin
