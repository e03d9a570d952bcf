#include "cobot_command/cell/covering/box_cover.h"

#include <random>

#include <gmock/gmock.h>

namespace cobot_command::cell {
namespace {

using Eigen::Vector3d;
using ::testing::HasSubstr;
using ::testing::SizeIs;
using Mesh = std::vector<Triangle>;

/// The twelve triangles of a box.
Mesh meshOf(const Vector3d& lower, const Vector3d& upper) {
  const auto corner = [&](int bits) {
    return Vector3d((bits & 1) != 0 ? upper.x() : lower.x(), (bits & 2) != 0 ? upper.y() : lower.y(),
                    (bits & 4) != 0 ? upper.z() : lower.z());
  };
  Mesh mesh;
  constexpr int kFaces[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  for (const auto& face : kFaces) {
    mesh.push_back({corner(face[0]), corner(face[1]), corner(face[2])});
    mesh.push_back({corner(face[0]), corner(face[2]), corner(face[3])});
  }
  return mesh;
}

Mesh together(Mesh one, const Mesh& other) {
  one.insert(one.end(), other.begin(), other.end());
  return one;
}

double volumeOf(const std::vector<AlignedBox>& boxes) {
  double volume = 0.0;
  for (const AlignedBox& box : boxes) volume += (box.upper - box.lower).prod();
  return volume;
}

bool isCovered(const Vector3d& point, const std::vector<AlignedBox>& boxes) {
  constexpr double kRounding = 1e-9;
  return std::any_of(boxes.begin(), boxes.end(), [&](const AlignedBox& box) {
    return (point.array() >= box.lower.array() - kRounding).all() &&
           (point.array() <= box.upper.array() + kRounding).all();
  });
}

std::vector<AlignedBox> cover(const Mesh& mesh, double edge) {
  auto boxes = boxesOver(mesh, edge);
  EXPECT_TRUE(boxes) << boxes.error();
  return *boxes;
}

TEST(ACoverByBoxes, isTheBoxItselfWhereTheMeshIsOne) {
  for (const double edge : {10.0, 33.0, 50.0, 400.0}) {
    const auto boxes = cover(meshOf({-10, 20, 5}, {190, 120, 65}), edge);
    ASSERT_THAT(boxes, SizeIs(1)) << edge;
    EXPECT_TRUE(boxes[0].lower.isApprox(Vector3d(-10, 20, 5)));
    EXPECT_TRUE(boxes[0].upper.isApprox(Vector3d(190, 120, 65)));
  }
}

TEST(ACoverByBoxes, hasTwoOfAnAngle) {
  const Mesh angle = together(meshOf({0, 0, 0}, {200, 50, 50}), meshOf({0, 0, 0}, {50, 50, 200}));
  const auto boxes = cover(angle, 50.0);
  EXPECT_THAT(boxes, SizeIs(2));
  EXPECT_NEAR(volumeOf(boxes), 50.0 * 50.0 * 350.0, 1.0) << "nothing beside it";
}

TEST(ACoverByBoxes, isThinWhereTheMeshIs) {
  const auto boxes = cover(meshOf({3, 0, 0}, {303, 200, 5}), 50.0);
  ASSERT_THAT(boxes, SizeIs(1));
  EXPECT_NEAR(boxes[0].upper.z() - boxes[0].lower.z(), 5.0, 0.11);
  const auto flat = cover({{Vector3d(0, 0, 7), Vector3d(100, 0, 7), Vector3d(0, 100, 7)}}, 100.0);
  ASSERT_THAT(flat, SizeIs(1));
  EXPECT_GE(flat[0].upper.z() - flat[0].lower.z(), 1.0) << "a body has a size";
}

TEST(ACoverByBoxes, missesNoPointOfAnyTriangle) {
  std::mt19937 chance(5);
  std::uniform_real_distribution<double> place(-300, 300);
  std::uniform_real_distribution<double> share(0, 1);
  const auto point = [&](bool is_even) {
    const Vector3d any(place(chance), place(chance), place(chance));
    // On the faces and edges of the cells, too.
    return is_even ? Vector3d((any / 25.0).array().round() * 25.0) : any;
  };
  for (int run = 0; run < 60; ++run) {
    Mesh mesh;
    for (int i = 0; i < 12; ++i) {
      mesh.push_back({point(run % 2 == 0), point(run % 2 == 0), point(run % 2 == 0)});
    }
    const auto boxes = cover(mesh, run % 3 == 0 ? 17.3 : 25.0);
    for (const Triangle& triangle : mesh) {
      for (int i = 0; i < 200; ++i) {
        double a = i < 3 ? (i == 0 ? 1.0 : 0.0) : share(chance);
        double b = i < 3 ? (i == 1 ? 1.0 : 0.0) : share(chance);
        if (a + b > 1.0) {
          a = 1.0 - a;
          b = 1.0 - b;
        }
        const Vector3d inside = a * triangle[0] + b * triangle[1] + (1.0 - a - b) * triangle[2];
        ASSERT_TRUE(isCovered(inside, boxes)) << run << ": " << inside.transpose();
      }
    }
  }
}

TEST(ACoverByBoxes, isFilledWhereTheMeshClosesSomethingIn) {
  // A ball of triangles, without anything in it.
  Mesh ball;
  const auto at = [](int i, int k) {
    const double around = 2.0 * M_PI * i / 24.0;
    const double up = M_PI * k / 12.0;
    return Vector3d(150.0 * std::sin(up) * std::cos(around), 150.0 * std::sin(up) * std::sin(around),
                    150.0 * std::cos(up));
  };
  for (int i = 0; i < 24; ++i) {
    for (int k = 0; k < 12; ++k) {
      ball.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      ball.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
  }
  const auto boxes = cover(ball, 20.0);
  std::mt19937 chance(6);
  std::uniform_real_distribution<double> place(-100, 100);
  for (int i = 0; i < 5000; ++i) {
    const Vector3d point(place(chance), place(chance), place(chance));
    ASSERT_TRUE(point.norm() > 145.0 || isCovered(point, boxes)) << point.transpose();
  }
  const double volume = 4.0 / 3.0 * M_PI * std::pow(150.0, 3);
  EXPECT_LT(volumeOf(boxes), 1.35 * volume) << "and not much more";
  EXPECT_LT(boxes.size(), 200U);
}

TEST(ACoverByBoxes, hasNoBoxesThatOverlap) {
  const auto boxes =
      cover(together(meshOf({0, 0, 0}, {200, 60, 50}), meshOf({30, 10, 20}, {80, 300, 210})), 30.0);
  for (std::size_t one = 0; one < boxes.size(); ++one) {
    for (std::size_t other = one + 1; other < boxes.size(); ++other) {
      const Vector3d common =
          boxes[one].upper.cwiseMin(boxes[other].upper) - boxes[one].lower.cwiseMax(boxes[other].lower);
      EXPECT_LT(common.minCoeff(), 1.1) << "but for what makes thin ones thick, and for rounding";
    }
  }
}

TEST(ACoverByBoxes, isRefusedWhereItWouldBeTooFine) {
  const auto boxes = boxesOver(meshOf({0, 0, 0}, {2000, 2000, 2000}), 5.0);
  ASSERT_FALSE(boxes);
  EXPECT_EQ(boxes.error(),
            "64000000 cells of 5 mm are needed, but at most 2000000 are allowed: choose larger ones");
  EXPECT_THAT(boxesOver(meshOf({0, 0, 0}, {1, 1, 1e9}), 50.0).error(), HasSubstr("is it in another unit?"));
}

TEST(ACoverByBoxes, isWrittenAsACellFileHasIt) {
  EXPECT_EQ(shapesText({{Vector3d(-10, 0, 0), Vector3d(190, 100, 0.5 + 0.6)}}),
            "shapes:\n  - box: {size: [200, 100, 1.1]}\n    at: [90, 50, 0.55, 0, 0, 0]\n");
}

}  // namespace
}  // namespace cobot_command::cell
