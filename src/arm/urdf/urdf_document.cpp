#include "urdf_document.h"

#include <algorithm>
#include <mutex>
#include <string>
#include <utility>

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <tinyxml2.h>
#include <urdf_parser/urdf_parser.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/common/given.h"

namespace cobot_command::arm {
namespace {

constexpr const char* kBase = "base";
constexpr const char* kFlange = "flange_link";

/// While it lives, what urdfdom would print is collected instead. The output handler of console_bridge is one
/// for the process, hence the lock.
class UrdfdomMessages : private console_bridge::OutputHandler {
 public:
  UrdfdomMessages() : lock_(mutex()), previous_(console_bridge::getOutputHandler()) {
    console_bridge::useOutputHandler(this);
  }
  ~UrdfdomMessages() override { console_bridge::useOutputHandler(previous_); }
  UrdfdomMessages(const UrdfdomMessages&) = delete;
  UrdfdomMessages& operator=(const UrdfdomMessages&) = delete;

  /// All errors, the particular before the general; empty when there was none.
  [[nodiscard]] const std::string& errors() const { return errors_; }
  /// Something could not be read; what could is in the model all the same, and nothing in place of the rest.
  [[nodiscard]] bool isAnythingLost() const { return is_anything_lost_; }

 private:
  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR) return;
    errors_ += (errors_.empty() ? "" : "; ") + text;
    // A colour that is not defined is told as an error, too.
    is_anything_lost_ = is_anything_lost_ || text.find("material") == std::string::npos;
  }
  static std::mutex& mutex() {
    static std::mutex instance;
    return instance;
  }

  std::lock_guard<std::mutex> lock_;
  console_bridge::OutputHandler* previous_;
  std::string errors_;
  bool is_anything_lost_ = false;
};

ModelError noUrdf(std::string_view problem) {
  return {fmt::format("This is not a URDF: {}. Give the text of a complete URDF.", foreignText(problem))};
}

/// Of what is beside the first element, which is all that urdfdom looks at.
std::optional<std::string> problemBeside(const tinyxml2::XMLDocument& document) {
  int roots = 0;
  for (const auto* node = document.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node->ToText() != nullptr) return "there is text outside of <robot>";
    if (node->ToElement() != nullptr) ++roots;
  }
  if (roots == 1) return std::nullopt;
  return fmt::format("it has {} outermost elements, but must have one, <robot>", roots);
}

/// The links of urdfdom own their children: in a ring they own each other, and the memory would be lost.
void releaseRings(const urdf::ModelInterface& model) {
  for (const auto& [name, link] : model.links_) link->child_links.clear();
}

Result<urdf::ModelInterfaceSharedPtr, ModelError> parse(const std::string& text) {
  const UrdfdomMessages messages;
  std::string problem;
  try {
    auto model = urdf::parseURDF(text);
    if (model && !messages.isAnythingLost()) return model;
    if (model) releaseRings(*model);
  } catch (const std::exception& error) {
    problem = error.what();
  }
  if (problem.empty()) problem = messages.errors();
  if (problem.empty()) problem = "it is not XML with one <robot>";
  return refuse(noUrdf(problem));
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// What stands before "shoulder_1_joint".
Result<std::string, ModelError> prefixOf(const urdf::ModelInterface& model) {
  std::vector<std::string> prefixes;
  for (const auto& [name, joint] : model.joints_) {
    if (endsWith(name, kJointNames[0])) {
      prefixes.push_back(name.substr(0, name.size() - std::string(kJointNames[0]).size()));
    }
  }
  if (prefixes.size() == 1) return prefixes.front();
  return refuse(ModelError{fmt::format(
      "The URDF {} has {} joints whose name ends in \"{}\", but a model is one arm with exactly one. "
      "Give the URDF of one arm, with the joint names of the TM driver.",
      quoted(model.getName()), prefixes.size(), kJointNames[0])});
}

/// The joints from the base to the flange, in this order.
Result<std::vector<urdf::JointConstSharedPtr>, ModelError> pathOf(const urdf::ModelInterface& model,
                                                                  const std::string& prefix) {
  const std::string base = prefix + kBase;
  const std::string flange = prefix + kFlange;
  std::vector<urdf::JointConstSharedPtr> path;
  auto link = model.getLink(flange);
  // A URDF may hide a ring of links beside its tree, hence the bound.
  while (link && link->name != base && link->parent_joint && path.size() <= model.joints_.size()) {
    path.push_back(link->parent_joint);
    link = model.getLink(link->parent_joint->parent_link_name);
  }
  if (!link || link->name != base) {
    releaseRings(model);
    return refuse(
        ModelError{fmt::format("The URDF {} has no chain of joints from the link {} to the link {}. "
                               "Name the first and the last link of the arm so.",
                               quoted(model.getName()), quoted(base), quoted(flange))});
  }
  std::reverse(path.begin(), path.end());
  return path;
}

}  // namespace

std::optional<ModelError> whyNotOneRobot(const std::string& text) {
  if (text.find('\0') != std::string::npos) return noUrdf("there is a NUL byte in it");
  tinyxml2::XMLDocument document;
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
    return noUrdf(fmt::format("line {} is not XML, {}", document.ErrorLineNum(), document.ErrorName()));
  }
  if (document.FirstChildElement("robot") == nullptr) return noUrdf("it has no <robot>");
  const auto problem = problemBeside(document);
  return problem ? std::optional(noUrdf(*problem)) : std::nullopt;
}

Result<UrdfDocument, ModelError> readUrdfDocument(const std::string& urdf) {
  if (const auto error = whyNotOneRobot(urdf)) return refuse(*error);
  const auto model = parse(urdf);
  if (!model) return refuse(model.error());
  const auto prefix = prefixOf(**model);
  if (!prefix) return refuse(prefix.error());
  auto path = pathOf(**model, *prefix);
  if (!path) return refuse(path.error());
  return UrdfDocument{*model, *prefix, std::move(*path)};
}

}  // namespace cobot_command::arm
