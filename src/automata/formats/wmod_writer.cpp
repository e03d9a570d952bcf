#include <algorithm>

#include "formats/format_names.h"
#include "formats/wmod_names.h"
#include <fmt/format.h>
#include <tinyxml2.h>

#include "cobot_command/automata/formats.h"

namespace cobot_command::automata {
namespace {

class Writer {
 public:
  explicit Writer(const Problem& problem) : problem_(problem) {
    for (const Event& event : problem.events) names_.of(event.name);
  }

  std::string write() {
    printer_.PushHeader(false, true);
    printer_.OpenElement("Module");
    printer_.PushAttribute("xmlns", wmod::kNamespace);
    printer_.PushAttribute("Name", problem_.name.c_str());
    writeEvents();
    printer_.OpenElement("ComponentList");
    for (const Automaton& automaton : problem_.automata) writeAutomaton(automaton);
    printer_.CloseElement();
    writeTable(names_);
    printer_.CloseElement();
    return printer_.CStr();
  }

 private:
  void writeEvents() {
    printer_.OpenElement("EventDeclList");
    for (const Event& event : problem_.events) {
      writeEvent(names_.of(event.name), event.controllable ? "CONTROLLABLE" : "UNCONTROLLABLE");
    }
    writeEvent(wmod::kAccepting, "PROPOSITION");
    printer_.CloseElement();
  }

  void writeEvent(const std::string& name, const char* kind) {
    printer_.OpenElement("EventDecl");
    printer_.PushAttribute("Kind", kind);
    printer_.PushAttribute("Name", name.c_str());
    printer_.CloseElement();
  }

  void writeAutomaton(const Automaton& automaton) {
    FormatNames places;
    printer_.OpenElement("SimpleComponent");
    printer_.PushAttribute("Kind", automaton.kind == Automaton::Kind::Plant ? "PLANT" : "SPEC");
    printer_.PushAttribute("Name", names_.of(automaton.name).c_str());
    printer_.OpenElement("Graph");
    printer_.PushAttribute("Deterministic", "true");
    writeBlocked(automaton);
    printer_.OpenElement("NodeList");
    for (StateIndex state = 0; state < automaton.states.size(); ++state) writeState(automaton, state, places);
    printer_.CloseElement();
    printer_.OpenElement("EdgeList");
    for (const Transition& transition : automaton.transitions) {
      printer_.OpenElement("Edge");
      printer_.PushAttribute("Source", places.of(automaton.states[transition.from]).c_str());
      printer_.PushAttribute("Target", places.of(automaton.states[transition.to]).c_str());
      printer_.OpenElement("LabelBlock");
      writeIdentifier(names_.of(problem_.events[transition.event].name));
      printer_.CloseElement();
      printer_.CloseElement();
    }
    printer_.CloseElement();
    printer_.CloseElement();
    writeTable(places);
    printer_.CloseElement();
  }

  /// Events that it has and never makes: WATERS knows the alphabet by the events that are written somewhere.
  void writeBlocked(const Automaton& automaton) {
    std::vector<EventIndex> blocked;
    for (const EventIndex event : automaton.alphabet) {
      const bool is_used =
          std::any_of(automaton.transitions.begin(), automaton.transitions.end(),
                      [&](const Transition& transition) { return transition.event == event; });
      if (!is_used) blocked.push_back(event);
    }
    if (blocked.empty()) return;
    printer_.OpenElement("LabelBlock");
    for (const EventIndex event : blocked) writeIdentifier(names_.of(problem_.events[event].name));
    printer_.CloseElement();
  }

  void writeState(const Automaton& automaton, StateIndex state, FormatNames& places) {
    printer_.OpenElement("SimpleNode");
    if (state == automaton.initial) printer_.PushAttribute("Initial", "true");
    printer_.PushAttribute("Name", places.of(automaton.states[state]).c_str());
    if (std::count(automaton.marked.begin(), automaton.marked.end(), state) != 0) {
      printer_.OpenElement("EventList");
      writeIdentifier(wmod::kAccepting);
      printer_.CloseElement();
    }
    printer_.CloseElement();
  }

  void writeIdentifier(const std::string& name) {
    printer_.OpenElement("SimpleIdentifier");
    printer_.PushAttribute("Name", name.c_str());
    printer_.CloseElement();
  }

  void writeTable(const FormatNames& names) {
    for (const std::string& line : names.table()) {
      printer_.PushComment(fmt::format(" {}{} ", wmod::kMeaning, wmod::toComment(line)).c_str());
    }
  }

  const Problem& problem_;
  FormatNames names_;
  tinyxml2::XMLPrinter printer_;
};

}  // namespace

std::string toWmod(const Problem& problem) {
  return Writer(problem).write();
}

}  // namespace cobot_command::automata
