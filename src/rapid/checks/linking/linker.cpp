#include "linking/linker.h"

namespace cobot_command::rapid {

LinkedFiles link(Draft& draft, FileIndex first) {
  LinkedFiles files;
  files.first = first;
  const auto count = static_cast<FileIndex>(draft.parts.files.size());
  files.files.reserve(count - first);  // Names refer to them
  for (FileIndex file = first; file < count; ++file) {
    FileDraft& added = files.files.emplace_back(draft, file);
    files.names.emplace_back(added);
  }
  declareNames(draft, files);
  declareTypes(draft, files);
  declareRoutines(draft, files);
  declareModuleData(draft, files);
  return files;
}

}  // namespace cobot_command::rapid
