#include "cobot_command/cell/covering/stl.h"

#include <cstring>
#include <limits>

#include <gmock/gmock.h>

namespace cobot_command::cell {
namespace {

using ::testing::HasSubstr;

constexpr const char* kText =
    "solid a bracket\n"
    " facet normal 0 0 1\n  outer loop\n"
    "   vertex 0 0 0\n   vertex 1.5e2 +0 0\n   vertex 0 -20.25 3\n"
    "  endloop\n endfacet\nendsolid a bracket\n";

std::string binary(const std::vector<std::array<float, 9>>& triangles, const char* header = "made by hand") {
  std::string bytes(84, '\0');
  std::memcpy(bytes.data(), header, std::strlen(header));
  bytes[80] = static_cast<char>(triangles.size());
  for (const auto& corners : triangles) {
    bytes.append(12, '\0');
    bytes.append(reinterpret_cast<const char*>(corners.data()), sizeof corners);
    bytes.append(2, '\0');
  }
  return bytes;
}

std::string faultOf(const std::string& bytes) {
  const auto triangles = trianglesOfStl(bytes);
  return triangles ? "none" : triangles.error();
}

TEST(AnStlFile, isReadAsText) {
  const auto triangles = trianglesOfStl(kText);
  ASSERT_TRUE(triangles) << triangles.error();
  ASSERT_EQ(triangles->size(), 1U);
  EXPECT_EQ((*triangles)[0][1], Eigen::Vector3d(150, 0, 0));
  EXPECT_EQ((*triangles)[0][2], Eigen::Vector3d(0, -20.25, 3));
}

TEST(AnStlFile, isReadAsBytes) {
  const auto triangles =
      trianglesOfStl(binary({{0, 0, 0, 1, 0, 0, 0, 2, 0}, {0, 0, 0, 1, 0, 0, 0, 0, -3.5F}}));
  ASSERT_TRUE(triangles) << triangles.error();
  ASSERT_EQ(triangles->size(), 2U);
  EXPECT_EQ((*triangles)[1][2], Eigen::Vector3d(0, 0, -3.5));
}

TEST(AnStlFile, isBinaryWhereItsLengthSaysSoThoughItBeginsAsText) {
  EXPECT_TRUE(trianglesOfStl(binary({{0, 0, 0, 1, 0, 0, 0, 2, 0}}, "solid of a program that lies")));
}

TEST(AnStlFile, isRefusedWhereItIsNone) {
  EXPECT_THAT(faultOf(""), HasSubstr("it is not an STL file"));
  EXPECT_THAT(faultOf("shapes: []"), HasSubstr("export the mesh as STL"));
  EXPECT_THAT(faultOf("solid nothing\nendsolid\n"), HasSubstr("no triangles"));
  std::string cut = binary({{0, 0, 0, 1, 0, 0, 0, 2, 0}, {0, 0, 0, 1, 0, 0, 0, 2, 0}});
  cut.pop_back();
  EXPECT_THAT(faultOf(cut), HasSubstr("it is 183 bytes long, but a binary STL file of 2 triangles has 184"));
  const std::string text = kText;
  EXPECT_THAT(faultOf(text.substr(0, text.rfind("   vertex"))), HasSubstr("it ends within a triangle"));
}

TEST(AnStlFile, isRefusedWhereACornerIsNoPoint) {
  std::string text = kText;
  text.replace(text.find("1.5e2"), 5, "1,5");
  EXPECT_THAT(faultOf(text), HasSubstr("a corner of triangle 1 has \"1,5\" where a number should be"));
  text = kText;
  text.replace(text.find("1.5e2"), 5, "nan");
  EXPECT_THAT(faultOf(text), HasSubstr("triangle 1 has a corner with invalid coordinates"));
  constexpr float kEndless = std::numeric_limits<float>::infinity();
  EXPECT_THAT(faultOf(binary({{0, 0, 0, 1, 0, 0, 0, kEndless, 0}})), HasSubstr("invalid coordinates"));
}

TEST(AnStlFile, isRefusedWhereAFacetIsNoTriangle) {
  std::string text = kText;
  text.insert(text.find("  endloop"), "   vertex 1 1 1\n");
  EXPECT_THAT(faultOf(text), HasSubstr("triangle 2 has 1 corners, not 3"));
}

}  // namespace
}  // namespace cobot_command::cell
