// The ranges of the forms are those of the blocks: their ends are taken, and what is beyond them is not.
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "block_messages.h"
#include "forms/forms.h"
#include "goals/goals.h"
#include "no_lookups.h"
#include <gmock/gmock.h>

namespace cobot_command::ros_adapter {

blocks::ExchangeConfigurationGoal toGoal(const cobot_command::ExchangeConfigurationGoal& message,
                                         const Lookups& lookups);
blocks::JogGoal toGoal(const cobot_command::JogGoal& message, const Lookups& lookups);

}  // namespace cobot_command::ros_adapter

namespace cobot_command::rviz_plugin {
namespace {

using ros_adapter::Lookups;
using ros_adapter::toGoal;
using Failures = std::vector<blocks::Failure>;

const Lookups nothing{ros_adapter::noFrame, ros_adapter::noSteps, ros_adapter::noPoints};

struct PageOfBlock {
  std::string name;
  Form form;
  std::function<Failures(const Form&)> check;
  std::set<std::string> narrower;  ///< fields for which the block takes more than people would enter
};

/// The node fills in what it was started with where there is nothing; the block itself wants an address.
Form connectToRobot() {
  Form form = connectForm();
  form.set("host", "robot");
  form.set("port", 5890);
  return form;
}

std::vector<PageOfBlock> pages() {
  const auto joints = [] {
    std::set<std::string> keys;
    for (int i = 0; i < 6; ++i) keys.insert("joints." + std::to_string(i));
    return keys;
  };
  return {
      {"connect",
       connectToRobot(),
       [](const Form& f) { return check(toGoal(toConnect(f), nothing)); },
       {"port"}},
      {"change_base",
       changeBaseForm(),
       [](const Form& f) { return check(toGoal(toChangeBase(f), nothing)); },
       {}},
      {"change_tcp",
       changeTcpForm(),
       [](const Form& f) { return check(toGoal(toChangeTcp(f), nothing)); },
       {}},
      {"move_absolute", moveAbsoluteForm(),
       [](const Form& f) { return check(toGoal(toMoveAbsolute(f), nothing)); }, joints()},
      {"move_relative", moveRelativeForm(),
       [](const Form& f) { return check(toGoal(toMoveRelative(f), nothing)); }, joints()},
      {"move_circle",
       moveCircleForm(),
       [](const Form& f) { return check(toGoal(toMoveCircle(f), nothing)); },
       {}},
  };
}

/// Each of the ways in which the choices and switches of a form can stand, by those that change what is
/// shown.
std::vector<Form> variantsOf(const Form& form) {
  std::vector<Form> variants{form};
  for (const char* key : {"movement_command", "data_format", "blending_enable"}) {
    if (!form.has(key)) continue;
    std::vector<Form> more;
    for (const Form& variant : variants) {
      const Field& field = variant.field(key);
      if (field.kind == Field::Kind::Switch) {
        for (const double value : {0.0, 1.0}) more.emplace_back(variant).set(key, value);
      } else {
        for (const Option& option : field.options) more.emplace_back(variant).set(key, option.value);
      }
    }
    variants = std::move(more);
  }
  return variants;
}

/// The same, but for one field, that takes what is beyond its range. What is shown stays so.
Form beyond(const Form& form, const std::string& key, double number) {
  std::vector<Field> fields = form.fields();
  for (Field& field : fields) {
    if (field.key == key) field.number = number;
  }
  return Form(fields);
}

TEST(Ranges, ofAllFormsAreTakenByTheBlocksAtBothEnds) {
  for (const PageOfBlock& page : pages()) {
    for (const Form& variant : variantsOf(page.form)) {
      for (const Field& field : variant.fields()) {
        if (field.kind != Field::Kind::Number || !field.shown) continue;
        for (const double end : {field.lowest, field.highest}) {
          Form form = variant;
          EXPECT_TRUE(form.set(field.key, end));
          const Failures failures = page.check(form);
          EXPECT_TRUE(failures.empty() || page.narrower.count(field.key) != 0)
              << page.name << ", " << field.key << " " << end << ": " << failures.front().found;
        }
      }
    }
  }
}

TEST(Ranges, endWhereThoseOfTheBlocksEnd) {
  for (const PageOfBlock& page : pages()) {
    for (const Form& variant : variantsOf(page.form)) {
      for (const Field& field : variant.fields()) {
        if (field.kind != Field::Kind::Number || !field.shown || page.narrower.count(field.key) != 0) {
          continue;
        }
        for (const double outside : {field.lowest - 1, field.highest + 1}) {
          EXPECT_FALSE(page.check(beyond(variant, field.key, outside)).empty())
              << page.name << ", " << field.key << " " << outside;
        }
      }
    }
  }
}

TEST(Ranges, ofTheInterfaceAreThoseOfItsBlock) {
  const auto checked = [](const Form& form) { return check(toGoal(toInterface(form), nothing)); };
  EXPECT_TRUE(checked(interfaceForm()).empty());
  EXPECT_FALSE(checked(beyond(interfaceForm(), "life_sign_time_out", 9)).empty());
  EXPECT_FALSE(checked(beyond(interfaceForm(), "wait_for_nr_of_cmd", 65)).empty());
  for (const char* key : {"log_level", "sync_reaction"}) {
    for (const Option& option : interfaceForm().field(key).options) {
      Form form = interfaceForm();
      form.set(key, option.value);
      EXPECT_TRUE(checked(form).empty()) << key << " " << option.value;
    }
  }
}

TEST(Ranges, ofJogAreTakenByItsBlockInEachDirectionAndMode) {
  for (const double mode : {0.0, 1.0, 2.0}) {
    for (const bool stepwise : {false, true}) {
      for (int axis = 0; axis < 6; ++axis) {
        for (const char* key : {"speed", "increment_mm", "increment_deg"}) {
          for (const double end : {jogForm().field(key).lowest, jogForm().field(key).highest}) {
            Form form = jogForm();
            form.set("mode", mode);
            form.set("stepwise", stepwise ? 1 : 0);
            form.set(key, end);
            EXPECT_TRUE(check(toGoal(toJog(form, axis, -1), nothing)).empty())
                << mode << " " << axis << " " << key;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace cobot_command::rviz_plugin
