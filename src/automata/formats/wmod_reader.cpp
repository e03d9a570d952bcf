#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "formats/wmod_names.h"
#include <fmt/format.h>
#include <tinyxml2.h>

#include "cobot_command/automata/formats.h"
#include "cobot_command/common/foreign_text.h"

namespace cobot_command::automata {
namespace {

using tinyxml2::XMLElement;

/// Thrown and caught inside of this file.
struct Fault {
  std::string text;
};

template <class... Values>
[[noreturn]] void fail(const XMLElement& element, fmt::format_string<Values...> text, Values&&... values) {
  throw Fault{forPeople(
      fmt::format("line {}: {}", element.GetLineNum(), fmt::format(text, std::forward<Values>(values)...)))};
}

std::string attribute(const XMLElement& element, const char* name) {
  const char* value = element.Attribute(name);
  if (value == nullptr) fail(element, "<{}> has no {}", element.Name(), name);
  return value;
}

/// Where things are drawn, and what people have written beside them.
bool isForPeople(std::string_view name) {
  constexpr std::string_view kGeometry = "Geometry";
  // Comments have a namespace of their own, under whatever prefix.
  return name.substr(name.find(':') + 1) == "Comment" ||
         (name.size() >= kGeometry.size() && name.substr(name.size() - kGeometry.size()) == kGeometry);
}

/// Calls for each child but those for people; refuses others than those named.
template <class Visitor>
void forEachChild(const XMLElement& parent, std::initializer_list<std::string_view> known,
                  const Visitor& visit) {
  for (const auto* child = parent.FirstChildElement(); child != nullptr;
       child = child->NextSiblingElement()) {
    if (isForPeople(child->Name())) continue;
    const bool is_known = std::find(known.begin(), known.end(), child->Name()) != known.end();
    if (!is_known) {
      fail(*child,
           "<{}> in <{}> is not supported, because only plain automata are read: make a module without it",
           foreignText(child->Name(), kQuoteLimit), parent.Name());
    }
    visit(*child);
  }
}

/// What names mean by the comments of our own files; of others, there are none.
std::map<std::string, std::string> meaningsIn(const XMLElement& element) {
  std::map<std::string, std::string> meanings;
  for (const auto* node = element.FirstChild(); node != nullptr; node = node->NextSibling()) {
    if (node->ToComment() == nullptr) continue;
    const std::string text = wmod::fromComment(node->Value());
    const std::string begin = std::string(" ") + wmod::kMeaning;
    const auto middle = text.find(" = ");
    if (text.compare(0, begin.size(), begin) != 0 || middle == std::string::npos) continue;
    meanings[text.substr(begin.size(), middle - begin.size())] =
        text.substr(middle + 3, text.size() - middle - 4);
  }
  return meanings;
}

void giveMeaning(std::string& name, const std::map<std::string, std::string>& meanings) {
  const auto at = meanings.find(name);
  if (at != meanings.end()) name = at->second;
}

class Reader {
 public:
  Problem read(const XMLElement& module) {
    if (const char* name = module.Attribute("Name")) problem_.name = name;
    forEachChild(module, {"EventDeclList", "ComponentList"}, [&](const XMLElement& child) {
      const std::string_view kind = child.Name();
      if (kind == "EventDeclList") {
        forEachChild(child, {"EventDecl"}, [&](const XMLElement& event) { readEvent(event); });
      } else if (kind == "ComponentList") {
        forEachChild(child, {"SimpleComponent"},
                     [&](const XMLElement& component) { readAutomaton(component); });
      }
    });
    const auto meanings = meaningsIn(module);
    for (Event& event : problem_.events) giveMeaning(event.name, meanings);
    for (Automaton& automaton : problem_.automata) giveMeaning(automaton.name, meanings);
    return std::move(problem_);
  }

 private:
  void readEvent(const XMLElement& element) {
    const std::string kind = attribute(element, "Kind");
    const std::string name = attribute(element, "Name");
    if (element.FirstChildElement("RangeList") != nullptr) {
      fail(element, "the event \"{}\" has an index: this is not supported", name);
    }
    if (kind == "PROPOSITION") return;
    if (kind != "CONTROLLABLE" && kind != "UNCONTROLLABLE") {
      fail(element, "an event is {}: allowed are CONTROLLABLE, UNCONTROLLABLE and PROPOSITION",
           foreignText(kind, kQuoteLimit));
    }
    if (!events_.emplace(name, static_cast<EventIndex>(problem_.events.size())).second) {
      fail(element, "the event \"{}\" appears twice", foreignText(name, kQuoteLimit));
    }
    problem_.events.push_back({name, kind == "CONTROLLABLE"});
  }

  void readAutomaton(const XMLElement& element) {
    Automaton automaton;
    automaton.name = attribute(element, "Name");
    const std::string kind = attribute(element, "Kind");
    // What a supervisor forbids is what a spec forbids.
    if (kind != "PLANT" && kind != "SPEC" && kind != "SUPERVISOR") {
      fail(element, "an automaton is {}: allowed are PLANT, SPEC and SUPERVISOR",
           foreignText(kind, kQuoteLimit));
    }
    automaton.kind = kind == "PLANT" ? Automaton::Kind::Plant : Automaton::Kind::Spec;
    const auto* graph = element.FirstChildElement("Graph");
    if (graph == nullptr) fail(element, "<SimpleComponent> has no <Graph>");
    std::map<std::string, StateIndex> states;
    bool has_initial = false;
    forEachChild(*graph, {"LabelBlock", "NodeList", "EdgeList"}, [&](const XMLElement& part) {
      const std::string_view name = part.Name();
      if (name == "NodeList") {
        forEachChild(part, {"SimpleNode"},
                     [&](const XMLElement& node) { readState(node, automaton, states, has_initial); });
      } else if (name == "EdgeList") {
        forEachChild(part, {"Edge"}, [&](const XMLElement& edge) { readEdge(edge, automaton, states); });
      } else {
        forEachChild(part, {"SimpleIdentifier"}, [&](const XMLElement& event) {
          if (attribute(event, "Name") != wmod::kAccepting) addToAlphabet(automaton, eventOf(event));
        });
      }
    });
    if (!has_initial) fail(element, "{} has no initial state", automaton.name);
    if (automaton.marked.empty()) {
      for (StateIndex state = 0; state < automaton.states.size(); ++state) automaton.marked.push_back(state);
    }
    const auto meanings = meaningsIn(element);
    for (std::string& state : automaton.states) giveMeaning(state, meanings);
    problem_.automata.push_back(std::move(automaton));
  }

  static void readState(const XMLElement& element, Automaton& automaton,
                        std::map<std::string, StateIndex>& states, bool& has_initial) {
    const auto index = static_cast<StateIndex>(automaton.states.size());
    const std::string name = attribute(element, "Name");
    if (!states.emplace(name, index).second) fail(element, "the state \"{}\" appears twice", name);
    automaton.states.push_back(name);
    if (element.BoolAttribute("Initial")) {
      if (has_initial) fail(element, "{} has several initial states", automaton.name);
      has_initial = true;
      automaton.initial = index;
    }
    const auto* propositions = element.FirstChildElement("EventList");
    if (propositions == nullptr) return;
    forEachChild(*propositions, {"SimpleIdentifier"}, [&](const XMLElement& proposition) {
      if (attribute(proposition, "Name") == wmod::kAccepting) automaton.marked.push_back(index);
    });
  }

  void readEdge(const XMLElement& element, Automaton& automaton,
                const std::map<std::string, StateIndex>& states) {
    const StateIndex from = stateOf(element, "Source", states);
    const StateIndex to = stateOf(element, "Target", states);
    forEachChild(element, {"LabelBlock"}, [&](const XMLElement& part) {
      forEachChild(part, {"SimpleIdentifier"}, [&](const XMLElement& identifier) {
        const EventIndex event = eventOf(identifier);
        addToAlphabet(automaton, event);
        automaton.transitions.push_back({from, event, to});
      });
    });
  }

  static StateIndex stateOf(const XMLElement& edge, const char* end,
                            const std::map<std::string, StateIndex>& states) {
    const std::string name = attribute(edge, end);
    const auto at = states.find(name);
    if (at == states.end()) fail(edge, "there is no state \"{}\"", foreignText(name, kQuoteLimit));
    return at->second;
  }

  [[nodiscard]] EventIndex eventOf(const XMLElement& identifier) const {
    const std::string name = attribute(identifier, "Name");
    const auto at = events_.find(name);
    if (at == events_.end()) fail(identifier, "there is no event \"{}\"", foreignText(name, kQuoteLimit));
    return at->second;
  }

  static void addToAlphabet(Automaton& automaton, EventIndex event) {
    if (std::find(automaton.alphabet.begin(), automaton.alphabet.end(), event) == automaton.alphabet.end()) {
      automaton.alphabet.push_back(event);
    }
  }

  Problem problem_;
  std::map<std::string, EventIndex> events_;
};

}  // namespace

Result<Problem, std::string> problemFromWmod(std::string_view text) {
  tinyxml2::XMLDocument document;
  if (document.Parse(text.data(), text.size()) != tinyxml2::XML_SUCCESS) {
    return refuse(forPeople(fmt::format("this is not XML: {}", document.ErrorStr())));
  }
  const auto* module = document.FirstChildElement("Module");
  if (module == nullptr) return refuse(std::string("this is not a module of WATERS: it has no <Module>"));
  try {
    Problem problem = Reader().read(*module);
    const auto faults = faultsOf(problem);
    if (!faults.empty()) return refuse(faults.front());
    return problem;
  } catch (const Fault& fault) {
    return refuse(fault.text);
  }
}

}  // namespace cobot_command::automata
