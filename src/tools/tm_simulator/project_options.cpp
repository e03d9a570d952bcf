#include "project_options.h"

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "cobot_command/arm/controller_pose.h"

namespace cobot_command::tools {

namespace {

using Six = std::array<double, 6>;

/// NAME=N1,N2,N3,N4,N5,N6
std::pair<std::string, Six> namedNumbers(const std::string& text) {
  const std::size_t equals = text.find('=');
  Six numbers{};
  std::size_t count = 0;
  if (equals != std::string::npos && equals > 0) {
    for (const std::string& number : CLI::detail::split(text.substr(equals + 1), ',')) {
      double value = 0;
      if (count == numbers.size() || !CLI::detail::lexical_cast(number, value)) return {"", numbers};
      numbers[count++] = value;
    }
  }
  if (count != numbers.size()) return {"", numbers};
  return {text.substr(0, equals), numbers};
}

template <class Use>
void addNamed(CLI::App& app, const std::string& option, const std::string& meaning, Use use) {
  app.add_option_function<std::vector<std::string>>(
         option,
         [use](const std::vector<std::string>& texts) {
           for (const std::string& text : texts) {
             const auto [name, numbers] = namedNumbers(text);
             use(name, numbers);
           }
         },
         meaning)
      ->check([](const std::string& text) {
        return namedNumbers(text).first.empty() ? "a name, = and six numbers are wanted, not " + text
                                                : std::string();
      });
}

}  // namespace

void describeProject(CLI::App& app, simulator::Settings& settings) {
  addNamed(app, "--base", "a base of the project: NAME=X,Y,Z,RX,RY,RZ in mm and degrees",
           [&settings](const std::string& name, const Six& six) { settings.bases[name] = arm::toPose(six); });
  addNamed(app, "--tcp", "a TCP of the project: NAME=X,Y,Z,RX,RY,RZ in mm and degrees",
           [&settings](const std::string& name, const Six& six) { settings.tcps[name] = arm::toPose(six); });
  addNamed(app, "--point", "a point of the project: NAME=J1,J2,J3,J4,J5,J6 in degrees",
           [&settings](const std::string& name, const Six& six) {
             settings.points[name] = arm::toJointVector(six);
           });
  app.add_option(
      "--variable", settings.variables,
      "a variable of the project: \"int var_i = 5\"; a global one if its name begins with g_; on the "
      "status port when --stream-items names it");
}

}  // namespace cobot_command::tools
