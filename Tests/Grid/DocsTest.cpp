// The code of Docs/filling.md.
#include <Cutwater/Grid/Fill.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <gtest/gtest.h>

#include "Support/Grid.hpp"

namespace cutwater::test {
namespace {

/// A ball on a rod, each a patch of its own.
Solid<double> ballOnARod() {
  const Solid<double> ball = Sphere<double>({0, 0, 0}, 0.5);
  const Solid<double> rod = Cylinder<double>({0, 0, 0}, {0, 0, 2}, 0.1);
  return named(ball, "ball") | named(rod, "rod");
}

const Solid<double> kSolid = ballOnARod();

/// Cells of 1/16: those of a grid patch, and two rows of ghost cells around it.
const Level<double> kLevel({-1, -1, -1}, {1.0 / 16, 1.0 / 16, 1.0 / 16});
const IndexBox kOwned{{0, 0, 0}, {15, 15, 15}};

/// Where the index's value stands in an array that `contiguous` describes.
std::size_t placeOf(const Index3& index, const IndexBox& box) {
  return static_cast<std::size_t>(index.i - box.lo.i) +
         box.length(0) * (static_cast<std::size_t>(index.j - box.lo.j) +
                          box.length(1) * static_cast<std::size_t>(index.k - box.lo.k));
}

TEST(DocsTest, DistancesOnAGridPatchWithGhostCells) {
  const auto& solid = kSolid;
  // [DOCS
  const Level<double> level({-1, -1, -1}, {1.0 / 16, 1.0 / 16, 1.0 / 16});  // origin, spacing
  // 16^3 cells, with two ghost cells on each side.
  const GridPatch<double> gridPatch{level, {{-2, -2, -2}, {17, 17, 17}}};

  std::vector<double> distances(gridPatch.indices.count());
  fill(solid, gridPatch, GridView<double>::contiguous(distances.data(), gridPatch.indices));
  // DOCS]
  forEachIndex(gridPatch.indices, [&](const Index3& index) {
    ASSERT_EQ(distances[placeOf(index, gridPatch.indices)],
              kSolid.signedDistance(level.position(index)));
  });

  // The neighbour's own cells, which are ghost cells of the grid patch above, have the same bits.
  const GridPatch<double> next{level, {{16, 0, 0}, {31, 15, 15}}};
  std::vector<double> owned(next.indices.count());
  fill(solid, next, GridView<double>::contiguous(owned.data(), next.indices));
  for (std::int32_t k = 0; k < 16; ++k) {
    EXPECT_EQ(distances[placeOf({17, 3, k}, gridPatch.indices)],
              owned[placeOf({17, 3, k}, next.indices)]);
  }
}

TEST(DocsTest, OneComponentOfAnInterleavedArray) {
  const auto& solid = kSolid;
  const GridPatch<double> gridPatch{kLevel, kOwned};
  // [DOCS
  // 5 unknowns per cell, side by side; the last one is the distance.
  std::vector<double> unknowns(5 * gridPatch.indices.count());
  const auto nx = static_cast<std::ptrdiff_t>(gridPatch.indices.length(0));
  const auto ny = static_cast<std::ptrdiff_t>(gridPatch.indices.length(1));
  const GridView<double> view{unknowns.data() + 4, {5, 5 * nx, 5 * nx * ny}};
  fill(solid, gridPatch, view);
  // DOCS]
  forEachIndex(kOwned, [&](const Index3& index) {
    const auto place = 5 * placeOf(index, kOwned);
    ASSERT_EQ(unknowns[place + 4], kSolid.signedDistance(kLevel.position(index)));
    ASSERT_EQ(unknowns[place + 3], 0);
  });
}

TEST(DocsTest, DistancesAndPatchesOfABand) {
  const auto& solid = kSolid;
  const GridPatch<double> gridPatch{kLevel, kOwned};
  std::vector<double> distances(gridPatch.indices.count());
  // [DOCS
  std::vector<std::uint32_t> patches(gridPatch.indices.count());
  const FillTargets<double> targets{
      .distance = GridView<double>::contiguous(distances.data(), gridPatch.indices),
      .patch = GridView<std::uint32_t>::contiguous(patches.data(), gridPatch.indices)};
  fill(solid, gridPatch, targets, {.band = 3});
  const std::vector<std::string> names = solid.patchNames();  // names[patches[n]], unless kNone
  // DOCS]
  ASSERT_EQ(names, (std::vector<std::string>{"ball", "rod"}));
  std::array<int, 2> found{};
  forEachIndex(kOwned, [&](const Index3& index) {
    const auto place = placeOf(index, kOwned);
    const double value = kSolid.signedDistance(kLevel.position(index));
    const double end = 3.0 / 16;
    if (std::abs(value) <= end) {
      ASSERT_EQ(distances[place], value);
      ASSERT_LT(patches[place], names.size());
      ++found[patches[place]];
    } else {
      ASSERT_EQ(distances[place], value < 0 ? -end : end);
      ASSERT_EQ(patches[place], kNone);
    }
  });
  EXPECT_GT(found[0], 100);
  EXPECT_EQ(found[1], 0) << "the rod begins in the ball, and leaves it above these cells";
}

TEST(DocsTest, ClosestPointsAndClassesOfCells) {
  const auto& solid = kSolid;
  const GridPatch<double> gridPatch{kLevel, kOwned};
  // [DOCS
  std::vector<double> distances(gridPatch.indices.count());
  std::vector<Vec3<double>> points(gridPatch.indices.count());
  std::vector<Vec3<double>> normals(gridPatch.indices.count());
  std::vector<BoxClass> classes(gridPatch.indices.count());
  fill(solid, gridPatch,
       {.distance = GridView<double>::contiguous(distances.data(), gridPatch.indices),
        .closestPoint = GridView<Vec3<double>>::contiguous(points.data(), gridPatch.indices),
        .normal = GridView<Vec3<double>>::contiguous(normals.data(), gridPatch.indices),
        .boxClass = GridView<BoxClass>::contiguous(classes.data(), gridPatch.indices)},
       {.band = 3});
  // DOCS]
  int cut = 0;
  int near = 0;
  forEachIndex(kOwned, [&](const Index3& index) {
    const auto place = placeOf(index, kOwned);
    ASSERT_EQ(classes[place], kSolid.classify(kLevel.cell(index)));
    const auto hit = kSolid.closestPoint(kLevel.position(index));
    if (std::abs(distances[place]) < 3 * kLevel.smallestSpacing()) {
      ASSERT_EQ(distances[place], hit.distance);
      ASSERT_EQ(points[place], hit.point);
      ASSERT_EQ(normals[place], hit.normal);
      ++near;
    } else {
      ASSERT_TRUE(std::isnan(points[place].x) && std::isnan(normals[place].x));
    }
    cut += classes[place] == BoxClass::Cut ? 1 : 0;
  });
  EXPECT_GT(cut, 50);
  EXPECT_GT(near, 100);
}

TEST(DocsTest, LevelsOfAHierarchy) {
  const auto& solid = kSolid;
  // [DOCS
  std::vector<std::vector<double>> levels;
  for (std::int32_t n = 16; n <= 64; n *= 2) {
    const Level<double> nodes({-1, -1, -1}, {2.0 / n, 2.0 / n, 2.0 / n}, Centering::Node);
    const IndexBox all = IndexBox::ofSize(n + 1, n + 1, n + 1);
    auto& values = levels.emplace_back(all.count());
    fill(solid, {nodes, all}, GridView<double>::contiguous(values.data(), all), {.band = n / 4.0});
  }  // on each level the band ends at 1/2
  // DOCS]
  // A node of the coarsest level is every fourth of the finest, with the same bits.
  const IndexBox coarse = IndexBox::ofSize(17, 17, 17);
  const IndexBox fine = IndexBox::ofSize(65, 65, 65);
  int inBand = 0;
  forEachIndex(coarse, [&](const Index3& i) {
    const double here = levels[0][placeOf(i, coarse)];
    ASSERT_EQ(here, levels[2][placeOf({4 * i.i, 4 * i.j, 4 * i.k}, fine)]);
    inBand += std::abs(here) < 0.5 ? 1 : 0;
  });
  EXPECT_GT(inBand, 500);
}

}  // namespace
}  // namespace cutwater::test
