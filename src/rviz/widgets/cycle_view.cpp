#include "widgets/cycle_view.h"

#include <QPainter>
#include <QPushButton>
#include <cmath>

#include "forms/motion_fields.h"

namespace cobot_command::rviz_plugin {
namespace {

constexpr int kHeight = 230;
constexpr double kHigh = 74;    // of the upper points, from the top [pixels]
constexpr double kLow = 178;    // of the lower ones
constexpr double kApart = 15;   // between down and up
constexpr double kHead = 9;     // of an arrow
constexpr double kBeside = 40;  // from an arrow to its button
constexpr double kPlate = 34;   // half of what parts lie on
const QColor kIdle(110, 116, 124);
const QColor kActive(47, 111, 181);

void drawArrow(QPainter& painter, const QPointF& from, const QPointF& to) {
  painter.drawLine(from, to);
  const QPointF way = to - from;
  const QPointF along = way / std::hypot(way.x(), way.y());
  const QPointF across(-along.y(), along.x());
  painter.drawPolyline(
      QVector<QPointF>{to - along * kHead + across * kHead / 2, to, to - along * kHead - across * kHead / 2});
}

void drawPlace(QPainter& painter, double x, const QString& name) {
  painter.setPen(QPen(kIdle, 3));
  painter.drawLine(QPointF(x - kPlate, kLow + 12), QPointF(x + kPlate, kLow + 12));
  painter.setPen(QPen(kIdle, 1));
  painter.drawText(QRectF(x - 60, kLow + 16, 120, 20), Qt::AlignCenter, name);
}

}  // namespace

CycleView::CycleView(const Cycle& cycle, const std::function<void(std::size_t)>& edit, QWidget* parent)
    : QWidget(parent), cycle_(cycle) {
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    buttons_[i] = new QPushButton(QString("Edit %1").arg(i + 1), this);
    buttons_[i]->setObjectName(QString("edit_%1").arg(i + 1));
    buttons_[i]->setToolTip(Cycle::kNames[i]);
    connect(buttons_[i], &QPushButton::clicked, this, [edit, i] { edit(i); });
  }
  setMinimumHeight(kHeight);
}

QSize CycleView::sizeHint() const {
  return {360, kHeight};
}

void CycleView::showStep(int step) {
  if (step == step_) return;
  step_ = step;
  update();
}

std::array<CycleView::Arrow, Cycle::kMoves> CycleView::arrows() const {
  const double pick = 0.3 * width();
  const double place = 0.7 * width();
  const double middle = 0.5 * width();
  return {
      {{{place, kHigh - 26}, {pick, kHigh - 26}, {middle, kHigh - 48}},
       {{pick - kApart, kHigh}, {pick - kApart, kLow}, {pick - kApart - kBeside, 0.5 * (kHigh + kLow)}},
       {{pick + kApart, kLow}, {pick + kApart, kHigh}, {pick + kApart + kBeside, 0.5 * (kHigh + kLow) + 28}},
       {{pick + kApart, kHigh - 8}, {place - kApart, kHigh - 8}, {middle, kHigh + 12}},
       {{place - kApart, kHigh},
        {place - kApart, kLow},
        {place - kApart - kBeside, 0.5 * (kHigh + kLow) + 28}},
       {{place + kApart, kLow}, {place + kApart, kHigh}, {place + kApart + kBeside, 0.5 * (kHigh + kLow)}}}};
}

void CycleView::resizeEvent(QResizeEvent* /*event*/) {
  const auto places = arrows();
  for (std::size_t i = 0; i < buttons_.size(); ++i) {
    const QSize size(58, buttons_[i]->sizeHint().height());
    buttons_[i]->setGeometry(QRect(QPoint(0, 0), size));
    buttons_[i]->move((places[i].button - QPointF(size.width() / 2.0, size.height() / 2.0)).toPoint());
  }
}

void CycleView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  drawPlace(painter, 0.3 * width(), "pick");
  drawPlace(painter, 0.7 * width(), "place");
  const auto places = arrows();
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool active = step_ == static_cast<int>(i);
    QPen pen(active ? kActive : kIdle, active ? 4 : 2);
    if (cycle_.moves[i].whole("movement_command") == kPtp) pen.setStyle(Qt::DashLine);
    painter.setPen(pen);
    drawArrow(painter, places[i].from, places[i].to);
  }
}

}  // namespace cobot_command::rviz_plugin
