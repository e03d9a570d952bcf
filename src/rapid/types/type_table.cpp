#include "cobot_command/rapid/types/type_table.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cobot_command/rapid/types/cells.h"

namespace cobot_command::rapid {

namespace {

struct Atomic {
  std::string_view name;
  TypeKind kind;
  std::uint32_t cells = 1;
};

/// In the order of their indices.
constexpr std::array kAtomicTypes{
    Atomic{"", TypeKind::Unknown, 0},        Atomic{"num", TypeKind::Num},
    Atomic{"bool", TypeKind::Bool},          Atomic{"string", TypeKind::String, kStringCells},
    Atomic{"switch", TypeKind::Switch},      Atomic{"anytype", TypeKind::Anytype, 0},
    Atomic{"clock", TypeKind::NonValue},     Atomic{"iodev", TypeKind::NonValue},
    Atomic{"triggdata", TypeKind::NonValue}, Atomic{"corrdescr", TypeKind::NonValue},
    Atomic{"shapedata", TypeKind::NonValue}, Atomic{"mecunit", TypeKind::NonValue},
    Atomic{"signaldo", TypeKind::NonValue},  Atomic{"signalgo", TypeKind::NonValue},
    Atomic{"signalao", TypeKind::NonValue},  Atomic{"stoppointdata", TypeKind::NonValue},
    Atomic{"socketdev", TypeKind::NonValue}, Atomic{"rawbytes", TypeKind::NonValue},
    Atomic{"signaldi", TypeKind::SemiValue}, Atomic{"signalgi", TypeKind::SemiValue},
    Atomic{"signalai", TypeKind::SemiValue},
};

std::uint32_t bounded(std::uint64_t cells) {
  return static_cast<std::uint32_t>(std::min<std::uint64_t>(cells, kMostCells + 1));
}

}  // namespace

TypeTable::TypeTable() {
  for (const Atomic& atomic : kAtomicTypes) {
    Type type;
    type.kind = atomic.kind;
    type.name = atomic.name;
    type.cells = atomic.cells;
    type.has_values = atomic.kind != TypeKind::NonValue && atomic.kind != TypeKind::Switch;
    types_.push_back(std::move(type));
  }
}

std::string TypeTable::nameOf(TypeIndex type) const {
  const Type& at = types_[type];
  if (at.kind != TypeKind::Array) return std::string(at.name);
  std::vector<std::string> sizes;
  for (std::size_t i = 0; i < at.dimensions; ++i) {
    sizes.push_back(at.sizes.at(i) == 0 ? "*" : std::to_string(at.sizes.at(i)));
  }
  return fmt::format("{}{{{}}}", nameOf(at.element), fmt::join(sizes, ","));
}

std::optional<std::uint32_t> TypeTable::componentNamed(TypeIndex record, std::string_view folded) const {
  const auto found = component_names_.find({record, folded});
  return found == component_names_.end() ? std::nullopt : std::optional(found->second);
}

bool TypeTable::isConformant(TypeIndex type) const {
  return types_[type].kind == TypeKind::Array && types_[type].sizes.front() == 0;
}

TypeIndex TypeTable::atomicNamed(std::string_view folded) const {
  for (TypeIndex type = kNum; type < kAtomicTypes.size(); ++type) {
    if (types_[type].name == folded) return type;
  }
  return kNoType;
}

TypeIndex TypeTable::addRecord(std::string_view name) {
  Type type;
  type.kind = TypeKind::Record;
  type.name = name;
  types_.push_back(std::move(type));
  return size() - 1;
}

void TypeTable::setComponents(TypeIndex record, std::vector<Component> components) {
  std::uint64_t cells = 0;
  bool has_values = true;
  for (std::uint32_t i = 0; i < components.size(); ++i) {
    const Type& part = types_[components[i].type];
    components[i].offset = bounded(cells);
    cells += part.cells;
    has_values = has_values && part.has_values;
    component_names_.emplace(std::pair(record, components[i].name), i);
  }
  types_[record].has_values = has_values;
  types_[record].components = std::move(components);
  types_[record].cells = bounded(cells);
}

TypeIndex TypeTable::arrayOf(TypeIndex element, std::uint8_t dimensions, const Dimensions& sizes) {
  const auto [found, is_new] = arrays_.try_emplace({element, dimensions, sizes}, size());
  if (!is_new) return found->second;
  Type type;
  type.kind = TypeKind::Array;
  type.element = element;
  type.dimensions = dimensions;
  type.sizes = sizes;
  type.has_values = types_[element].has_values;
  std::uint64_t cells = types_[element].cells;
  for (std::size_t i = 0; i < dimensions; ++i) cells = bounded(cells * sizes.at(i));
  type.cells = bounded(cells);
  types_.push_back(std::move(type));
  return found->second;
}

}  // namespace cobot_command::rapid
