#include "cobot_command/rapid/types/predefined.h"

#include <algorithm>
#include <array>

#include "types/embedded_modules.h"

namespace cobot_command::rapid {

namespace {

constexpr std::string_view kRefused = "! == known (";
/// Types that no declaration describes.
constexpr std::array<std::string_view, 20> kAtomicTypes{
    "num",       "bool",      "string",    "switch",        "anytype",   "clock",    "iodev",
    "triggdata", "corrdescr", "shapedata", "mecunit",       "signaldo",  "signalgo", "signalao",
    "signaldi",  "signalgi",  "signalai",  "stoppointdata", "socketdev", "rawbytes"};

/// The names after the colon of a comment `! == known (reason; way around): NAME NAME`.
void addNames(std::string_view comment, std::vector<std::string_view>& names) {
  comment.remove_prefix(comment.rfind("):") + 2);
  while (!comment.empty()) {
    comment.remove_prefix(std::min(comment.find_first_not_of(' '), comment.size()));
    const std::size_t size = std::min(comment.find(' '), comment.size());
    if (size > 0) names.push_back(comment.substr(0, size));
    comment.remove_prefix(size);
  }
}

std::vector<std::string_view> refusedNamesOf(const Source& source) {
  std::vector<std::string_view> names;
  for (TokenIndex token = 0; token < source.tokens().size(); ++token) {
    const std::string_view text = source.textOf(token);
    const bool is_refused =
        source.tokens()[token].kind == TokenKind::Comment && text.substr(0, kRefused.size()) == kRefused;
    if (is_refused) addNames(text, names);
  }
  return names;
}

std::vector<std::string_view> namesWithoutDeclaration() {
  std::vector<std::string_view> names = refusedNames();
  names.insert(names.end(), kAtomicTypes.begin(), kAtomicTypes.end());
  return names;
}

}  // namespace

const Source& predefinedData() {
  static const Source source = readSource(kPredefinedModule);
  return source;
}

const Source& catalogue() {
  static const Source source = readSource(kCatalogueModule, {Dialect::Irc5, false});
  return source;
}

const std::vector<std::string_view>& refusedNames() {
  static const std::vector<std::string_view> names = refusedNamesOf(catalogue());
  return names;
}

const PredefinedNames& predefinedNames() {
  static const PredefinedNames names({&predefinedData(), &catalogue()}, namesWithoutDeclaration());
  return names;
}

}  // namespace cobot_command::rapid
