#include "printer/speller.h"

#include <algorithm>
#include <array>
#include <utility>

#include "printer/declarations.h"

namespace cobot_command::rapid {

namespace {

class Speller {
 public:
  Speller(const Source& source, const PredefinedNames& predefined)
      : source_(source), tree_(source.tree()), declarations_(source, predefined) {}

  std::vector<Spelling> run() {
    for (const NodeIndex child : tree_.children(Tree::kRoot)) {
      tree_[child].kind == NodeKind::Header ? header(child) : module(child);
    }
    std::sort(spellings_.begin(), spellings_.end(),
              [](const Spelling& left, const Spelling& right) { return left.token < right.token; });
    return std::move(spellings_);
  }

 private:
  void spell(TokenIndex token, std::string_view text) {
    if (!text.empty() && text != source_.textOf(token)) spellings_.push_back({token, text});
  }
  void spell(TokenIndex token, const DeclaredName& declared) { spell(token, declared.written); }

  void header(NodeIndex node) {
    static constexpr std::array<std::string_view, 5> kWords{"VERSION", "LANGUAGE", "ENGLISH", "GERMAN",
                                                            "FRENCH"};
    for (TokenIndex token = tree_[node].first; token <= tree_[node].last; ++token) {
      const std::string word = folded(source_.textOf(token));
      const auto* const found = std::find_if(kWords.begin(), kWords.end(),
                                             [&](std::string_view known) { return folded(known) == word; });
      if (found != kWords.end()) spell(token, *found);
    }
  }

  void module(NodeIndex node) {
    declarations_.enterModule(node);
    for (const NodeIndex child : tree_.children(node)) {
      if (tree_[child].kind == NodeKind::Routine) declarations_.enterRoutine(child);
      walk(child);
    }
  }

  void walk(NodeIndex node) {
    switch (tree_[node].kind) {
      case NodeKind::TypeName:
        return spell(tree_[node].name, declarations_.findType(tree_[node].name));
      case NodeKind::Goto:
        return spell(tree_[node].name, declarations_.findLabel(tree_[node].name));
      case NodeKind::Connect:
        spell(tree_[node].name, declarations_.find(tree_[node].name));
        return children(node);
      case NodeKind::Call:
      case NodeKind::Function:
        return call(node);
      case NodeKind::Reference:
        return reference(node);
      case NodeKind::For:
        return loop(node);
      default:
        return children(node);
    }
  }

  void children(NodeIndex node) {
    for (const NodeIndex child : tree_.children(node)) walk(child);
  }

  void call(NodeIndex node) {
    const DeclaredName routine = declarations_.find(tree_[node].name);
    spell(tree_[node].name, routine);
    for (const NodeIndex child : tree_.children(node)) {
      if (tree_[child].kind == NodeKind::Argument) {
        spell(tree_[child].name, declarations_.findPart(routine, tree_[child].name));
      }
      walk(child);
    }
  }

  void reference(NodeIndex node) {
    DeclaredName whole = declarations_.find(tree_[node].name);
    spell(tree_[node].name, whole);
    for (const NodeIndex selector : tree_.children(node)) {
      if (tree_[selector].kind == NodeKind::Part) {
        const TokenIndex name = tree_[selector].name;
        whole = declarations_.findPart(declarations_.recordOf(whole), name);
        spell(name, whole);
      } else {
        children(selector);
      }
    }
  }

  /// The counter hides its name in the list only.
  void loop(NodeIndex node) {
    for (const NodeIndex child : tree_.children(node)) {
      const bool is_list = tree_[child].kind == NodeKind::List;
      const NodeIndex hidden = is_list ? declarations_.enterFor(node) : kNoNode;
      walk(child);
      if (is_list) declarations_.leaveFor(node, hidden);
    }
  }

  const Source& source_;
  const Tree& tree_;
  Declarations declarations_;
  std::vector<Spelling> spellings_;
};

}  // namespace

std::vector<Spelling> spellingsOf(const Source& source, const PredefinedNames& predefined) {
  return Speller(source, predefined).run();
}

}  // namespace cobot_command::rapid
