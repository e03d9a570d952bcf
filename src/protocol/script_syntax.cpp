#include "script_syntax.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <boost/spirit/home/x3.hpp>
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"
#include "cobot_command/protocol/frame.h"

namespace cobot_command::protocol {

namespace {

namespace x3 = boost::spirit::x3;

constexpr const char* kBlanks = " \t";

/// Digits and a point, no exponent, no "inf" or "nan": what the manual shows of floats.
struct PlainReal : x3::real_policies<double> {
  template <class Iterator>
  static bool parse_exp(Iterator&, const Iterator&) {
    return false;
  }
  template <class Iterator, class Attribute>
  static bool parse_nan(Iterator&, const Iterator&, Attribute&) {
    return false;
  }
  template <class Iterator, class Attribute>
  static bool parse_inf(Iterator&, const Iterator&, Attribute&) {
    return false;
  }
};
struct PointedReal : PlainReal {
  static constexpr bool expect_dot = true;  // NOLINT: the name is Spirit's
};

const x3::real_parser<double, PointedReal> pointed_real;
const x3::real_parser<double, PlainReal> plain_real;
const x3::int_parser<std::int64_t> decimal;
const auto hexadecimal = x3::rule<struct HexadecimalRule, std::uint32_t>("hexadecimal digits of 32 bits") =
    x3::uint_parser<std::uint32_t, 16>();
const auto binary = x3::rule<struct BinaryRule, std::uint32_t>("binary digits of 32 bits") =
    x3::uint_parser<std::uint32_t, 2>();

Literal numberLiteral(Literal::Kind kind, double number) {
  Literal literal;
  literal.kind = kind;
  literal.number = number;
  return literal;
}

const auto set_integer = [](auto& context) {
  x3::_val(context) = numberLiteral(Literal::Kind::Integer, static_cast<double>(x3::_attr(context)));
};
const auto set_real = [](auto& context) {
  x3::_val(context) = numberLiteral(Literal::Kind::Real, x3::_attr(context));
};
const auto set_text = [](auto& context) {
  x3::_val(context).kind = Literal::Kind::Text;
  x3::_val(context).text = std::move(x3::_attr(context));
};
const auto set_word = [](auto& context) {
  std::string& word = x3::_attr(context);
  Literal& literal = x3::_val(context);
  literal.flag = word == "true" || word == "True";
  literal.kind =
      literal.flag || word == "false" || word == "False" ? Literal::Kind::Boolean : Literal::Kind::Name;
  literal.text = std::move(word);
};
const auto add_element = [](auto& context) {
  x3::_val(context).kind = Literal::Kind::Array;
  x3::_val(context).elements.push_back(std::move(x3::_attr(context)));
};
const auto set_function = [](auto& context) {
  x3::_val(context).function = std::move(x3::_attr(context));
  x3::_val(context).arguments.reserve(16);
};
const auto set_assignment = [](auto& context) { x3::_val(context).function = kAssignOutput; };
const auto add_argument = [](auto& context) {
  x3::_val(context).arguments.push_back(std::move(x3::_attr(context)));
};

const x3::rule<struct WordRule, std::string> word = "a name";
const x3::rule<struct QuotedRule, std::string> quoted = "a text in quotes";
const x3::rule<struct NumberRule, Literal> number = "a number";
const x3::rule<struct LiteralRule, Literal> literal = "an argument";
const x3::rule<struct CallRule, Call> call = "a command Name(arguments)";
const x3::rule<struct AssignmentRule, Call> assignment = "a command IO[...].DO[...]=...";

const auto word_def = x3::lexeme[x3::char_("A-Za-z_") >> *x3::char_("A-Za-z0-9_")];
const auto quoted_def = x3::lexeme['"' > *((x3::lit("\"\"") >> x3::attr('"')) | (x3::char_ - '"')) > '"'];
const auto number_def = x3::lexeme[("0x" > hexadecimal)[set_integer] | ("0b" > binary)[set_integer] |
                                   pointed_real[set_real] | decimal[set_integer] | plain_real[set_real]];
const auto literal_def = number[([](auto& context) { x3::_val(context) = std::move(x3::_attr(context)); })] |
                         quoted[set_text] | word[set_word] |
                         (('{' > number)[add_element] > *(',' > number)[add_element] > '}');
const auto call_def = word[set_function] > '(' > -(literal[add_argument] >> *(',' > literal)[add_argument]) >
                      ')';
const auto assignment_def = (x3::lit("IO") >> x3::lit('[')[set_assignment]) > literal[add_argument] > ']' >
                            '.' > literal[add_argument] > '[' > literal[add_argument] > ']' > '=' >
                            literal[add_argument];

BOOST_SPIRIT_DEFINE(word, quoted, number, literal, call, assignment)

}  // namespace

Result<std::optional<Call>, std::string> parseLine(std::string_view line) {
  const auto comment = x3::lit("//") >> *x3::char_;
  const auto end = x3::rule<struct EndRule>("the end of the line") = -comment >> x3::eoi;
  std::optional<Call> parsed;
  const auto keep = [&parsed](auto& context) { parsed = std::move(x3::_attr(context)); };
  const char* first = line.data();
  const char* const last = first + line.size();
  try {
    if (x3::phrase_parse(first, last, end | ((assignment[keep] | call[keep]) > end),
                         x3::char_(std::string(kBlanks)))) {
      return parsed;
    }
    return refuse(fmt::format("expected a command Name(arguments), found \"{}\"", foreignText(line, 32)));
  } catch (const x3::expectation_failure<const char*>& failure) {
    const auto failed = static_cast<std::size_t>(failure.where() - line.data());
    const std::size_t at = std::min(line.find_first_not_of(kBlanks, failed), line.size());
    const std::string_view found = line.substr(at);
    return refuse(fmt::format("column {}: expected {}, found {}", at + 1, failure.which(),
                              found.empty() ? "the end of the line" : '"' + foreignText(found, 32) + '"'));
  }
}

}  // namespace cobot_command::protocol
