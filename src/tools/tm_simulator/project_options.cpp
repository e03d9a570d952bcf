#include "project_options.h"

#include <array>
#include <string>
#include <vector>

#include "cobot_command/arm/controller_pose.h"

namespace cobot_command::tools {

namespace {

using Six = std::array<double, 6>;

/// An option that may be given several times, each time as NAME=1,2,3,4,5,6.
template <class Use>
void addNamed(CLI::App& app, const std::string& option, const std::string& meaning, Use use) {
  app.add_option_function<std::vector<std::string>>(
      option,
      [option, use](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) {
          const auto named = simulator::parseNamedNumbers(text);
          if (!named) throw CLI::ValidationError(option, named.error());
          use(named->first, named->second);
        }
      },
      meaning);
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
