// The types of a program, each with its size in cells and the places of its parts.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace cobot_command::rapid {

/// Index of a type in its TypeTable. Equal types have one index: an alias is its base type everywhere.
using TypeIndex = std::uint32_t;

/// Unknown, because of an error that is reported elsewhere: it fits everything.
inline constexpr TypeIndex kNoType = 0;
inline constexpr TypeIndex kNum = 1;
inline constexpr TypeIndex kBool = 2;
inline constexpr TypeIndex kString = 3;
inline constexpr TypeIndex kSwitch = 4;
inline constexpr TypeIndex kAnytype = 5;

/// A size of 0 of a dimension: as large as the argument is (`{*}` of a parameter).
using Dimensions = std::array<std::uint32_t, 3>;
inline constexpr int kMostDimensions = 3;
inline constexpr std::uint32_t kMostElements = 1000000;  ///< of an array, over all dimensions
/// Of the data and constants of a program, and so of one value [cells]: 64 MiB.
inline constexpr std::uint32_t kMostCells = (64U << 20U) / 4;

enum class TypeKind : std::uint8_t {
  Unknown,
  Num,
  Bool,
  String,
  Switch,     ///< an argument without value
  Anytype,    ///< of parameters of predefined routines: any type, also a whole array
  NonValue,   ///< clock, signaldo ...: no value, no assignment
  SemiValue,  ///< signaldi, signalgi, signalai: read as num, never assigned
  Record,
  Array,
};

struct Component {
  std::string_view name;  ///< in small letters
  TypeIndex type = kNoType;
  std::uint32_t offset = 0;  ///< in its record [cells]
};

struct Type {
  TypeKind kind = TypeKind::Unknown;
  std::string_view name;    ///< as in its declaration; empty for arrays
  std::uint32_t cells = 0;  ///< at most kMostCells + 1, which means too large
  /// Its values can be assigned, compared, passed to IN parameters and returned.
  bool has_values = true;
  std::vector<Component> components;  ///< of a Record
  TypeIndex element = kNoType;        ///< of an Array
  std::uint8_t dimensions = 0;        ///< of an Array: 1 to kMostDimensions
  Dimensions sizes{};                 ///< of an Array
};

class TypeTable {
 public:
  /// With the atomic types. The names of all types must live as long as the table.
  TypeTable();

  [[nodiscard]] const Type& operator[](TypeIndex type) const { return types_[type]; }
  [[nodiscard]] TypeIndex size() const { return static_cast<TypeIndex>(types_.size()); }
  /// "num", "pos", "num{2,3}", "num{*}".
  [[nodiscard]] std::string nameOf(TypeIndex type) const;
  /// Position in Type::components of a name in small letters.
  [[nodiscard]] std::optional<std::uint32_t> componentNamed(TypeIndex record, std::string_view folded) const;
  /// True for arrays of a parameter with `{*}`.
  [[nodiscard]] bool isConformant(TypeIndex type) const;
  /// The atomic type of a name in small letters; kNoType if there is none.
  [[nodiscard]] TypeIndex atomicNamed(std::string_view folded) const;

  /// A type of its own, without components.
  [[nodiscard]] TypeIndex addRecord(std::string_view name);
  /// Of a record that no other type uses yet; `offset` is calculated.
  void setComponents(TypeIndex record, std::vector<Component> components);
  /// Precondition: `element` is no array, 1 to kMostDimensions sizes are given.
  [[nodiscard]] TypeIndex arrayOf(TypeIndex element, std::uint8_t dimensions, const Dimensions& sizes);

 private:
  std::vector<Type> types_;
  std::map<std::tuple<TypeIndex, std::uint8_t, Dimensions>, TypeIndex> arrays_;
  std::map<std::pair<TypeIndex, std::string_view>, std::uint32_t> component_names_;
};

}  // namespace cobot_command::rapid
