#include "checks/fault_list.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::cell {

namespace {

constexpr std::size_t kMostFaults = 100;

auto wordsOf(const Fault& fault) {
  return std::tie(fault.file, fault.line, fault.column, fault.found, fault.allowed, fault.advice);
}

}  // namespace

namespace {

/// Words of blocks are whole sentences.
std::string part(const std::string& text) {
  return !text.empty() && text.back() == '.' ? text.substr(0, text.size() - 1) : text;
}

}  // namespace

std::string describe(const Fault& fault) {
  std::string text = fault.file;
  if (fault.line > 0) text += fmt::format(":{}:{}", fault.line, fault.column);
  text += fmt::format(": {} {}", fault.field.empty() ? "the file" : fault.field, part(fault.found));
  if (!fault.allowed.empty()) text += "; allowed: " + part(fault.allowed);
  return forPeople(text + "; " + part(fault.advice));
}

std::string joined(const std::string& field, const std::string& part) {
  if (field.empty() || part.empty()) return field + part;
  return field + (part.front() == '[' ? "" : ".") + part;
}

void FaultList::add(const std::string& field, const files::FileFault& fault) {
  ++count_;
  const files::YamlFinding& finding = fault.finding;
  Fault made{fault.file,    fault.line,      fault.column,  joined(field, finding.field),
             finding.found, finding.allowed, finding.advice};
  if (made.found.empty()) made.found = "is wrong: " + fault.what;
  if (made.advice.empty()) made.advice = made.allowed.empty() ? "correct it" : "write what is allowed";
  const auto same = [&made](const Fault& other) { return wordsOf(other) == wordsOf(made); };
  const bool told = std::any_of(faults_.begin(), faults_.end(), same);
  if (!told && faults_.size() < kMostFaults) faults_.push_back(std::move(made));
}

void FaultList::add(const Place& place, const std::string& field, files::YamlFinding finding) {
  add(field, files::FileFault{place.file, place.line, place.column, "", std::move(finding)});
}

std::vector<Fault> FaultList::all() && {
  // Those of the file itself first; then those of the files that it names.
  std::stable_sort(faults_.begin(), faults_.end(), [this](const Fault& a, const Fault& b) {
    return std::make_tuple(a.file != file_, a.line, a.column) <
           std::make_tuple(b.file != file_, b.line, b.column);
  });
  return std::move(faults_);
}

void refuseAt(const YAML::Mark& mark, files::YamlFinding finding) {
  const std::string what = joined(finding.field, "") + ' ' + finding.found;
  throw files::YamlFault(mark, what, std::move(finding));
}

Place placeOf(const FaultList& faults, const YAML::Mark& mark) {
  return {faults.file(), mark.line + 1, mark.column + 1};
}

}  // namespace cobot_command::cell
