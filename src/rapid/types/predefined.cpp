#include "cobot_command/rapid/types/predefined.h"

#include <algorithm>
#include <array>

#include "embedded_modules.h"

#include "cobot_command/rapid/types/type_table.h"

namespace cobot_command::rapid {

namespace {

constexpr std::string_view kRefused = "! == known (";
constexpr std::string_view kSecondTier = "! == tier 2";
constexpr std::string_view kThirdTier = "! == tier 3";  // all of it is of irc5
constexpr std::array<std::string_view, 5> kIrc5Names{"z0", "calcrobt", "waittestandset", "ipers",
                                                     "clearpath"};

bool begins(std::string_view text, std::string_view with) {
  return text.substr(0, with.size()) == with;
}

/// The first comment of the catalogue that begins so.
TokenIndex commentOf(std::string_view beginning) {
  const Source& source = catalogue();
  TokenIndex token = 0;
  while (token + 1 < source.tokens().size() && !begins(source.textOf(token), beginning)) ++token;
  return token;
}

/// Of a comment `! == known (reason; way around): NAME NAME`.
void addRefusals(std::string_view comment, std::vector<Refusal>& refusals) {
  const std::size_t end = comment.rfind("):");
  const std::string_view why = comment.substr(kRefused.size(), end - kRefused.size());
  const std::size_t part = std::min(why.find("; "), why.size() - 2);
  comment.remove_prefix(end + 2);
  while (!comment.empty()) {
    comment.remove_prefix(std::min(comment.find_first_not_of(' '), comment.size()));
    const std::size_t size = std::min(comment.find(' '), comment.size());
    if (size > 0) refusals.push_back({comment.substr(0, size), why.substr(0, part), why.substr(part + 2)});
    comment.remove_prefix(size);
  }
}

void addRefusals(const Source& source, std::vector<Refusal>& refusals) {
  for (TokenIndex token = 0; token < source.tokens().size(); ++token) {
    const std::string_view text = source.textOf(token);
    const bool is_refused = source.tokens()[token].kind == TokenKind::Comment && begins(text, kRefused);
    if (is_refused) addRefusals(text, refusals);
  }
}

std::vector<Refusal> allRefusals() {
  std::vector<Refusal> refusals;
  addRefusals(catalogue(), refusals);
  addRefusals(predefinedData(), refusals);
  return refusals;
}

/// The atomic types, and what is refused.
std::vector<std::string_view> namesWithoutDeclaration() {
  static const TypeTable types;
  std::vector<std::string_view> names;
  for (const Refusal& refusal : refusals()) names.push_back(refusal.name);
  for (TypeIndex type = kNum; type < types.size(); ++type) names.push_back(types[type].name);
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

const std::vector<Refusal>& refusals() {
  static const std::vector<Refusal> all = allRefusals();
  return all;
}

bool isNotBuilt(NodeIndex routine) {
  static const TokenIndex from = commentOf(kSecondTier);
  return catalogue().tree()[routine].first > from;
}

bool isOfIrc5Alone(std::string_view folded) {
  static const TokenIndex from = commentOf(kThirdTier);
  const DeclaredName declared = predefinedNames().find(folded);
  if (declared.source == &catalogue() && declared.source->tree()[declared.node].first > from) return true;
  return std::find(kIrc5Names.begin(), kIrc5Names.end(), folded) != kIrc5Names.end();
}

const PredefinedNames& predefinedNames() {
  static const PredefinedNames names({&predefinedData(), &catalogue()}, namesWithoutDeclaration());
  return names;
}

}  // namespace cobot_command::rapid
