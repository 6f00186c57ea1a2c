// Signs of open surfaces that are known beforehand, and those of points that follow each other.

#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Sdf/Solid.hpp>

#include <random>

#include "Mesh/WindingSurfaces.hpp"
#include "Support/Grid.hpp"
#include "Support/Precisions.hpp"
#include "Support/Scale.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

std::vector<NamedSurface> openSurfaces() {
  const auto mostOf = [](const PolygonSoup& soup) {
    return onlyFaces(soup, [](std::size_t i) { return i > 20; });
  };
  // A trough: its hole is as long as it is.
  const auto whole = blockOf({0, 0, 0}, {8, 1, 0.5}, 16);
  const auto trough =
      onlyFaces(whole, [&](std::size_t i) { return 6 * i < 5 * whole.polygonCount(); });
  return {
      {"a ball with a hole", mostOf(ballOf({}, 1, 4))},
      {"a ball with many holes", sieveOf(ballOf({}, 1, 4), 100)},
      {"a sieve", sieveOf(ballOf(), 10)},
      {"a bowl", bowl(24)},
      {"a bowl inside out", insideOut(bowl(24))},
      {"a bowl with a ball through its cap", together(bowl(24), ballOf({0, 0.2, 0.05}, 0.5))},
      {"two bowls, one within the other", together(bowl(24), moved(bowl(24), {0.1, 0.2, -0.3}))},
      {"a trough", trough},
      {"a twisted band", twistedBand(40, 0.3, 1)},
      {"loose triangles", randomTriangles(200, 1, 0.4)},
      {"a few triangles",
       onlyFaces(blockOf({0, 0, 0}, {1, 1, 1}, 1), [](std::size_t i) { return i > 1; })},
  };
}

template <typename T>
class SignCellsTest : public ::testing::Test {};
TYPED_TEST_SUITE(SignCellsTest, Precisions);

/// In all cells: at random points, in the middle of sides, in corners, which may be those of
/// others.
template <typename Visit>
void forPointsOfCells(const SignCells& cells, Visit visit) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> share(0, 1);
  for (std::size_t n = 0; n < cells.size(); ++n) {
    const auto count = [&](std::size_t a) { return static_cast<std::size_t>(cells.counts()[a]); };
    const std::array cell{static_cast<std::int32_t>(n % count(0)),
                          static_cast<std::int32_t>(n / count(0) % count(1)),
                          static_cast<std::int32_t>(n / count(0) / count(1))};
    ASSERT_EQ(cells.numberOf(cell), n);
    const auto box = cells.box(cell, cell);
    for (int i = 0; i < scaled(2); ++i) {
      Vec3<double> part{share(random), share(random), share(random)};
      if (random() % 4 == 0) part[static_cast<int>(random() % 3)] = 0.5;
      const auto size = box.size();
      visit(box, box.lower + Vec3<double>{part.x * size.x, part.y * size.y, part.z * size.z});
    }
    visit(box, box.lower);
    visit(box, box.upper);
  }
}

TYPED_TEST(SignCellsTest, TellTheTruth) {
  using T = TypeParam;
  int known = 0;
  for (const auto& [name, soup] : openSurfaces()) {
    const auto index = indexOf<T>(soup);
    const auto& cells = index.signCells();
    const auto& winding = *index.winding();
    int wrong = 0;
    int points = 0;
    forPointsOfCells(cells, [&](const Box<double>&, const Vec3<double>& p) {
      const auto cell = cells.at(p);
      const bool isInside = winding.isInside(index.surface(), index.trianglesAlong(), p);
      ++points;
      if (cell.side() != 0) wrong += (cell.side() < 0) == isInside ? 0 : 1;
      if (const auto least = cell.leastInside()) {
        const int closed = winding.closedWinding(index.surface(), index.trianglesAlong(), p);
        wrong += (closed >= *least) == isInside ? 0 : 1;
      }
      // Caps are not nearer than what is told of them.
      double nearest = std::numeric_limits<double>::infinity();
      for (std::uint32_t id = 0; id < winding.caps().triangles.size(); ++id) {
        const auto [a, b, c] = winding.caps().corners(id);
        const Triangle<double> triangle{a, b, c, true};
        nearest = std::min(nearest, std::sqrt(triangleDistance(p, triangle).distanceSquared));
      }
      wrong += cells.isFarFromCaps(p, 1.0001 * nearest + 1e-12) ? 1 : 0;
    });
    EXPECT_EQ(wrong, 0) << name;
    EXPECT_GT(points, 100) << name;
    known += index.layout().signCells.count > 0 ? 1 : 0;
  }
  EXPECT_GE(known, 5);  // others have a hole almost everywhere
}

TYPED_TEST(SignCellsTest, KnowMostOfTheSpace) {
  using T = TypeParam;
  const auto shares = [](const PolygonSoup& soup) {
    const auto index = indexOf<T>(soup);
    int least = 0;
    int sides = 0;
    int points = 0;
    forPointsOfCells(index.signCells(), [&](const Box<double>&, const Vec3<double>& p) {
      ++points;
      const auto cell = index.signCells().at(p);
      least += cell.leastInside() ? 1 : 0;
      sides += cell.side() != 0 ? 1 : 0;
    });
    return std::pair(static_cast<double>(least) / points, static_cast<double>(sides) / points);
  };
  const auto [least, sides] =
      shares(onlyFaces(ballOf({}, 1, 5), [](std::size_t i) { return i > 20; }));
  EXPECT_GT(least, 0.9);
  EXPECT_GT(sides, 0.6);
  EXPECT_GT(shares(bowl(64)).first, 0.7);
  EXPECT_EQ(indexOf<T>(ballOf()).layout().signCells.count, 0U);  // closed
}

/// Points in rows, and in blocks, as grids have them, around and across the surface.
template <typename T>
std::vector<Vec3<T>> gridPoints(const Box<T>& box, int n, const Vec3<T>& offset) {
  std::vector<Vec3<T>> points;
  const Vec3<T> size = box.size();
  for (int block = 0; block < n * n * n; ++block) {
    for (int i = 0; i < 64; ++i) {
      const auto at = [&](int axis, int shift) {
        const int b = axis == 0 ? block % n : axis == 1 ? block / n % n : block / n / n;
        const T share = static_cast<T>(4 * b + (i >> shift) % 4) / static_cast<T>(4 * n - 1);
        return box.lower[axis] + (T(1.2) * share - T(0.1)) * size[axis] + offset[axis];
      };
      points.push_back({at(0, 0), at(1, 2), at(2, 4)});
    }
  }
  return points;
}

TYPED_TEST(SignCellsTest, ValuesOfBatchesAreThoseOfAllTriangles) {
  using T = TypeParam;
  for (const auto& [name, soup] : openSurfaces()) {
    const MeshSDF<T> mesh(soup);
    ASSERT_EQ(mesh.signReport().scheme, SignScheme::WindingNumber) << name;
    const MeshSDF<T> plain(soup,
                           {.signs = SignScheme::WindingNumber, .findSelfIntersections = false});
    const auto box = mesh.surfaceBox();
    for (const T offset : {T(0), T(0.0123)}) {
      const auto points = gridPoints<T>(box, 5, {offset, offset, -offset});
      std::vector<T> values(points.size());
      mesh.signedDistances(points, values);
      std::vector<SurfacePoint<T>> hits(points.size());
      mesh.closestPoints(points, hits);
      int different = 0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const T expected = plain.signedDistance(points[i]);
        different += sameBits(values[i], expected) && sameBits(hits[i].distance, expected) &&
                             sameBits(mesh.signedDistance(points[i]), expected)
                         ? 0
                         : 1;
      }
      EXPECT_EQ(different, 0) << name;
    }
  }
}

/// The values of two points of a box differ by no more than they are apart where it is told so.
TYPED_TEST(SignCellsTest, BoxesAwayFromHolesHaveALipschitzConstant) {
  using T = TypeParam;
  for (const auto& [name, soup] : openSurfaces()) {
    Solid<T> solid = MeshSDF<T>(soup);
    solid.rotate(T(31), {1, 2, 3});
    EXPECT_FALSE(solid.guarantee().lipschitz) << name;
    std::mt19937_64 random(4);
    std::uniform_real_distribution<T> share(0, 1);
    const auto around = solid.boundingBox();
    const auto pointIn = [&](const Box<T>& box) {
      const T x = share(random);
      const T y = share(random);
      return box.lower + Vec3<T>{x * box.size().x, y * box.size().y, share(random) * box.size().z};
    };
    const T rounding = 4 * solid.guarantee().error(length(around.lower) + length(around.upper));
    int known = 0;
    for (int i = 0; i < scaled(200); ++i) {
      const auto corner = pointIn(around);
      const T size = share(random) * share(random) * T(0.5) * maxComponent(around.size());
      const Box<T> box{corner, corner + Vec3<T>{size, size, size}};
      const auto lipschitz = solid.lipschitzIn(box);
      if (!lipschitz) continue;
      ++known;
      EXPECT_EQ(*lipschitz, 1);
      for (int k = 0; k < 10; ++k) {
        const auto p = pointIn(box);
        const auto q = pointIn(box);
        EXPECT_LE(std::abs(solid.signedDistance(p) - solid.signedDistance(q)),
                  length(p - q) + rounding)
            << name;
      }
    }
    EXPECT_GT(known, 0) << name;
  }
  const Solid<T> bowlOfMany = MeshSDF<T>(bowl(24));
  const auto all = bowlOfMany.boundingBox();
  EXPECT_FALSE(bowlOfMany.lipschitzIn(all));
  EXPECT_FALSE(bowlOfMany.lipschitzIn({}));
  EXPECT_FALSE(bowlOfMany.lipschitzIn(Box<T>::everywhere()));
  EXPECT_EQ(MeshSDF<T>(ballOf()).lipschitzIn(all), T(1));
}

}  // namespace
}  // namespace cutwater::test
