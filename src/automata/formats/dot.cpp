#include <algorithm>

#include <fmt/format.h>

#include "cobot_command/automata/formats.h"

namespace cobot_command::automata {
namespace {

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c == '\n' ? ' ' : c;
  }
  return result + '"';
}

}  // namespace

std::string toDot(const Problem& problem) {
  std::string text;
  for (const Automaton& automaton : problem.automata) {
    text += fmt::format("digraph {} {{\n  rankdir=LR;\n  begin [shape=point];\n", quoted(automaton.name));
    for (StateIndex state = 0; state < automaton.states.size(); ++state) {
      const bool marked = std::count(automaton.marked.begin(), automaton.marked.end(), state) != 0;
      text += fmt::format("  s{} [label={}, shape={}];\n", state, quoted(automaton.states[state]),
                          marked ? "doublecircle" : "circle");
    }
    text += fmt::format("  begin -> s{};\n", automaton.initial);
    for (const Transition& transition : automaton.transitions) {
      const Event& event = problem.events[transition.event];
      text += fmt::format("  s{} -> s{} [label={}{}];\n", transition.from, transition.to, quoted(event.name),
                          event.controllable ? "" : ", style=dashed");
    }
    text += "}\n";
  }
  return text;
}

}  // namespace cobot_command::automata
