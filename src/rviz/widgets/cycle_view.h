// The pick-and-place cycle as a picture: six arrows, each with the button that edits its move (6.3.8).
#pragma once

#include <QWidget>
#include <array>
#include <functional>

#include "forms/cycle.h"

class QPushButton;

namespace cobot_command::rviz_plugin {

class CycleView : public QWidget {
 public:
  /// `edit` gets the number of the move, from 0.
  CycleView(const Cycle& cycle, const std::function<void(std::size_t)>& edit, QWidget* parent = nullptr);

  /// Draws the move that is under way; -1: none is.
  void showStep(int step);
  [[nodiscard]] QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  struct Arrow {
    QPointF from;
    QPointF to;
    QPointF button;  ///< its middle
  };

  [[nodiscard]] std::array<Arrow, Cycle::kMoves> arrows() const;

  const Cycle& cycle_;
  std::array<QPushButton*, Cycle::kMoves> buttons_{};
  int step_ = -1;
};

}  // namespace cobot_command::rviz_plugin
