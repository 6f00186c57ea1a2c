#include <Cutwater/Adapters/SingleValuedCells.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/ConvexPolyhedron.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "Support/Grid.hpp"

namespace cutwater::test {
namespace {

/// Fields of a box, each in an array of its own.
template <typename T>
class Fields {
 public:
  Fields(const SingleValuedCells& cells, const IndexBox& box)
      : box_(box), kinds_(box.count(), FluidClass::Unknown) {
    views_ = {.kind = GridView<FluidClass>::contiguous(kinds_.data(), box),
              .volumeFraction = add({0, 0, 0}),
              .centroid = {add({0, 0, 0}), add({0, 0, 0}), add({0, 0, 0})},
              .wallArea = add({0, 0, 0}),
              .wallCentroid = {add({0, 0, 0}), add({0, 0, 0}), add({0, 0, 0})},
              .wallNormal = {add({0, 0, 0}), add({0, 0, 0}), add({0, 0, 0})},
              .aperture = {add({1, 0, 0}), add({0, 1, 0}), add({0, 0, 1})},
              .faceCentroid = {{{add({1, 0, 0}), add({1, 0, 0})},
                                {add({0, 1, 0}), add({0, 1, 0})},
                                {add({0, 0, 1}), add({0, 0, 1})}}},
              .edgeCentroid = {add({0, 1, 1}), add({1, 0, 1}), add({1, 1, 0})},
              .levelSet = add({1, 1, 1})};
    cells.fill(box, views_);
  }

  [[nodiscard]] FluidClass kind(const Index3& cell) const { return at(views_.kind, cell); }
  /// All that is known of a cell, its lower faces, its edges there and its lowest node.
  [[nodiscard]] std::vector<T> valuesAt(const Index3& cell) const {
    std::vector<T> values{at(views_.volumeFraction, cell), at(views_.wallArea, cell),
                          at(views_.levelSet, cell)};
    for (std::size_t a = 0; a < 3; ++a) {
      for (const auto& view :
           {views_.centroid[a], views_.wallCentroid[a], views_.wallNormal[a], views_.aperture[a],
            views_.faceCentroid[a][0], views_.faceCentroid[a][1], views_.edgeCentroid[a]}) {
        values.push_back(at(view, cell));
      }
    }
    return values;
  }
  [[nodiscard]] T edge(const Index3& cell, std::size_t axis) const {
    return at(views_.edgeCentroid[axis], cell);
  }
  [[nodiscard]] T aperture(const Index3& cell, std::size_t axis) const {
    return at(views_.aperture[axis], cell);
  }
  [[nodiscard]] T levelSet(const Index3& node) const { return at(views_.levelSet, node); }
  [[nodiscard]] T volumeFraction(const Index3& cell) const {
    return at(views_.volumeFraction, cell);
  }

 private:
  GridView<T> add(const std::array<int, 3>& more) {
    auto box = box_;
    box.hi.i += more[0];
    box.hi.j += more[1];
    box.hi.k += more[2];
    arrays_.emplace_back(box.count(), std::numeric_limits<T>::quiet_NaN());
    return GridView<T>::contiguous(arrays_.back().data(), box);
  }
  template <typename Value>
  [[nodiscard]] Value at(const GridView<Value>& view, const Index3& index) const {
    const auto from = [](int i, int lowest) { return static_cast<std::size_t>(i - lowest); };
    return view.at(from(index.i, box_.lo.i), from(index.j, box_.lo.j), from(index.k, box_.lo.k));
  }

  IndexBox box_;
  std::vector<FluidClass> kinds_;
  std::vector<std::vector<T>> arrays_;
  SingleValuedFields<T> views_;
};

CellPlanes cube(int n, const IndexBox& box) {
  std::array<std::vector<double>, 3> planes;
  const std::array<std::array<int, 2>, 3> ranges{
      {{box.lo.i, box.hi.i}, {box.lo.j, box.hi.j}, {box.lo.k, box.hi.k}}};
  for (std::size_t a = 0; a < 3; ++a) {
    for (int i = ranges[a][0]; i <= ranges[a][1] + 1; ++i) {
      planes[a].push_back(static_cast<double>(i) / n);
    }
  }
  return cellsBetween(planes, box.lo);
}
CellPlanes cube(int n) {
  return cube(n, IndexBox::ofSize(n, n, n));
}

Solid<double> bodyOf(const PolygonSoup& soup) {
  return MeshSDF<double>(soup);
}

/// A tilted square bar along an axis, without end as far as any box here goes.
Solid<double> bar(int axis, const Vec3<double>& center) {
  std::vector<HalfSpace<double>> sides;
  for (int side = 0; side < 4; ++side) {
    const double angle = 0.3 + side * std::numbers::pi / 2;
    Vec3<double> normal;
    normal[(axis + 1) % 3] = std::cos(angle);
    normal[(axis + 2) % 3] = std::sin(angle);
    sides.push_back({center + normal * 0.21, normal});
  }
  Vec3<double> along;
  along[axis] = 1;
  sides.push_back({along * 9.0, along});
  sides.push_back({along * -9.0, along * -1.0});
  return ConvexPolyhedron<double>(sides);
}

TEST(SingleValuedCellsTest, EdgesAreOpenWhereTheBodyIsNot) {
  const int n = 16;
  const Vec3<double> center{0.5012, 0.4987, 0.5031};
  const SolidCutter cutter(Solid<double>(Sphere<double>(center, 0.3)));
  auto cells = SingleValuedCells(cutter.cut(cube(n), {.polygons = true}));
  for (int width = 1; width <= 4; width *= 2) {
    const Fields<double> fields(cells, cells.cells().grid.indices());
    int cut = 0;
    forEachIndex(cells.cells().grid.indices(), [&](const Index3& cell) {
      for (int axis = 0; axis < 3; ++axis) {
        const auto from = cells.cells().boxOf(cell).lower - center;
        const double rest = 0.09 - (dot(from, from) - from[axis] * from[axis]);
        const double h = static_cast<double>(width) / n;
        const double half = rest > 0 ? std::sqrt(rest) : -1;
        const double low = std::clamp(-half, from[axis], from[axis] + h);
        const double high = std::clamp(half, from[axis], from[axis] + h);
        const double body = rest > 0 ? high - low : 0;
        const double value = fields.edge(cell, static_cast<std::size_t>(axis));
        if (body == 0) {
          EXPECT_EQ(value, 1);
        } else if (body == h) {
          EXPECT_EQ(value, -1);
        } else {
          const double open = h - body;
          const double middle = from[axis] + h / 2;
          EXPECT_NEAR(value, (middle * h - (low + high) / 2 * body) / open / h - middle / h, 1e-8);
          ++cut;
        }
      }
    });
    EXPECT_GT(cut, 20);
    if (width < 4) cells = cells.coarser();
  }
}

// Walls are planes but at the bar's four edges, so that what is said of cells beyond is exact.
TEST(SingleValuedCellsTest, BodiesGoOnBeyondTheBox) {
  const int n = 12;
  for (int axis = 0; axis < 3; ++axis) {
    const SolidCutter cutter(bar(axis, {0.52, 0.47, 0.55}));
    const IndexBox large{{-5, -5, -5}, {n + 4, n + 4, n + 4}};
    const SingleValuedCells own(cutter.cut(cube(n), {.polygons = true}));
    const SingleValuedCells all(cutter.cut(cube(n, large), {.polygons = true}));
    const IndexBox box{{-4, -4, -4}, {n + 3, n + 3, n + 3}};
    const Fields<double> extended(own, box);
    const Fields<double> cut(all, box);
    int beyond = 0;
    int bent = 0;
    forEachIndex(box, [&](const Index3& cell) {
      EXPECT_EQ(extended.kind(cell), cut.kind(cell));
      if (cut.kind(cell) == FluidClass::Cut && !own.cells().grid.indices().contains(cell)) ++beyond;
      const auto a = extended.valuesAt(cell);
      const auto b = cut.valuesAt(cell);
      bool isBent = false;
      for (std::size_t i = 0; i < a.size(); ++i) {
        const bool isWallCentroid = i >= 3 && (i - 3) % 7 == 1;
        EXPECT_NEAR(a[i], b[i], isWallCentroid ? 0.1 : 1e-8);
        isBent = isBent || std::abs(a[i] - b[i]) > 1e-8;
      }
      bent += isBent ? 1 : 0;
    });
    EXPECT_GT(beyond, 150);
    EXPECT_LE(bent, 4 * 8);
  }
}

// The floor is cut by two faces of the box, and by the edge between them.
TEST(SingleValuedCellsTest, BodiesGoOnBeyondEdgesOfTheBox) {
  const int n = 8;
  const SolidCutter cutter(Solid<double>(ConvexPolyhedron<double>({{{0, 0, 0.43}, {0, 0, 1}},
                                                                   {{0, 0, -9}, {0, 0, -1}},
                                                                   {{9, 0, 0}, {1, 0, 0}},
                                                                   {{-9, 0, 0}, {-1, 0, 0}},
                                                                   {{0, 9, 0}, {0, 1, 0}},
                                                                   {{0, -9, 0}, {0, -1, 0}}})));
  const SingleValuedCells cells(cutter.cut(cube(n), {.polygons = true}));
  const Fields<double> fields(cells, {{-2, -2, -2}, {n + 1, n + 1, n + 1}});
  for (const auto& [i, j] : {std::array{-2, -1}, {-2, 3}, {n, n + 1}, {4, n}}) {
    const Index3 cell{i, j, 3};
    EXPECT_EQ(fields.kind(cell), FluidClass::Cut);
    EXPECT_NEAR(fields.volumeFraction(cell), 0.56, 1e-12);
    EXPECT_NEAR(fields.aperture(cell, 0), 0.56, 1e-12);
    EXPECT_NEAR(fields.edge(cell, 2), 0.22, 1e-12);
    EXPECT_EQ(fields.aperture(cell, 2), 0);
    EXPECT_EQ(fields.kind({i, j, 2}), FluidClass::Body);
    EXPECT_EQ(fields.kind({i, j, -2}), FluidClass::Body);
    EXPECT_EQ(fields.kind({i, j, 4}), FluidClass::Fluid);
    EXPECT_EQ(fields.kind({i, j, n + 1}), FluidClass::Fluid);
  }
}

// A ball through the high face along each axis: what lies behind is its section there.
TEST(SingleValuedCellsTest, SectionsAreThoseOfTheNearestFace) {
  const int n = 10;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3<double> center{0.46, 0.53, 0.49};
    center[axis] = 0.95;
    const SolidCutter cutter(Solid<double>(Sphere<double>(center, 0.28)));
    const SingleValuedCells cells(cutter.cut(cube(n), {.polygons = true}));
    const Fields<double> fields(cells, {{0, 0, 0}, {n + 2, n + 2, n + 2}});
    int cut = 0;
    forEachIndex(IndexBox::ofSize(n, n, n), [&](const Index3& cell) {
      const auto moved = [&](int to) {
        std::array<int, 3> at{cell.i, cell.j, cell.k};
        at[static_cast<std::size_t>(axis)] = to;
        return Index3{at[0], at[1], at[2]};
      };
      const auto a = static_cast<std::size_t>(axis);
      const double open = fields.aperture(moved(n), a);
      EXPECT_EQ(fields.volumeFraction(moved(n)), open);
      EXPECT_EQ(fields.volumeFraction(moved(n + 2)), open);
      EXPECT_EQ(fields.aperture(moved(n + 2), a), open);
      cut += open > 0 && open < 1 && open != fields.aperture(moved(n - 1), a) ? 1 : 0;
    });
    EXPECT_GT(cut, 50);
  }
}

TEST(SingleValuedCellsTest, ValuesDoNotDependOnTheBox) {
  const CellCutter cutter(bodyOf(tessellation::icosphere(0.6, 3)));
  const SingleValuedCells cells(cutter.cut(cube(10), {.polygons = true}));
  const IndexBox all{{-3, -3, -3}, {12, 12, 12}};
  const Fields<double> whole(cells, all);
  std::mt19937 random(1);
  for (int n = 0; n < 30; ++n) {
    auto box = randomBox(16, random);
    for (auto* index : {&box.lo, &box.hi}) {
      *index = {index->i - 3, index->j - 3, index->k - 3};
    }
    const Fields<double> part(cells, box);
    forEachIndex(box, [&](const Index3& cell) {
      EXPECT_EQ(part.kind(cell), whole.kind(cell));
      EXPECT_EQ(part.valuesAt(cell), whole.valuesAt(cell));
    });
  }
}

TEST(SingleValuedCellsTest, EndsOfAPeriodAreOne) {
  const int n = 12;
  const SolidCutter cutter(Solid<double>(Sphere<double>({0.03, 0.52, 0.96}, 0.3)),
                           FluidSide::Outside, {.period = {1, 0, 1}});
  const auto grid = cutter.cellsOfPeriod(
      [&] {
        auto planes = cube(n).planes;
        for (auto& across : planes) across = {across.begin() + 1, across.end() - 1};
        return planes;
      }(),
      {}, IndexBox::ofSize(n, n, n));
  auto cells = SingleValuedCells(cutter.cut(grid, {.polygons = true}));
  for (int width = n; width >= 3; width /= 2) {
    const Fields<double> fields(cells, {{-2, 0, -2}, {2 * width, width - 1, 2 * width}});
    int cut = 0;
    forEachIndex({{-2, 0, -2}, {width - 1, width - 1, width - 1}}, [&](const Index3& cell) {
      const auto values = fields.valuesAt(cell);
      EXPECT_EQ(values, fields.valuesAt({cell.i + width, cell.j, cell.k}));
      EXPECT_EQ(values, fields.valuesAt({cell.i, cell.j, cell.k + width}));
      cut += fields.kind(cell) == FluidClass::Cut ? 1 : 0;
    });
    EXPECT_GT(cut, 8);
    if (cells.canCoarsen()) cells = cells.coarser();
  }
}

// Beside a cell that was covered, one that was all fluid is cut, and the edges of its closed face.
TEST(SingleValuedCellsTest, EdgesOfClosedFacesAreClosed) {
  const CellCutter cutter(bodyOf(tessellation::box({-0.5, -0.5, 0.41}, {0.45, 0.55, 0.49})));
  const IndexBox box{{0, 0, 0}, {7, 7, 7}};
  const SingleValuedCells cells(cutter.cut(cube(8, box), {.polygons = true}));
  ASSERT_FALSE(cells.lost().empty());
  const Fields<double> fields(cells, box);
  int closed = 0;
  int open = 0;
  forEachIndex({{1, 1, 0}, {6, 6, 6}}, [&](const Index3& cell) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (fields.aperture(cell, axis) != 0) continue;
      EXPECT_EQ(fields.edge(cell, (axis + 1) % 3), -1);
      EXPECT_GE(fields.levelSet(cell), 0);
      ++closed;
    }
    const auto [i, j, k] = cell;
    const bool isBesideCovered =
        fields.kind(cell) == FluidClass::Cut && fields.volumeFraction(cell) == 1;
    if (!isBesideCovered || fields.aperture(cell, 0) == 0 || fields.aperture(cell, 1) == 0 ||
        fields.aperture({i, j - 1, k}, 0) == 0 || fields.aperture({i - 1, j, k}, 1) == 0) {
      return;
    }
    EXPECT_EQ(fields.edge(cell, 2), 1);
    ++open;
  });
  EXPECT_GT(closed, 4);
  EXPECT_GT(open, 3);
}

TEST(SingleValuedCellsTest, RefusesWhatItCannotFill) {
  const CellCutter cutter(bodyOf(tessellation::icosphere(0.6, 2)));
  EXPECT_THROW(SingleValuedCells(cutter.cut(cube(8))), Error);
  EXPECT_THROW(SingleValuedCells(cutter.cut(cube(8), {.polygons = true}), {.smallest = 2}), Error);
  const auto odd = SingleValuedCells(cutter.cut(cube(5), {.polygons = true}));
  EXPECT_FALSE(odd.canCoarsen());
  EXPECT_THROW(static_cast<void>(odd.coarser()), Error);
  const CellCutter periodic(bodyOf(tessellation::icosphere(0.3, 2)), FluidSide::Outside,
                            {.period = {1, 0, 0}});
  auto planes = cube(8).planes;
  for (auto& across : planes) across = {across.begin() + 1, across.end() - 1};
  const auto half = periodic.cellsOfPeriod(planes, {}, IndexBox::ofSize(4, 8, 8));
  EXPECT_THROW(SingleValuedCells(periodic.cut(half, {.polygons = true})), Error);
}

}  // namespace
}  // namespace cutwater::test
