#include "cobot_command/arm/urdf_prefix.h"

#include <array>
#include <string_view>

#include "urdf_document.h"
#include <fmt/format.h>
#include <tinyxml2.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::arm {
namespace {

/// Where a URDF names a link, a joint or a transmission.
struct NamingPlace {
  std::string_view element;
  const char* attribute;
};
constexpr std::array<NamingPlace, 8> kNamingPlaces = {{{"link", "name"},
                                                       {"joint", "name"},
                                                       {"parent", "link"},
                                                       {"child", "link"},
                                                       {"mimic", "joint"},
                                                       {"transmission", "name"},
                                                       {"actuator", "name"},
                                                       {"gazebo", "reference"}}};

void addPrefix(tinyxml2::XMLElement& element, const std::string& prefix) {
  for (const NamingPlace& place : kNamingPlaces) {
    if (place.element != element.Name()) continue;
    if (const char* name = element.Attribute(place.attribute)) {
      element.SetAttribute(place.attribute, (prefix + name).c_str());
    }
  }
  for (auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    addPrefix(*child, prefix);
  }
}

}  // namespace

bool isNamePrefix(const std::string& text) {
  constexpr const char* kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./";
  return text.substr(0, 1) != "/" && text.find_first_not_of(kLetters) == std::string::npos;
}

Result<std::string, ModelError> withPrefix(const std::string& urdf, const std::string& prefix) {
  if (!isNamePrefix(prefix)) {
    return refuse(ModelError{
        fmt::format("The prefix is \"{}\". Allowed are letters, digits, _, -, . and /, not beginning with /.",
                    foreignText(prefix, kQuoteLimit))});
  }
  if (const auto error = whyNotOneRobot(urdf)) return refuse(*error);
  tinyxml2::XMLDocument document;
  document.Parse(urdf.data(), urdf.size());
  addPrefix(*document.FirstChildElement("robot"), prefix);
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return std::string(printer.CStr());
}

}  // namespace cobot_command::arm
