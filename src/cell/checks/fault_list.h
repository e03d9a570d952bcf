// What is wrong with a cell file, collected: what one part of it is refused for does not hide what is wrong
// with the others.
#pragma once

#include <string>
#include <vector>

#include "cobot_command/cell/program/cell_file.h"
#include "cobot_command/files/yaml_map.h"

namespace cobot_command::cell {

/// "robots.RA" and "base[2]" → "robots.RA.base[2]"
[[nodiscard]] std::string joined(const std::string& field, const std::string& part);

class FaultList {
 public:
  explicit FaultList(std::string file) : file_(std::move(file)) {}

  /// Does `read`; a fault that leaves it is kept, as one of `field`. False: there was one.
  template <class Read>
  bool collect(const std::string& field, const Read& read) {
    try {
      read();
      return true;
    } catch (const files::YamlFault& fault) {
      add(field, files::faultOf(file_, fault));
    } catch (const YAML::Exception& fault) {
      add(field, files::faultOf(file_, fault));
    }
    return false;
  }
  /// A fault of this file, or of one that it names.
  void add(const std::string& field, const files::FileFault& fault);
  void add(const Place& place, const std::string& field, files::YamlFinding finding);

  [[nodiscard]] const std::string& file() const { return file_; }
  [[nodiscard]] bool isEmpty() const { return count_ == 0; }
  /// Of all that was found so far, those that are not kept included.
  [[nodiscard]] std::size_t count() const { return count_; }
  /// In the order of their lines. One behind several aliases is told once.
  [[nodiscard]] std::vector<Fault> all() &&;

 private:
  std::string file_;
  std::vector<Fault> faults_;
  std::size_t count_ = 0;
};

/// Does `read`; a fault that leaves it is one of that field.
template <class Read>
auto within(const std::string& field, const Read& read) {
  try {
    return read();
  } catch (files::YamlFault& fault) {
    fault.finding.field = joined(field, fault.finding.field);
    throw;
  }
}

/// Throws a YamlFault.
[[noreturn]] void refuseAt(const YAML::Mark& mark, files::YamlFinding finding);

[[nodiscard]] Place placeOf(const FaultList& faults, const YAML::Mark& mark);

}  // namespace cobot_command::cell
