#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>
#include <Cutwater/Triangles/Search/BoxSearch.hpp>

#include <algorithm>
#include <array>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"
#include "Support/SurfaceInBlock.hpp"

// The same answers as when all triangles are tried; ctest runs these for every instruction set.

namespace cutwater::test {
namespace {

using Corners = QueryBox::Corners;
using Axes = std::array<Vec3<double>, 3>;

template <typename T>
struct SearchedForBoxes : SearchableInBlock<T> {
  using SearchableInBlock<T>::surface;
  using SearchableInBlock<T>::search;
  using SearchableInBlock<T>::SearchableInBlock;

  BoxOverlap found(const OrientedBox<double>& box, std::uint32_t& node) const {
    return overlapOf(search, surface, box, node);
  }
  BoxOverlap found(const OrientedBox<double>& box) const {
    std::uint32_t root = 0;
    return found(box, root);
  }
  BoxOverlap expected(const OrientedBox<double>& box) const {
    const QueryBox query(box);
    auto result = BoxOverlap::None;
    for (std::uint32_t id = 0; id < surface.triangles.size(); ++id) {
      result = std::max(result, query.overlapWith(surface.corners(id)));
    }
    return result;
  }
};

/// Random boxes, aligned and turned.
class Boxes {
 public:
  double number() { return random_.next().x; }
  Vec3<double> point() { return random_.next(); }
  Axes axes(bool isTurned) {
    if (!isTurned) return {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    const auto x = normalized(point());
    const auto y = normalized(cross(x, point()));
    Axes result{x, y, cross(x, y)};
    // As single precision turns them.
    if (++count_ % 3 == 0) {
      for (auto& axis : result) axis += 1e-7 * point();
    }
    return result;
  }
  /// Of edges about as long, or some of them much shorter, or none.
  Vec3<double> half(double size) {
    const auto some = size * (Vec3<double>{1, 1, 1} + point());
    switch (++count_ % 8) {
      case 0:
        return {some.x, some.y, 0};
      case 1:
        return {1e-3 * some.x, some.y, some.z};
      case 2:
        return {some.x, 1e-7 * some.y, 1e-4 * some.z};
      case 3:
        return count_ % 24 == 3 ? Vec3<double>{} : some;
      default:
        return some;
    }
  }
  static OrientedBox<double> box(const Vec3<double>& center, const Axes& axes,
                                 const Vec3<double>& half, double slack) {
    return {center, {half.x * axes[0], half.y * axes[1], half.z * axes[2]}, slack};
  }

 private:
  RandomPoints<double> random_{1, /*seed=*/17};
  int count_ = 0;
};

/// How often which answer came.
using Tally = std::array<int, 3>;

template <typename T>
Tally expectAnswersOfAll(const SearchedForBoxes<T>& mesh, int count) {
  Boxes boxes;
  Tally tally{};
  for (int i = 0; i < count; ++i) {
    const auto id = static_cast<std::uint32_t>(i * 7919L % std::ssize(mesh.surface.triangles));
    const auto [a, b, c] = mesh.surface.corners(id);
    const double size = std::ldexp(double{mesh.surface.size}, 1 - i % 37);
    const auto center = a + 0.3 * (b - a) + 0.3 * (c - a) + size * boxes.point();
    const double slack = i % 3 == 0 ? 0 : 1e-7 * size;
    const auto box = Boxes::box(center, boxes.axes(i % 2 == 0), boxes.half(size), slack);
    const auto expected = mesh.expected(box);
    EXPECT_EQ(mesh.found(box), expected) << i;
    ++tally[static_cast<std::size_t>(expected)];
  }
  return tally;
}

/// A box that touches the triangle but for a gap along one of the directions that separate such,
/// which are numbered; a negative gap is an overlap.
OrientedBox<double> touching(const Corners& t, const Axes& axes, const Vec3<double>& half,
                             int direction, double gap, Boxes& random) {
  const Axes edges{t[1] - t[0], t[2] - t[1], t[0] - t[2]};
  Vec3<double> way = direction < 3   ? axes[static_cast<std::size_t>(direction)]
                     : direction < 4 ? cross(edges[0], edges[1])
                                     : cross(edges[static_cast<std::size_t>((direction - 4) / 3)],
                                             axes[static_cast<std::size_t>((direction - 4) % 3)]);
  way = normalized(way);
  if (direction >= 4) {  // away from the third corner
    const auto first = static_cast<std::size_t>((direction - 4) / 3);
    if (dot(way, t[(first + 2) % 3] - t[first]) > 0) way = -way;
  }
  // The farthest points of the triangle along it, one of them, and of the box against it.
  const auto weights = abs(random.point());
  Vec3<double> at;
  double sum = 0;
  const double most = std::max({dot(way, t[0]), dot(way, t[1]), dot(way, t[2])});
  const double reach = length(edges[0]) + length(edges[1]);
  for (std::size_t i = 0; i < 3; ++i) {
    if (dot(way, t[i]) < most - 1e-6 * reach) continue;
    at += weights[static_cast<int>(i)] * t[i];
    sum += weights[static_cast<int>(i)];
  }
  Vec3<double> center = at / sum + gap * way;
  for (std::size_t k = 0; k < 3; ++k) {
    const double along = dot(way, axes[k]);
    const double place = std::abs(along) < 1e-6 ? random.number() : along > 0 ? 1 : -1;
    center += place * half[static_cast<int>(k)] * axes[k];
  }
  return Boxes::box(center, axes, half, 0);
}

template <typename T>
Tally expectAnswersWhereBoxesTouch(const SearchedForBoxes<T>& mesh, int count) {
  Boxes boxes;
  Tally tally{};
  for (int i = 0; i < count; ++i) {
    const auto id = static_cast<std::uint32_t>(i * 7919L % std::ssize(mesh.surface.triangles));
    const auto t = mesh.surface.corners(id);
    const double size = length(t[1] - t[0]) + length(t[2] - t[1]);
    const double gap = std::ldexp(i % 2 == 0 ? size : -size, -(3 + i / 2 % 45));
    const auto half = boxes.half(size * std::ldexp(1.0, i / 7 % 9 - 5));
    const auto box = touching(t, boxes.axes(i % 3 != 0), half, i % 13, gap, boxes);
    const auto expected = mesh.expected(box);
    EXPECT_EQ(mesh.found(box), expected) << i;
    ++tally[static_cast<std::size_t>(expected)];
  }
  return tally;
}

template <typename T>
class BoxSearchTest : public ::testing::Test {
 protected:
  static std::vector<PolygonSoup> surfaces() {
    return {triangulated(cube()),          tessellation::icosphere(1, 3),
            randomTriangles(300, 1, 0.1),  randomTriangles(200, 1, 3),
            randomTriangles(100, 1e-6, 1), randomTriangles(17, 1e-9, 1e-9)};
  }
};
TYPED_TEST_SUITE(BoxSearchTest, Precisions);

TYPED_TEST(BoxSearchTest, OfBoxesOfAllSizes) {
  for (const auto& soup : this->surfaces()) {
    const auto tally = expectAnswersOfAll(SearchedForBoxes<TypeParam>(soup), scaled(1200));
    EXPECT_GT(tally[0], 20);
    EXPECT_GT(tally[2], 20);
  }
}

TYPED_TEST(BoxSearchTest, OfBoxesThatTouchOrNearlySo) {
  for (const auto& soup : this->surfaces()) {
    const auto tally =
        expectAnswersWhereBoxesTouch(SearchedForBoxes<TypeParam>(soup), scaled(4000));
    EXPECT_GT(tally[2], 1000);
  }
  // A triangle alone: nothing else is met.
  const SearchedForBoxes<TypeParam> one(
      makeSoup({{0.3, 0, 0.1}, {1, 0.2, 0}, {0.1, 0.9, 0}}, {{0, 1, 2}}));
  const auto tally = expectAnswersWhereBoxesTouch(one, scaled(4000));
  EXPECT_GT(tally[0], 1000);
  EXPECT_GT(tally[1], 100);
  EXPECT_GT(tally[2], 800);
}

TYPED_TEST(BoxSearchTest, FarFromTheOriginAndAtExtremeSizes) {
  using T = TypeParam;
  const double far = sizeof(T) == sizeof(float) ? 1e3 : 1e9;
  for (const double scale : {1.0, 1e-12, 1e12}) {
    const Vec3<double> offset = scale == 1 ? Vec3<double>{far, -far, far} : Vec3<double>{};
    const auto soup = withPoints(tessellation::icosphere(1, 2),
                                 [&](const Vec3<double>& p) { return scale * p + offset; });
    const SearchedForBoxes<T> mesh(soup);
    expectAnswersOfAll(mesh, scaled(500));
    const auto tally = expectAnswersWhereBoxesTouch(mesh, scaled(1000));
    EXPECT_GT(tally[2], 100);
  }
}

TYPED_TEST(BoxSearchTest, FromTheNodeThatLedToTheBoxAround) {
  using T = TypeParam;
  const SearchedForBoxes<T> mesh(tessellation::icosphere(1, 5));
  Boxes random;
  int known = 0;
  Tally tally{};
  for (int i = 0; i < scaled(150); ++i) {
    const bool isTurned = i % 2 == 0;
    const auto axes = random.axes(isTurned);
    auto center = 0.5 * random.point();
    auto half = Vec3<double>{0.4, 0.4, 0.4};
    std::uint32_t node = 0;
    for (int level = 0; level < 7; ++level) {
      const auto box = Boxes::box(center, axes, half, 1e-7);
      const auto expected = mesh.expected(box);
      EXPECT_EQ(mesh.found(box, node), expected) << i << ' ' << level;
      EXPECT_EQ(mesh.found(box), expected);
      known += node != 0 ? 1 : 0;
      ++tally[static_cast<std::size_t>(expected)];
      // On to the octant nearest to the surface, or just any.
      half *= 0.5;
      Vec3<double> best;
      for (int k = 0; k < 8; ++k) {
        Vec3<double> next = center;
        for (int axis = 0; axis < 3; ++axis) {
          next += ((k >> axis & 1) != 0 ? half[axis] : -half[axis]) *
                  axes[static_cast<std::size_t>(axis)];
        }
        const auto miss = [&](const Vec3<double>& p) {
          return std::abs(length(p) - double{mesh.surface.size});
        };
        if (k == 0 || (i % 5 != 0 ? miss(next) < miss(best) : random.number() > 0.5)) best = next;
      }
      center = best;
    }
  }
  EXPECT_GT(known, 100);
  EXPECT_GT(tally[0], 20);
  EXPECT_GT(tally[2], 300);
}

}  // namespace
}  // namespace cutwater::test
