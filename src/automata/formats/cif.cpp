#include "formats/format_names.h"
#include <fmt/format.h>

#include "cobot_command/automata/formats.h"

namespace cobot_command::automata {
namespace {

/// Words of CIF 3 that could stand where a name does.
const std::set<std::string>& reservedWords() {
  static const std::set<std::string> words = {"alg",
                                              "alphabet",
                                              "and",
                                              "any",
                                              "automaton",
                                              "bool",
                                              "break",
                                              "case",
                                              "const",
                                              "cont",
                                              "continue",
                                              "controllable",
                                              "def",
                                              "der",
                                              "dict",
                                              "disables",
                                              "disc",
                                              "dist",
                                              "do",
                                              "edge",
                                              "elif",
                                              "else",
                                              "end",
                                              "enum",
                                              "equation",
                                              "event",
                                              "exp",
                                              "false",
                                              "file",
                                              "final",
                                              "for",
                                              "func",
                                              "goto",
                                              "group",
                                              "if",
                                              "import",
                                              "in",
                                              "initial",
                                              "input",
                                              "int",
                                              "invariant",
                                              "list",
                                              "location",
                                              "marked",
                                              "monitor",
                                              "namespace",
                                              "needs",
                                              "not",
                                              "now",
                                              "once",
                                              "or",
                                              "plant",
                                              "post",
                                              "pre",
                                              "print",
                                              "printfile",
                                              "real",
                                              "requirement",
                                              "return",
                                              "sample",
                                              "self",
                                              "set",
                                              "string",
                                              "sub",
                                              "supervisor",
                                              "svgcopy",
                                              "svgfile",
                                              "svgin",
                                              "svgmove",
                                              "svgout",
                                              "switch",
                                              "tau",
                                              "text",
                                              "time",
                                              "to",
                                              "true",
                                              "tuple",
                                              "type",
                                              "uncontrollable",
                                              "urgent",
                                              "value",
                                              "void",
                                              "when",
                                              "while"};
  return words;
}

std::string automatonText(const Automaton& automaton, const Problem& problem, FormatNames& names) {
  FormatNames places(reservedWords());
  std::string text =
      fmt::format("\n{} {}:\n", automaton.kind == Automaton::Kind::Plant ? "plant" : "requirement",
                  names.of(automaton.name));
  std::vector<std::string> alphabet;
  for (const EventIndex event : automaton.alphabet) alphabet.push_back(names.of(problem.events[event].name));
  if (!alphabet.empty()) text += fmt::format("  alphabet {};\n", fmt::join(alphabet, ", "));
  for (StateIndex state = 0; state < automaton.states.size(); ++state) {
    std::string body;
    if (state == automaton.initial) body += "    initial;\n";
    for (const StateIndex marked : automaton.marked) {
      if (marked == state) body += "    marked;\n";
    }
    for (const Transition& transition : automaton.transitions) {
      if (transition.from != state) continue;
      body += fmt::format("    edge {} goto {};\n", names.of(problem.events[transition.event].name),
                          places.of(automaton.states[transition.to]));
    }
    text += fmt::format("  location {}{}\n", places.of(automaton.states[state]), body.empty() ? ";" : ":");
    text += body;
  }
  for (const std::string& line : places.table()) text += fmt::format("  // {}\n", line);
  return text + "end\n";
}

}  // namespace

std::string toCif(const Problem& problem) {
  FormatNames names(reservedWords());
  std::string events;
  for (const Event& event : problem.events) {
    events +=
        fmt::format("{} {};\n", event.controllable ? "controllable" : "uncontrollable", names.of(event.name));
  }
  std::string automata;
  for (const Automaton& automaton : problem.automata) automata += automatonText(automaton, problem, names);
  std::string head = fmt::format("// {}\n", problem.name);
  for (const std::string& line : names.table()) head += fmt::format("// {}\n", line);
  return head + events + automata;
}

}  // namespace cobot_command::automata
