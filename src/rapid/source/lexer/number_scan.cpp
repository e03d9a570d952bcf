#include "lexer/number_scan.h"

#include "lexer/character_class.h"

namespace cobot_command::rapid {

namespace {

class NumberScanner {
 public:
  NumberScanner(std::string_view text, Dialect dialect) : text_(text), dialect_(dialect) {}

  NumberScan scan() {
    const bool is_number = dialect_ == Dialect::Irc5 && hasPrefix() ? digitsOfPrefix() : decimal();
    const std::size_t end = at_;
    skipGlued();
    // Less than 1E28, times 1E9, is below the greatest number.
    constexpr std::size_t kShort = 28;
    const bool can_overflow = exponent_digits_ > 1 || at_ > kShort;
    return {at_, is_number && at_ == end, can_overflow};
  }

 private:
  [[nodiscard]] char peek(std::size_t ahead = 0) const {
    return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
  }
  [[nodiscard]] bool isDigit(std::size_t ahead = 0) const {
    return classOf(peek(ahead)) == CharacterClass::Digit;
  }
  [[nodiscard]] bool hasPrefix() const {
    return peek() == '0' && std::string_view("xXbBoO").find(peek(1)) != std::string_view::npos &&
           peek(1) != '\0';
  }

  bool digitsOfPrefix() {
    const char letter = peek(1);
    const bool is_hex = letter == 'x' || letter == 'X';
    const bool is_binary = letter == 'b' || letter == 'B';
    const std::string_view digits = is_hex ? "0123456789abcdefABCDEF" : is_binary ? "01" : "01234567";
    at_ += 2;
    const std::size_t first = at_;
    while (peek() != '\0' && digits.find(peek()) != std::string_view::npos) ++at_;
    return at_ > first;
  }

  std::size_t skipDigits() {
    const std::size_t first = at_;
    while (isDigit()) ++at_;
    return at_ - first;
  }

  bool decimal() {
    const bool has_whole = skipDigits() > 0;
    bool has_fraction = true;
    if (peek() == '.') {
      ++at_;
      has_fraction = skipDigits() > 0;
    }
    skipExponent();
    return dialect_ == Dialect::Irc5 ? has_whole || has_fraction : has_whole && has_fraction;
  }

  void skipExponent() {
    if (peek() != 'e' && peek() != 'E') return;
    const std::size_t sign = peek(1) == '+' || peek(1) == '-' ? 1 : 0;
    if (!isDigit(1 + sign)) return;
    at_ += 1 + sign;
    exponent_digits_ = skipDigits();
  }

  void skipGlued() {
    while (true) {
      const CharacterClass next = classOf(peek());
      const bool is_latin = next == CharacterClass::Latin && isLatinLetter(peek(1));
      if (is_latin) {
        at_ += 2;
      } else if (next == CharacterClass::Letter || next == CharacterClass::Digit ||
                 next == CharacterClass::Underscore || next == CharacterClass::Dot) {
        ++at_;
      } else {
        return;
      }
    }
  }

  std::string_view text_;
  Dialect dialect_;
  std::size_t at_ = 0;
  std::size_t exponent_digits_ = 0;
};

}  // namespace

NumberScan scanNumber(std::string_view text, Dialect dialect) {
  return NumberScanner(text, dialect).scan();
}

}  // namespace cobot_command::rapid
