#include "grammar/grammar.h"

#include <algorithm>
#include <utility>

#include "grammar/tree.h"
#include "values/numerals.h"
#include <boost/spirit/home/x3.hpp>
#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace boost::spirit::x3 {

/// In a fault, a parser with an action is called what the parser is called.
template <class Subject, class Action>
struct get_info<action<Subject, Action>> {
  using result_type = std::string;
  std::string operator()(const action<Subject, Action>& parser) const { return what(parser.subject); }
};

}  // namespace boost::spirit::x3

namespace cobot_command::tm_script {

namespace {

namespace x3 = boost::spirit::x3;

constexpr const char* kBlanks = " \t\r";
constexpr char kWordCharacters[] = "A-Za-z0-9_";

/// How deep the reader is inside brackets; in the context of a parse.
struct DepthTag;

/// Its subject, unless that would be one level too deep: the reader must not use up the stack.
template <class Subject>
struct Nested : x3::unary_parser<Subject, Nested<Subject>> {
  using Base = x3::unary_parser<Subject, Nested<Subject>>;
  static constexpr bool handles_container = Subject::handles_container;  // NOLINT: the name is Spirit's
  explicit Nested(const Subject& limited) : Base(limited) {}

  template <class Iterator, class Context, class RuleContext, class Attribute>
  bool parse(Iterator& first, const Iterator& last, const Context& context, RuleContext& rule_context,
             Attribute& attribute) const {
    int& depth = x3::get<DepthTag>(context);
    if (depth == kMaxNesting) {
      boost::throw_exception(x3::expectation_failure<Iterator>(
          first, fmt::format("at most {} levels of brackets", kMaxNesting)));
    }
    ++depth;
    const bool parsed = this->subject.parse(first, last, context, rule_context, attribute);
    --depth;
    return parsed;
  }
};
template <class Subject>
Nested<typename x3::extension::as_parser<Subject>::value_type> nested(const Subject& limited) {
  return Nested<typename x3::extension::as_parser<Subject>::value_type>{x3::as_parser(limited)};
}

/// Thrown where something was read that makes no sense: what is expected instead is the reason.
[[noreturn]] void fail(const char* where, const std::string& reason) {
  boost::throw_exception(x3::expectation_failure<const char*>(where, reason));
}

const auto word_end = !x3::char_(kWordCharacters);

struct Keywords : x3::symbols<ScalarType> {
  Keywords() {
    add("byte", ScalarType::Byte)("int", ScalarType::Int)("float", ScalarType::Float);
    add("double", ScalarType::Double)("bool", ScalarType::Bool)("string", ScalarType::String);
  }
} const keywords;

struct Constants : x3::symbols<Scalar> {
  Constants() {
    add("true", Scalar(true))("True", Scalar(true))("false", Scalar(false))("False", Scalar(false));
    add("empty", Scalar(std::string()));
    add("newline", Scalar(std::string("\r\n")))("NewLine", Scalar(std::string("\r\n")));
  }
} const constants;

struct BinaryOperators : x3::symbols<BinaryOperator> {
  BinaryOperators() {
    for (int i = 0; i <= static_cast<int>(BinaryOperator::Modulo); ++i) {
      add(toText(static_cast<BinaryOperator>(i)), static_cast<BinaryOperator>(i));
    }
  }
} const binary_operators;

struct AssignmentOperators : x3::symbols<std::optional<BinaryOperator>> {
  AssignmentOperators() {
    add("=", std::nullopt);
    for (const auto binary :
         {BinaryOperator::Add, BinaryOperator::Subtract, BinaryOperator::Multiply, BinaryOperator::Divide,
          BinaryOperator::Modulo, BinaryOperator::ShiftLeft, BinaryOperator::ShiftRight,
          BinaryOperator::BitAnd, BinaryOperator::BitXor, BinaryOperator::BitOr}) {
      add(toText(binary) + "=", binary);
    }
  }
} const assignment_operators;

struct PrefixOperators : x3::symbols<PrefixOperator> {
  PrefixOperators() {
    for (int i = 0; i <= static_cast<int>(PrefixOperator::Complement); ++i) {
      add(toText(static_cast<PrefixOperator>(i)), static_cast<PrefixOperator>(i));
    }
  }
} const prefix_operators;

struct PostfixOperators : x3::symbols<PostfixOperator> {
  PostfixOperators() { add("++", PostfixOperator::Increment)("--", PostfixOperator::Decrement); }
} const postfix_operators;

/// Hands what was read to a member of the value of the rule, or to a function that makes the value.
template <class Container, class Rule>
auto append(Container Rule::*member) {
  return [member](auto& context) { (x3::_val(context).*member).push_back(std::move(x3::_attr(context))); };
}
const auto take = [](auto& context) { x3::_val(context) = std::move(x3::_attr(context)); };
const auto take_tree = [](auto& context) {
  x3::_val(context).node = tree(std::move(x3::_attr(context))).node;
};

struct NamedCall {  ///< a name, perhaps with arguments
  std::string name;
  bool is_call = false;
  Expressions arguments;
};
struct Suffixed {
  Expression primary{Literal{}};
  std::vector<Suffix> suffixes;
};
struct Prefixed {
  std::vector<Prefix::Step> steps;
};

const auto set_literal = [](auto& context) {
  x3::_val(context).node = Literal{std::move(x3::_attr(context))};
};
const auto set_number = [](auto& context) {
  const auto& range = x3::_attr(context);
  const std::string_view numeral(range.begin(), static_cast<std::size_t>(range.size()));
  const auto literal = literalOf(numeral);
  if (!literal) fail(range.begin(), "a number of at most 32 bits, or one that a double holds");
  const bool is_float = std::holds_alternative<float>(*literal);
  x3::_val(context).node = Literal{*literal, is_float ? parseReal(numeral) : std::nullopt};
};
const auto set_elements = [](auto& context) {
  x3::_val(context).node = ArrayLiteral{std::move(x3::_attr(context))};
};
const auto set_call = [](auto& context) {
  NamedCall& call = x3::_attr(context);
  if (call.is_call) {
    x3::_val(context).node = Call{std::move(call.name), std::move(call.arguments)};
  } else {
    x3::_val(context).node = Name{std::move(call.name)};
  }
};
const auto open_call = [](auto& context) { x3::_val(context).is_call = true; };
const auto set_suffixed = [](auto& context) {
  auto suffixed = withSuffixes(std::move(x3::_attr(context).primary), std::move(x3::_attr(context).suffixes));
  if (!suffixed) fail(x3::_where(context).begin(), "something else: " + suffixed.error());
  x3::_val(context) = std::move(*suffixed);
};

const x3::rule<struct WordRule, std::string> word = "a name";
const x3::rule<struct TextRule, std::string> text = "a text in quotes";
const x3::rule<struct NumberRule, Expression> number = "a number";
const x3::rule<struct TypeRule, Type> type = "a type";
const x3::rule<struct ListRule, Expressions> list = "values, separated by commas";
const x3::rule<struct CallRule, NamedCall> call = "a name";
const x3::rule<struct PrimaryRule, Expression> primary = "a value";
const x3::rule<struct SuffixedRule, Suffixed> suffixed = "a value";
const x3::rule<struct PostfixRule, Expression> postfix = "a value";
const x3::rule<struct StepsRule, Prefixed> steps = "operators";
const x3::rule<struct PrefixRule, Expression> prefix = "a value";
const x3::rule<struct FlatChainRule, FlatChain> flat_chain = "a value";
const x3::rule<struct FlatConditionalRule, FlatConditional> flat_conditional = "a value";
const x3::rule<struct FlatAssignmentRule, FlatAssignment> flat_assignment = "a value";
const x3::rule<struct ExpressionRule, Expression> expression = "a value";
const x3::rule<struct DeclarationRule, Declaration> declaration = "a declaration";

const auto word_def =
    x3::lexeme[!(keywords >> word_end) >> x3::char_("A-Za-z_") >> *x3::char_(kWordCharacters)];
const auto text_def = x3::lexeme['"' > *((x3::lit("\"\"") >> x3::attr('"')) | (x3::char_ - '"')) > '"'];

// Not x3::digit and its kin: they must not see bytes above 0x7F.
const auto digit = x3::char_("0-9");
const auto hex_digit = x3::char_("0-9A-Fa-f");
const auto exponent = x3::char_("eE") >> -x3::char_("+-") >> +digit;
const auto numeral = (x3::lit('0') >> x3::char_("xX") >> *hex_digit) |
                     (x3::lit('0') >> x3::char_("bB") >> *digit) |
                     (((+digit >> -('.' >> *digit)) | ('.' >> +digit)) >> -exponent);
const auto number_def = x3::lexeme[x3::raw[numeral][set_number] > word_end];

const auto type_def = x3::lexeme[keywords >> word_end]
                                [([](auto& context) { x3::_val(context).scalar = x3::_attr(context); })] >>
                      -(x3::lit('[') >
                        x3::lit(']')[([](auto& context) { x3::_val(context).is_array = true; })]);

const auto list_def = expression % ',';
const auto call_def =
    word[([](auto& context) { x3::_val(context).name = std::move(x3::_attr(context)); })] >>
    -(x3::lit('(')[open_call] >
      -list[([](auto& context) { x3::_val(context).arguments = std::move(x3::_attr(context)); })] > ')');
const auto primary_def =
    number[take] | text[set_literal] |
    ('{' > ((x3::lit('}') >> x3::attr(Expressions()))[set_elements] | (list > '}')[set_elements])) |
    ('(' > expression[take] > ')') | x3::lexeme[constants >> word_end][set_literal] | call[set_call];

const auto suffixed_def =
    primary[([](auto& context) { x3::_val(context).primary = std::move(x3::_attr(context)); })] >>
    *(('[' > list[append(&Suffixed::suffixes)] > ']') | ('.' > word[append(&Suffixed::suffixes)]) |
      postfix_operators[append(&Suffixed::suffixes)]);
const auto postfix_def = suffixed[set_suffixed];
const auto steps_def =
    *(prefix_operators[append(&Prefixed::steps)] | (('(' >> type[append(&Prefixed::steps)]) > ')'));
const auto prefix_def =
    steps[([](auto& context) {
      x3::_val(context).node = Prefix{std::move(x3::_attr(context).steps), Expression{Literal{}}};
    })] >>
    postfix[([](auto& context) {
      auto waiting = std::move(std::get<Prefix>(x3::_val(context).node).steps);
      x3::_val(context).node = withPrefixes(std::move(waiting), std::move(x3::_attr(context))).node;
    })];

// "a += 1" is not "a + =1".
const auto binary = x3::lexeme[binary_operators >> !x3::lit('=')];
const auto flat_chain_def = prefix[append(&FlatChain::operands)] >>
                            *(binary[append(&FlatChain::operators)] > prefix[append(&FlatChain::operands)]);
const auto chain = x3::rule<struct ChainRule, Expression>("a value") = flat_chain[take_tree];
const auto flat_conditional_def = chain[append(&FlatConditional::values)] >>
                                  *('?' > expression[append(&FlatConditional::results)] > ':' >
                                    chain[append(&FlatConditional::values)]);
const auto conditional = x3::rule<struct ConditionalRule, Expression>("a value") =
    flat_conditional[take_tree];
const auto flat_assignment_def = conditional[append(&FlatAssignment::values)] >>
                                 *(assignment_operators[append(&FlatAssignment::operators)] >
                                   conditional[append(&FlatAssignment::values)]);
const auto expression_def = nested(flat_assignment[take_tree]);

const auto declaration_def =
    type[([](auto& context) { x3::_val(context).type = x3::_attr(context); })] >
    word[([](auto& context) { x3::_val(context).name = std::move(x3::_attr(context)); })] >
    -('=' > expression[([](auto& context) { x3::_val(context).initial = std::move(x3::_attr(context)); })]);

BOOST_SPIRIT_DEFINE(word, text, number, type, list, call, primary, suffixed)
BOOST_SPIRIT_DEFINE(postfix, steps, prefix, flat_chain, flat_conditional, flat_assignment, expression)
BOOST_SPIRIT_DEFINE(declaration)

std::string found(std::string_view line, std::size_t at) {
  constexpr std::size_t kLongest = 32;  // [bytes]
  const std::string_view rest = line.substr(at);
  return rest.empty() ? "the end of the line" : '"' + foreignText(rest, kLongest) + '"';
}

}  // namespace

Result<std::optional<Statement>, std::string> parseLine(std::string_view line) {
  std::optional<Statement> statement;
  const auto keep = [&statement](auto& context) {
    statement.emplace(Statement{0, std::move(x3::_attr(context))});
  };
  const auto end = x3::rule<struct EndRule>("the end of the line") = x3::eoi;
  int depth = 0;
  const auto whole =
      x3::with<DepthTag>(std::ref(depth))[end | ((declaration[keep] | expression[keep]) > end)];
  const char* first = line.data();
  const char* const last = first + line.size();
  std::size_t failed = 0;
  std::string expected = "a declaration, an assignment or a call";
  try {
    if (x3::phrase_parse(first, last, whole, x3::char_(std::string(kBlanks)))) return statement;
  } catch (const x3::expectation_failure<const char*>& failure) {
    failed = static_cast<std::size_t>(failure.where() - line.data());
    expected = failure.which();
  }
  const std::size_t at = std::min(line.find_first_not_of(kBlanks, failed), line.size());
  return refuse(fmt::format("column {}: expected {}, found {}", at + 1, expected, found(line, at)));
}

bool isConstant(std::string_view name) {
  return constants.find(std::string(name)) != nullptr;
}

}  // namespace cobot_command::tm_script
