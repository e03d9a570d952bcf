#include "cobot_command/rapid/source/name_table.h"

namespace cobot_command::rapid {

namespace {

constexpr char kLatinLead = '\xC3';  // of the letters of ISO 8859-1 in UTF-8

/// The second byte of a letter with kLatinLead.
char foldedLatin(char second) {
  const auto value = static_cast<unsigned char>(second);
  constexpr unsigned char kFirstCapital = 0x80;
  constexpr unsigned char kLastCapital = 0x9E;
  constexpr unsigned char kMultiplication = 0x97;  // among the capitals, and no letter
  const bool is_capital = value >= kFirstCapital && value <= kLastCapital && value != kMultiplication;
  return is_capital ? static_cast<char>(value + 0x20) : second;
}

char foldedByte(char byte, char before) {
  if (byte >= 'A' && byte <= 'Z') return static_cast<char>(byte + ('a' - 'A'));
  return before == kLatinLead ? foldedLatin(byte) : byte;
}

void foldTo(std::string_view name, std::string& result) {
  result.resize(name.size());
  char before = 0;
  for (std::size_t i = 0; i < name.size(); ++i) {
    result[i] = foldedByte(name[i], before);
    before = name[i];
  }
}

/// The place of a name among the recent ones. Precondition: not empty.
std::size_t placeOf(std::string_view folded, std::size_t places) {
  const auto at = [&](std::size_t index) -> std::size_t { return static_cast<unsigned char>(folded[index]); };
  const std::size_t last = folded.size() - 1;
  return (folded.size() + 7 * at(0) + 31 * at(last) + 131 * at(folded.size() / 2)) % places;
}

}  // namespace

std::string folded(std::string_view name) {
  std::string result;
  foldTo(name, result);
  return result;
}

NameTable::NameTable() : recent_(kRecent, 0) {
  for (int word = 0; word < kReservedWords; ++word) {
    static_cast<void>(add(toString(static_cast<TokenKind>(word))));
  }
}

NameIndex NameTable::add(std::string_view name) {
  constexpr std::size_t kShort = 64;
  std::array<char, kShort> small{};
  if (name.size() > small.size()) return addFolded(rapid::folded(name));
  char before = 0;
  for (std::size_t i = 0; i < name.size(); ++i) {
    small[i] = foldedByte(name[i], before);
    before = name[i];
  }
  return addFolded({small.data(), name.size()});
}

std::optional<NameIndex> NameTable::find(std::string_view name) const {
  const auto found = indices_.find(rapid::folded(name));
  return found == indices_.end() ? std::nullopt : std::optional(found->second);
}

NameIndex NameTable::addFolded(std::string_view folded) {
  const std::size_t place = folded.empty() ? 0 : placeOf(folded, kRecent);
  if (!names_.empty() && *names_[recent_[place]] == folded) return recent_[place];
  auto found = indices_.find(folded);
  if (found == indices_.end()) {
    found = indices_.emplace(folded, static_cast<NameIndex>(names_.size())).first;
    names_.push_back(&found->first);
  }
  recent_[place] = found->second;
  return found->second;
}

}  // namespace cobot_command::rapid
