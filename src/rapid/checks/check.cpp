#include "cobot_command/rapid/checks/check.h"

#include <algorithm>
#include <utility>

#include "linking/linker.h"
#include "predefined_draft.h"
#include "routines/routine_check.h"

namespace cobot_command::rapid {

namespace {

void addSignals(Draft& draft, const std::vector<Signal>& signals) {
  draft.parts.signals = std::make_shared<const std::vector<Signal>>(signals);
  for (std::uint32_t i = 0; i < draft.parts.signals->size(); ++i) {
    const Signal& signal = (*draft.parts.signals)[i];
    Symbol symbol;
    symbol.kind = SymbolKind::Signal;
    symbol.type = typeOf(signal.type);
    symbol.index = i;
    symbol.name = signal.name;
    const SymbolIndex added = draft.add(symbol);
    draft.parts.names.predefined.emplace(signal.folded, added);
  }
}

void addFiles(Draft& draft, const std::vector<CheckedFile>& files) {
  for (const CheckedFile& file : files) {
    draft.parts.files.push_back({file.source, std::vector<Meaning>(file.source->tree().size())});
    draft.file_names.push_back(file.name);
    Findings& findings = draft.findings.emplace_back();
    for (const Finding& finding : file.source->findings()) findings.add(finding);
  }
}

void checkRoutines(Draft& draft, LinkedFiles& files) {
  for (const LinkedModule& module : files.modules) {
    FileDraft& file = files.file(module.file);
    RoutineCheck routines(file, files.namesOf(module.file));
    for (const NodeIndex node : file.tree().children(module.node)) {
      const SymbolIndex symbol = file.at(node).symbol;
      if (symbol != kNoSymbol && draft.symbol(symbol).isRoutine()) routines.check(symbol);
    }
  }
}

bool hasError(const std::vector<std::vector<Finding>>& files) {
  return std::any_of(files.begin(), files.end(), [](const std::vector<Finding>& findings) {
    return std::any_of(findings.begin(), findings.end(),
                       [](const Finding& finding) { return finding.severity() == Severity::Error; });
  });
}

}  // namespace

CheckedProgram check(const std::vector<CheckedFile>& files, const CheckOptions& options) {
  Draft draft = predefinedDraft();
  draft.is_library = options.is_library;
  draft.dialect = files.empty() ? Dialect::Irc5 : files.front().source->dialect();
  for (const std::string& name : options.skipped) draft.skipped.emplace(folded(name), false);
  addSignals(draft, options.signals);
  addFiles(draft, files);
  LinkedFiles linked = link(draft, kPredefinedFiles);
  checkRoutines(draft, linked);
  CheckedProgram checked;
  checked.steps = draft.steps;
  for (std::size_t file = kPredefinedFiles; file < draft.findings.size(); ++file) {
    checked.findings.push_back(draft.findings[file].take());
  }
  checked.draft = std::make_shared<const Program>(std::move(draft.parts));
  if (!hasError(checked.findings)) checked.program = checked.draft;
  return checked;
}

}  // namespace cobot_command::rapid
