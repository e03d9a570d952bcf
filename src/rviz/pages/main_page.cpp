#include "pages/main_page.h"

#include <QGridLayout>
#include <QGroupBox>
#include <QPushButton>
#include <QVBoxLayout>

namespace cobot_command::rviz_plugin {
namespace {

constexpr int kColumns = 2;
constexpr int kButtonHeight = 44;

}  // namespace

MainPage::MainPage(const std::vector<Area>& areas, const std::function<void(const Page&)>& open)
    : Page("main", "Main") {
  auto* layout = new QVBoxLayout(this);
  for (const Area& area : areas) {
    auto* box = new QGroupBox(area.name);
    auto* grid = new QGridLayout;
    box->setLayout(grid);
    int cell = 0;
    for (const Page* page : area.pages) {
      auto* button = new QPushButton(page->title());
      button->setObjectName("open_" + page->objectName());
      button->setMinimumHeight(kButtonHeight);
      connect(button, &QPushButton::clicked, this, [open, page] { open(*page); });
      grid->addWidget(button, cell / kColumns, cell % kColumns);
      ++cell;
    }
    layout->addWidget(box);
  }
  layout->addStretch();
}

}  // namespace cobot_command::rviz_plugin
