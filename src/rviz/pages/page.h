// A screen of the panel.
#pragma once

#include <QWidget>
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "clients/background_calls.h"
#include "clients/robot.h"
#include "preview/preview.h"
#include "preview/target.h"

namespace cobot_command::rviz_plugin {

/// What pages work with. The robot is another one after each bind().
struct Workplace {
  Robot* robot = nullptr;
  BackgroundCalls* calls = nullptr;
  Preview* preview = nullptr;
  Target* target = nullptr;
};

class Page : public QWidget {
 public:
  using Values = std::map<std::string, std::string>;

  /// `name`: of the widget, and in saved configurations.
  Page(const char* name, QString title) : title_(std::move(title)) { setObjectName(name); }

  [[nodiscard]] const QString& title() const { return title_; }
  /// The robot is another one: nothing of the one before is used any more.
  virtual void bind(const Workplace& workplace) = 0;
  /// What stays in sight below the page, however long that is: its buttons, and how its command goes.
  /// Nothing: it has no such.
  [[nodiscard]] virtual QWidget* footer() { return nullptr; }
  /// A few times a second: shows what the robot has told.
  virtual void look() {}
  /// Somebody stops the robot: what has not been sent yet is not sent any more.
  virtual void withdraw() {}
  /// What is entered here has become something else.
  void onEdit(std::function<void()> listener) { edit_listener_ = std::move(listener); }
  [[nodiscard]] virtual Values saved() const { return {}; }
  virtual void restore(const Values& /*values*/) {}

 protected:
  void tellEdit() const {
    if (edit_listener_) edit_listener_();
  }

 private:
  QString title_;
  std::function<void()> edit_listener_;
};

}  // namespace cobot_command::rviz_plugin
