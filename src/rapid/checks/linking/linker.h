// Declares what the modules of a draft have: names first, then types, routines, and data with their values.
#pragma once

#include <vector>

#include "draft.h"
#include "names.h"

namespace cobot_command::rapid {

/// One module, while it is linked.
struct LinkedModule {
  SymbolIndex symbol = kNoSymbol;
  FileIndex file = 0;
  NodeIndex node = kNoNode;
  bool is_system = false;
};

/// The files of a draft that are linked together. Their Names are made once.
struct LinkedFiles {
  FileIndex first = 0;
  std::vector<FileDraft> files;
  std::vector<Names> names;  ///< of each file
  std::vector<LinkedModule> modules;

  [[nodiscard]] FileDraft& file(FileIndex file) { return files[file - first]; }
  [[nodiscard]] Names& namesOf(FileIndex file) { return names[file - first]; }
};

/// Declares the names of all modules; reports E301 to E304, E327.
void declareNames(Draft& draft, LinkedFiles& files);
/// Gives each record its components, each alias its type; reports E310, E314 to E316.
void declareTypes(Draft& draft, LinkedFiles& files);
/// Gives each routine its result and parameters; reports E301 of them, E309, E310, E314, E317, W319.
void declareRoutines(Draft& draft, LinkedFiles& files);
/// Gives the data of modules their types and values, each after those that it names.
void declareModuleData(Draft& draft, LinkedFiles& files);

/// Links the files from `first` on, in this order. Bodies of routines are not checked.
[[nodiscard]] LinkedFiles link(Draft& draft, FileIndex first);

}  // namespace cobot_command::rapid
