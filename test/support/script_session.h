// A robot for scripts: attributes in a map, calls in a list.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "cobot_command/tm_script/checker.h"
#include "cobot_command/tm_script/interpreter.h"

namespace cobot_command::tm_script {

inline std::string linesOf(const std::vector<Fault>& faults) {
  std::string text;
  int last = 0;
  for (const Fault& fault : faults) {
    if (std::exchange(last, fault.line) != fault.line) text += ';' + std::to_string(fault.line);
  }
  return text;
}

/// The controller's reply without its id: "OK", "OK;2;3", or "ERROR;1;3", where errors hide warnings.
inline std::string replyOf(const Findings& findings) {
  return findings.errors.empty() ? "OK" + linesOf(findings.warnings) : "ERROR" + linesOf(findings.errors);
}

class FakeRobot : public Environment {
 public:
  struct AttributeState {
    AttributeShape shape;
    Value value;
  };

  FakeRobot() {
    const Array outputs{ScalarType::Byte, std::vector<Scalar>(16, std::uint8_t{0})};
    attributes["IO.DO"] = {{{ScalarType::Byte, true}, true, 16}, outputs};
    attributes["IO.DI"] = {{{ScalarType::Byte, true}, false, 16}, outputs};
    attributes["Robot.CoordRobot"] = {
        {{ScalarType::Float, true}, false, 6},
        Array{ScalarType::Float, {417.5F, -122.25F, 343.9F, 180.0F, 0.0F, 90.0F}}};
    attributes["Point.Value"] = {{{ScalarType::Float, true}, true, 6},
                                 Array{ScalarType::Float, std::vector<Scalar>(6, 0.0F)}};
    attributes["TCP.Mass"] = {{{ScalarType::Float}, true, std::nullopt}, Scalar(0.0F)};
  }

  Result<AttributeShape, std::string> shapeOf(const std::string& object,
                                              const std::vector<std::optional<Scalar>>& keys,
                                              const std::string& name) const override {
    const auto found = attributes.find(object + '.' + name);
    if (found == attributes.end()) return refuse("there is no " + object + '.' + name);
    if (keys[0] && *keys[0] == Scalar(std::string("Nowhere"))) {
      return refuse(std::string("there is no Nowhere"));
    }
    return found->second.shape;
  }

  [[nodiscard]] std::optional<std::string> objectionTo(
      const std::string& function, const std::vector<std::optional<Scalar>>& arguments) const override {
    if (function != "QueueTag" || arguments[0] != Scalar(std::uint8_t{16})) return std::nullopt;
    return "there is no tag 16";
  }

  Result<Value, std::string> read(const AttributeName& attribute) override {
    ++reads;
    return attributes.at(attribute.object + '.' + attribute.name).value;
  }

  std::optional<std::string> write(const AttributeName& attribute, std::optional<std::size_t> index,
                                   const Value& value) override {
    Value& whole = attributes.at(attribute.object + '.' + attribute.name).value;
    if (index) {
      std::get<Array>(whole).items[*index] = std::get<Scalar>(value);
    } else {
      whole = value;
    }
    calls.push_back(textOf(attribute.keys[0]) + '.' + attribute.name + " = " + textOf(value));
    return std::nullopt;
  }

  CallAnswer call(const std::string& function, const Arguments& arguments) override {
    std::string text = function + '(';
    for (std::size_t i = 0; i < arguments.size(); ++i) text += (i > 0 ? "," : "") + textOf(arguments[i]);
    calls.push_back(text + ')');
    if (function == "WaitQueueTag") return Wait{};
    if (function == "ScriptExit") return EndScript{Scalar(true)};
    if (function == "ChangeLoad") return CallFailure{"the load is too heavy"};
    if (function == "ListenSend") return Value(Scalar(0));
    return Value(Scalar(true));
  }

  std::map<std::string, AttributeState> attributes;
  std::vector<std::string> calls;
  int reads = 0;
};

/// The functions that FakeRobot answers, beside the general ones.
inline FunctionTable functionsOf(Version tmflow) {
  FunctionTable table(tmflow);
  table.declare("bool PTP(string, float[6], int, int, int, bool)", {1, 68});
  table.declare("bool PTP(string, float[6], int, int, int, bool, int[3])", {1, 68});
  table.declare("bool PTP(string, 6 float, int, int, int, bool)", {1, 68});
  table.declare("bool PTP(string, 6 float, int, int, int, bool, 3 int)", {1, 68});
  table.declare("bool ChangeBase(string)", {1, 68});
  table.declare("bool ChangeBase(float[6])", {1, 68});
  table.declare("bool ChangeBase(6 float)", {1, 68});
  table.declare("bool ChangeLoad(float)", {1, 68});
  table.declare("bool ScriptExit()", {1, 68});
  table.declare("bool QueueTag(int, int?)", {1, 76});
  table.declare("int WaitQueueTag(int, int?)", {1, 76});
  table.declare("int ListenSend(int, any)", {1, 76});
  table.declare("int ListenSend(int, any[])", {1, 76});
  table.declare("bool StopAndClearBuffer(literal int)", {1, 82});
  table.declare("bool StopAndClearBuffer()", {1, 72});
  return table;
}

/// A Listen node: scripts one behind the other.
class Session {
 public:
  explicit Session(Version tmflow = {1, 80}) : functions(functionsOf(tmflow)) {}

  [[nodiscard]] Findings check(std::string_view text) {
    return tm_script::check(parse(text), functions, scope(), robot);
  }
  [[nodiscard]] Interpreter start(std::string_view text) {
    return Interpreter(parse(text).statements, functions, scope(), robot);
  }
  /// The controller's reply, and what the script then did.
  std::string run(std::string_view text) {
    const Findings findings = check(text);
    if (!findings.errors.empty()) return replyOf(findings);
    Interpreter interpreter = start(text);
    interpreter.run(1000000);
    if (interpreter.fault()) {
      return "line " + std::to_string(interpreter.fault()->line) + ": " + interpreter.fault()->reason;
    }
    return replyOf(findings);
  }
  /// The first error of a script, or how it failed.
  std::string errorOf(std::string_view text) {
    const Findings findings = check(text);
    return findings.errors.empty() ? run(text) : findings.errors.front().reason;
  }
  [[nodiscard]] std::string variable(std::string_view name) const {
    const Value* value = locals.find(name);
    return value ? toText(typeOf(*value)) + ' ' + textOf(*value) : "none";
  }
  /// What an expression gives, when a variable takes it.
  std::string valueOf(const std::string& type, const std::string& expression) {
    locals.clear();
    const std::string reply = run(type + " v = " + expression);
    return reply.substr(0, 2) == "OK" ? textOf(*locals.find("v")) : errorOf(type + " v = " + expression);
  }
  [[nodiscard]] Scope scope() { return {locals, project}; }

  Variables locals;
  Variables project;
  FakeRobot robot;
  FunctionTable functions;
};

}  // namespace cobot_command::tm_script
