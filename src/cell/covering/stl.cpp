#include "cobot_command/cell/covering/stl.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>

#include <fmt/format.h>

#include "cobot_command/common/foreign_text.h"

namespace cobot_command::cell {
namespace {

using Triangles = Result<std::vector<Triangle>, std::string>;

constexpr std::size_t kHeader = 84;  ///< of a binary file: 80 bytes of anything, and the count
constexpr std::size_t kBytesPerTriangle = 50;

std::uint32_t countIn(std::string_view bytes) {
  std::uint32_t count = 0;
  for (std::size_t byte = 4; byte-- > 0;) {
    count = 256 * count + static_cast<unsigned char>(bytes[80 + byte]);
  }
  return count;
}

/// Little endian, on any machine.
double floatAt(std::string_view bytes, std::size_t at) {
  std::uint32_t bits = 0;
  for (std::size_t byte = 4; byte-- > 0;) bits = 256 * bits + static_cast<unsigned char>(bytes[at + byte]);
  float value = 0.0F;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

std::string tooMany(std::size_t count) {
  return fmt::format(
      "it has {} triangles, but at most {} are allowed: export a coarser mesh from the CAD program", count,
      kMostTriangles);
}

bool isFinite(const Triangle& triangle) {
  return triangle[0].allFinite() && triangle[1].allFinite() && triangle[2].allFinite();
}

Triangles triangles(std::vector<Triangle> found) {
  if (found.empty()) return refuse(std::string("it has no triangles: export the mesh as STL"));
  for (std::size_t index = 0; index < found.size(); ++index) {
    if (isFinite(found[index])) continue;
    return refuse(
        fmt::format("triangle {} has a corner with invalid coordinates: repair the mesh", index + 1));
  }
  return found;
}

Triangles fromBinary(std::string_view bytes, std::size_t count) {
  if (count > kMostTriangles) return refuse(tooMany(count));
  std::vector<Triangle> found(count);
  for (std::size_t index = 0; index < count; ++index) {
    std::size_t at = kHeader + index * kBytesPerTriangle + 12;  // behind the normal
    for (Eigen::Vector3d& corner : found[index]) {
      for (double& number : corner) {
        number = floatAt(bytes, at);
        at += 4;
      }
    }
  }
  return triangles(std::move(found));
}

class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}

  /// Nothing: the text is over.
  [[nodiscard]] std::optional<std::string_view> next() {
    constexpr std::string_view kSpaces = " \t\r\n\f\v";
    const std::size_t begin = text_.find_first_not_of(kSpaces, at_);
    if (begin == std::string_view::npos) return std::nullopt;
    at_ = std::min(text_.find_first_of(kSpaces, begin), text_.size());
    return text_.substr(begin, at_ - begin);
  }

 private:
  std::string_view text_;
  std::size_t at_ = 0;
};

std::optional<double> numberIn(std::string_view word) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  double number = 0.0;
  const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
  if (read.ec != std::errc() || read.ptr != word.data() + word.size()) return std::nullopt;
  return number;
}

/// Corners are what follows "vertex"; three make a triangle, whatever stands around them.
Triangles fromText(std::string_view bytes) {
  std::vector<Triangle> found;
  std::size_t corner = 0;
  Triangle triangle;
  Words words(bytes);
  for (auto word = words.next(); word; word = words.next()) {
    if (*word == "endfacet" && corner != 0) {
      return refuse(fmt::format("triangle {} has {} corners, not 3: export triangles from the CAD program",
                                found.size() + 1, corner));
    }
    if (*word != "vertex") continue;
    for (double& number : triangle[corner]) {
      const auto digits = words.next();
      const auto value = digits ? numberIn(*digits) : std::nullopt;
      if (!value) {
        return refuse(fmt::format("a corner of triangle {} has \"{}\" where a number should be",
                                  found.size() + 1, digits ? foreignText(*digits, kQuoteLimit) : ""));
      }
      number = *value;
    }
    if (++corner < 3) continue;
    corner = 0;
    found.push_back(triangle);
    if (found.size() > kMostTriangles) return refuse(tooMany(found.size()));
  }
  if (corner != 0) {
    return refuse(std::string("it ends within a triangle: the file is truncated. Write it again"));
  }
  return triangles(std::move(found));
}

}  // namespace

/// Binary files may begin with "solid", as text does: what they are their length says.
Result<std::vector<Triangle>, std::string> trianglesOfStl(std::string_view bytes) {
  constexpr std::string_view kText = "solid";
  if (bytes.size() >= kHeader) {
    const std::size_t count = countIn(bytes);
    if (bytes.size() == kHeader + count * kBytesPerTriangle) return fromBinary(bytes, count);
  }
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  if (begin != std::string_view::npos && bytes.substr(begin, kText.size()) == kText) return fromText(bytes);
  if (bytes.size() < kHeader) return refuse(std::string("it is not an STL file: export the mesh as STL"));
  return refuse(
      fmt::format("it is {} bytes long, but a binary STL file of {} triangles has {}: it is truncated, or "
                  "not an STL file. Export the mesh as STL again",
                  bytes.size(), countIn(bytes), kHeader + countIn(bytes) * kBytesPerTriangle));
}

}  // namespace cobot_command::cell
