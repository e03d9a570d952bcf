// A form on the screen: a box for each number with its unit and range, a list for each choice.
#pragma once

#include <QWidget>
#include <functional>
#include <string>
#include <vector>

#include "forms/form.h"

class QFormLayout;

namespace cobot_command::rviz_plugin {

class FormView : public QWidget {
 public:
  /// `form` outlives the view.
  explicit FormView(Form& form, QWidget* parent = nullptr);

  /// What the form has, when somebody else has changed it.
  void refresh();
  /// Takes what was typed and not confirmed: what is shown is what counts.
  void commit();
  void onEdit(std::function<void()> listener) { listener_ = std::move(listener); }

 private:
  /// The widget of a field, what stands beside it, and how it gets what the field is.
  struct Entry {
    std::string key;
    QWidget* label;
    QWidget* editor;
    std::function<void(const Field&)> put;
  };
  struct Group {
    std::string name;
    QWidget* box;
  };

  QWidget* editorOf(const Field& field);
  QWidget* numberEditor(const Field& field);
  QWidget* choiceEditor(const Field& field);
  QWidget* switchEditor(const Field& field);
  QWidget* textEditor(const Field& field);
  void addGroup(QFormLayout& layout, const std::string& name);
  void edited();

  Form& form_;
  std::vector<Entry> entries_;
  std::vector<Group> groups_;
  std::function<void()> listener_;
  bool refreshes_ = false;
};

}  // namespace cobot_command::rviz_plugin
