#include <Cutwater/Render/Detail/MeshLines.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <map>

#include "Support/Precisions.hpp"

namespace cutwater::test {
namespace {

using detail::meshLines;
using detail::PlotArea;

template <typename T>
class MeshLinesTest : public ::testing::Test {
 protected:
  static double lengthOf(const std::vector<Stroke>& strokes) {
    double sum = 0;
    for (const auto& s : strokes) sum += std::hypot(s.x1 - s.x0, s.y1 - s.y0);
    return sum;
  }
  /// Of the union of the outlines that cells have on a plane z = height.
  static double outlineLength(const Octree<T>& mesh, T height) {
    std::map<std::pair<int, T>, std::map<T, T>> lines;  // by axis and place: stretches by beginning
    for (const auto& cell : mesh.cells()) {
      const auto box = mesh.box(cell);
      if (box.lower.z >= height || box.upper.z < height) continue;
      for (int axis = 0; axis < 2; ++axis) {
        for (const T place : {box.lower[axis], box.upper[axis]}) {
          auto& end = lines[{axis, place}].try_emplace(box.lower[1 - axis], T(-100)).first->second;
          end = std::max(end, box.upper[1 - axis]);
        }
      }
    }
    double sum = 0;
    for (const auto& [line, stretches] : lines) {
      T reached = -100;
      for (const auto& [begin, end] : stretches) {
        if (end > reached) sum += double{end - std::max(begin, reached)};
        reached = std::max(reached, end);
      }
    }
    return sum;
  }
  const OctreeDomain<T> domain{{-2, -2, -2}, 1, {4, 4, 4}};
  const SliceWindow<T> window{{-4, -4}, {4, 4}};  // with room around the domain
  const PlotArea area{100, 50, 400, 400};
};
TYPED_TEST_SUITE(MeshLinesTest, Precisions);

TYPED_TEST(MeshLinesTest, OutlineEveryCellOnce) {
  using T = TypeParam;
  const Refinement<T> rules{.cut = 3};
  const Octree<T> mesh(Sphere<T>({T(0.1), 0, 0}, T(1.2)), this->domain, rules);
  for (const T height : {T(0.01), T(0.6), T(1.95)}) {
    const auto plane = SlicePlane<T>::across(2, height);
    const auto lines = meshLines(mesh, plane, this->window, this->area);
    const double pixels = 50;  // a unit
    EXPECT_NEAR(this->lengthOf(lines), pixels * this->outlineLength(mesh, height), 0.1);
  }
}

TYPED_TEST(MeshLinesTest, StayInThePlot) {
  using T = TypeParam;
  const Octree<T> mesh(Sphere<T>({0, 0, 0}, 1), this->domain, Refinement<T>{.cut = 2});
  const auto plane = SlicePlane<T>::through({0, 0, T(0.1)}, {1, 2, T(0.5)}, {0, 1, 1});
  const SliceWindow<T> part{{T(-0.7), T(-0.4)}, {T(0.9), T(1.2)}};
  const auto lines = meshLines(mesh, plane, part, this->area);
  EXPECT_GT(lines.size(), 20U);
  for (const auto& line : lines) {
    for (const double x : {line.x0, line.x1}) {
      EXPECT_GE(x, 100 - 1e-3);
      EXPECT_LE(x, 500 + 1e-3);
    }
    for (const double y : {line.y0, line.y1}) {
      EXPECT_GE(y, 50 - 1e-3);
      EXPECT_LE(y, 450 + 1e-3);
    }
  }
}

TYPED_TEST(MeshLinesTest, StandWhereTheCellsAre) {
  using T = TypeParam;
  const Octree<T> mesh(Sphere<T>({9, 9, 9}, 1), this->domain, Refinement<T>{});
  const SliceWindow<T> part{{T(0.5), T(-1.75)}, {T(1.5), T(-1.25)}};  // x, z
  const auto lines =
      meshLines(mesh, SlicePlane<T>::across(1, T(0.3)), part, PlotArea{0, 0, 200, 100});
  ASSERT_EQ(lines.size(), 1U);  // x = 1
  EXPECT_NEAR(lines[0].x0, 100, 1e-3);
  EXPECT_NEAR(lines[0].x1, 100, 1e-3);
  EXPECT_NEAR(std::abs(lines[0].y1 - lines[0].y0), 100, 1e-3);
}

}  // namespace
}  // namespace cutwater::test
