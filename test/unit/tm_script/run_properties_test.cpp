// Random scripts from the check to the end. A failure prints the seed: RC_PARAMS="seed=..." repeats it.
#include "script_session.h"
#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

namespace cobot_command::tm_script {
namespace {

using Text = std::string;

constexpr const char* kDeclarations =
    "byte b = 200\r\nint i = -7\r\nfloat f = 1.5\r\ndouble d = 0.123456789\r\nbool flag = true\r\nstring s = "
    "\"12\"\r\n"
    "int[] a = {1,2,3}\r\nstring[] t = {\"x\",\"\"}\r\nfloat[] p = {1,2,3,40,50,60}";

Text anyLeaf() {
  return *rc::gen::element<Text>("b", "i", "f", "d", "flag", "s", "a", "t", "p", "0", "1", "2", "300", "1.5",
                                 "1e30", "\"12\"", "\"'i' x\"", "true", "word", "{}", "Robot[0].CoordRobot",
                                 "IO[\"ControlBox\"].DO");
}

Text anyExpression(int depth) {
  if (depth == 0 || *rc::gen::inRange(0, 4) == 0) return anyLeaf();
  const auto inner = [&] { return anyExpression(depth - 1); };
  switch (*rc::gen::inRange(0, 8)) {
    case 0:
      return '(' + inner() +
             *rc::gen::element<Text>("+", "-", "*", "/", "%", "<<", "&", "==", "<", "&&", "||") + inner() +
             ')';
    case 1:
      return *rc::gen::element<Text>("-", "!", "~", "(int)", "(string)", "(float[])", "++") + inner();
    case 2:
      return *rc::gen::element<Text>("a", "t", "p", "IO[0].DO") + '[' + inner() + ']';
    case 3:
      return '(' + inner() + " ? " + inner() + " : " + inner() + ')';
    case 4:
      return '{' + inner() + ',' + inner() + '}';
    case 5:
      return *rc::gen::element<Text>("abs", "Length", "GetString", "GetBytes", "Ctrl", "ValueReverse", "sqrt",
                                     "Array_Reverse", "inversetrans", "String_ToInteger", "WaitQueueTag",
                                     "norm2", "Byte_ToString", "CRC32") +
             '(' + inner() + ')';
    case 6:
      return *rc::gen::element<Text>("Array_Append", "trans", "String_Split", "Array_SubElements", "pow",
                                     "GetString", "String_IndexOf", "Array_IndexOf", "ListenSend",
                                     "Byte_Concat") +
             '(' + inner() + ',' + inner() + ')';
    default:
      return '(' + *rc::gen::element<Text>("i", "f", "s", "a", "a[1]", "IO[0].DO[3]") +
             *rc::gen::element<Text>("=", "+=", "-=", "<<=") + inner() + ')';
  }
}

Text anyStatement(int number) {
  const Text value = anyExpression(3);
  switch (*rc::gen::inRange(0, 3)) {
    case 0:
      return *rc::gen::element<Text>("int", "string", "float", "byte[]", "float[]") + " v" +
             std::to_string(number) + " = " + value;
    case 1:
      return *rc::gen::element<Text>("i", "s", "f", "a", "p", "t[0]", "IO[1].DO[15]") +
             *rc::gen::element<Text>(" = ", " += ") + value;
    default:
      return "ListenSend(90, " + value + ')';
  }
}

RC_GTEST_PROP(ScriptRunProperty, ofWhatTheCheckPassedEndsWithoutSurprise, ()) {
  Session session;
  RC_ASSERT(session.run(kDeclarations) == "OK");
  for (int number = 0; number < 20; ++number) {
    const Text statement = anyStatement(number);
    const Findings findings = session.check(statement);
    if (!findings.errors.empty()) continue;
    const Text before = session.variable("i") + session.variable("s") + session.variable("a");
    Interpreter script = session.start(statement);
    for (int waits = 0; script.run(1) == Progress::Waiting && waits < 100; ++waits) script.resume(Scalar(1));
    RC_ASSERT(script.progress() == Progress::Done || script.progress() == Progress::Failed);
    if (script.progress() == Progress::Done) continue;
    RC_ASSERT(!script.fault()->reason.empty());
    RC_ASSERT(session.variable("i") + session.variable("s") + session.variable("a") == before);
  }
}

RC_GTEST_PROP(ScriptRunProperty, isTheSameWithAndWithoutWaits, (int first, int second)) {
  const Text script = "int n = 5\r\nint r = n++ * WaitQueueTag(1) + n++ * WaitQueueTag(2) + n";
  Session waiting;
  Interpreter interpreter = waiting.start(script);
  RC_ASSERT(interpreter.run(10) == Progress::Waiting);
  interpreter.resume(Scalar(first));
  RC_ASSERT(interpreter.run(10) == Progress::Waiting);
  interpreter.resume(Scalar(second));
  RC_ASSERT(interpreter.run(10) == Progress::Done);
  Session straight;
  straight.locals.set("x", Scalar(first));
  straight.locals.set("y", Scalar(second));
  RC_ASSERT(straight.run("int n = 5\r\nint r = n++ * x + n++ * y + n") == "OK");
  RC_ASSERT(waiting.variable("r") == straight.variable("r"));
}

}  // namespace
}  // namespace cobot_command::tm_script
