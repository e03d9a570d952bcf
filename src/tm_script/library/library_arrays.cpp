// Arrays. A function gives a changed copy; its argument stays as it is.
#include <algorithm>

#include "library/library.h"
#include <fmt/format.h>

namespace cobot_command::tm_script {

namespace {

std::ptrdiff_t signedSize(const Array& array) {
  return static_cast<std::ptrdiff_t>(array.items.size());
}

/// The items to add: an array's, or one.
std::vector<Scalar> itemsOf(const Value& value) {
  if (const auto* array = std::get_if<Array>(&value)) return array->items;
  return {std::get<Scalar>(value)};
}

Computed inserted(const Arguments& arguments, std::ptrdiff_t place, const Value& added) {
  Array array = arrayAt(arguments, 0);
  if (place < 0 || place > signedSize(array)) {
    return refuse(fmt::format("index {} is outside of an array of {}", place, array.items.size()));
  }
  const std::vector<Scalar> items = itemsOf(added);
  array.items.insert(array.items.begin() + place, items.begin(), items.end());
  return array;
}

Computed append(const Arguments& arguments) {
  return inserted(arguments, signedSize(arrayAt(arguments, 0)), arguments[1]);
}

Computed insert(const Arguments& arguments) {
  return inserted(arguments, intAt(arguments, 1, 0), arguments[2]);
}

Computed remove(const Arguments& arguments) {
  Array array = arrayAt(arguments, 0);
  const int first = intAt(arguments, 1, 0);
  const int count = intAt(arguments, 2, 1);
  if (first < 0 || first >= signedSize(array)) {
    return refuse(fmt::format("index {} is outside of an array of {}", first, array.items.size()));
  }
  const auto begin = array.items.begin() + first;
  array.items.erase(begin, begin + std::clamp<std::ptrdiff_t>(count, 0, signedSize(array) - first));
  return array;
}

Computed indexOf(const Arguments& arguments) {
  const auto& items = arrayAt(arguments, 0).items;
  const auto found = std::find(items.begin(), items.end(), std::get<Scalar>(arguments[1]));
  return Scalar(found == items.end() ? -1 : static_cast<std::int32_t>(found - items.begin()));
}

Computed lastIndexOf(const Arguments& arguments) {
  const auto& items = arrayAt(arguments, 0).items;
  const auto found = std::find(items.rbegin(), items.rend(), std::get<Scalar>(arguments[1]));
  return Scalar(static_cast<std::int32_t>(items.rend() - found) - 1);
}

Computed reverse(const Arguments& arguments) {
  Array array = arrayAt(arguments, 0);
  std::reverse(array.items.begin(), array.items.end());
  return array;
}

Computed sort(const Arguments& arguments) {
  Array array = arrayAt(arguments, 0);
  const bool descending = intAt(arguments, 1, 0) == 1;
  if (std::any_of(array.items.begin(), array.items.end(), [](const Scalar& item) { return item != item; })) {
    return refuse(std::string("NaN cannot be sorted"));
  }
  std::stable_sort(array.items.begin(), array.items.end(),
                   [&](const Scalar& a, const Scalar& b) { return descending ? b < a : a < b; });
  return array;
}

Computed subElements(const Arguments& arguments) {
  const Array& array = arrayAt(arguments, 0);
  const int first = intAt(arguments, 1, 0);
  if (first < 0 || first > signedSize(array)) return Array{array.element, {}};
  const std::ptrdiff_t rest = signedSize(array) - first;
  const int count = intAt(arguments, 2, -1);
  const auto begin = array.items.begin() + first;
  return Array{array.element, {begin, begin + (count < 0 ? rest : std::min<std::ptrdiff_t>(rest, count))}};
}

}  // namespace

void defineArrayFunctions(FunctionTable& table) {
  constexpr Version kSinceArrays{1, 76};
  table.define("any[] Array_Append(any[], element)", kSinceArrays, append);
  table.define("any[] Array_Append(any[], element[])", kSinceArrays, append);
  table.define("any[] Array_Insert(any[], int, element)", kSinceArrays, insert);
  table.define("any[] Array_Insert(any[], int, element[])", kSinceArrays, insert);
  table.define("any[] Array_Remove(any[], int, int?)", kSinceArrays, remove);
  table.define("bool Array_Equals(any[], element[])", kSinceEver,
               [](const Arguments& arguments) -> Computed { return Scalar(arguments[0] == arguments[1]); });
  table.define("int Array_IndexOf(any[], element)", kSinceEver, indexOf);
  table.define("int Array_LastIndexOf(any[], element)", kSinceEver, lastIndexOf);
  table.define("any[] Array_Reverse(any[])", kSinceEver, reverse);
  table.define("any[] Array_Sort(any[], int?)", kSinceEver, sort);
  table.define("any[] Array_SubElements(any[], int, int?)", kSinceEver, subElements);
}

}  // namespace cobot_command::tm_script
