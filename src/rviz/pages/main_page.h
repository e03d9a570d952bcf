// The first page (6.3.1): from here to all others.
#pragma once

#include <functional>

#include "pages/page.h"

namespace cobot_command::rviz_plugin {

class MainPage : public Page {
 public:
  /// Of each area its name, and the pages that its buttons open.
  struct Area {
    QString name;
    std::vector<const Page*> pages;
  };

  MainPage(const std::vector<Area>& areas, const std::function<void(const Page&)>& open);

  void bind(const Workplace& /*workplace*/) override {}
};

}  // namespace cobot_command::rviz_plugin
