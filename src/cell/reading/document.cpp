#include "reading/document.h"

#include <algorithm>
#include <sstream>
#include <string_view>

#include <fmt/format.h>
#include <yaml-cpp/anchor.h>
#include <yaml-cpp/emitterstyle.h>
#include <yaml-cpp/eventhandler.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::cell {

namespace {

/// Notes where a document begins, and passes over what stands in it.
class DocumentStart : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark& mark) override { mark_ = mark; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override {}
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t, const std::string&) override {}
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {}
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t, YAML::EmitterStyle::value) override {
  }
  void OnMapEnd() override {}
  [[nodiscard]] const YAML::Mark& mark() const { return mark_; }

 private:
  YAML::Mark mark_;
};

}  // namespace

void checkText(const std::string& text, FaultList& faults) {
  if (text.size() > kMostBytes) {
    faults.add({faults.file(), 0, 0}, "",
               {"", fmt::format("has {} bytes", text.size()), fmt::format("at most {}", kMostBytes), ""});
    return;
  }
  int line = 1;
  for (std::size_t begin = 0; begin <= text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view row = std::string_view(text).substr(begin, end - begin);
    const auto strange =
        std::find_if(row.begin(), row.end(), [](char c) { return isControl(c) && c != '\t' && c != '\r'; });
    if (strange != row.end() || !isUtf8(row)) {
      const int column = strange == row.end() ? 1 : static_cast<int>(strange - row.begin()) + 1;
      faults.add({faults.file(), line, column}, "",
                 {"", strange == row.end() ? "is not UTF-8 in this line" : "has a control character",
                  "UTF-8 without control characters", "write the line again"});
      return;
    }
    begin = end + 1;
  }
}

YAML::Node documentIn(const std::string& text) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  DocumentStart start;
  if (parser.HandleNextDocument(start) && parser.HandleNextDocument(start)) {
    refuseAt(start.mark(), {"", "has a second document", "one document, without --- inside",
                            "remove the line with --- or ..."});
  }
  return YAML::Load(text);
}

}  // namespace cobot_command::cell
