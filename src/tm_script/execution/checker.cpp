#include "cobot_command/tm_script/checker.h"

#include <algorithm>
#include <map>

#include "execution/typing.h"
#include <fmt/format.h>

#include "cobot_command/common/overloaded.h"

namespace cobot_command::tm_script {

namespace {

/// Does a line of only this do anything?
bool doesSomething(const Expression& expression) {
  if (const auto* prefix = std::get_if<Prefix>(&expression.node)) {
    const auto* step = std::get_if<PrefixOperator>(&prefix->steps.front());
    return step && (*step == PrefixOperator::Increment || *step == PrefixOperator::Decrement);
  }
  return std::holds_alternative<Call>(expression.node) || std::holds_alternative<Postfix>(expression.node) ||
         std::holds_alternative<Assignment>(expression.node);
}

class Checker {
 public:
  Checker(const FunctionTable& functions, const Scope& scope, const Environment& environment)
      : scope_(scope),
        typing_(functions, environment, [this](const std::string& name) { return typeOf(name); }) {}

  void check(const Statement& statement) {
    const auto error =
        std::visit([this](const auto& content) { return errorOf(content); }, statement.content);
    if (error) findings_.errors.push_back(faultOf(statement.line, *error));
    for (const std::string& warning : typing_.takeWarnings()) {
      findings_.warnings.push_back(faultOf(statement.line, warning));
    }
  }

  Findings findings() && { return std::move(findings_); }

 private:
  [[nodiscard]] std::optional<Type> typeOf(const std::string& name) const {
    const auto declared = declared_.find(name);
    if (declared != declared_.end()) return declared->second;
    const Value* value = scope_.locals.find(name);
    if (!value) value = scope_.project.find(name);
    return value ? std::optional<Type>(tm_script::typeOf(*value)) : std::nullopt;
  }

  std::optional<std::string> errorOf(const Declaration& declaration) {
    if (typeOf(declaration.name)) return fmt::format("there is a variable {} already", declaration.name);
    auto error = declaration.initial ? typing_.accept(*declaration.initial, declaration.type) : std::nullopt;
    if (!error) declared_[declaration.name] = declaration.type;
    return error;
  }

  std::optional<std::string> errorOf(const Expression& expression) {
    const auto type = typing_.typeOf(expression);
    if (!type) return type.error();
    if (!doesSomething(expression)) return fmt::format("{} does nothing", toText(expression));
    return std::nullopt;
  }

  const Scope& scope_;
  std::map<std::string, Type> declared_;
  Typing typing_;
  Findings findings_;
};

}  // namespace

Findings check(const ParsedScript& script, const FunctionTable& functions, const Scope& scope,
               const Environment& environment) {
  Checker checker(functions, scope, environment);
  for (const Statement& statement : script.statements) checker.check(statement);
  Findings findings = std::move(checker).findings();
  findings.errors.insert(findings.errors.end(), script.faults.begin(), script.faults.end());
  std::stable_sort(findings.errors.begin(), findings.errors.end(),
                   [](const Fault& a, const Fault& b) { return a.line < b.line; });
  return findings;
}

}  // namespace cobot_command::tm_script
