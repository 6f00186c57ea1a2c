#include <Cutwater/Grid/Fill.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Surface/WriteSurface.hpp>

#include <bit>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "Bindings/CApiHandles.hpp"
#include "Support/Random.hpp"
#include "Support/Soups.hpp"
#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {
namespace {

/// Two bodies of a patch each that do not meet, with edges and vertices of many faces.
PolygonSoup twoPatches() {
  PolygonSoup soup = together(bipyramid(60), withPoints(lPrism(), [](const Vec3<double>& p) {
                                return p + Vec3<double>{1.25, 0.5, -0.3};
                              }));
  soup.patchNames = {"fans", "prism"};
  for (std::size_t i = 120; i < soup.polygonCount(); ++i) soup.patches[i] = 1;
  return soup;
}

/// A mesh of two patches less a ball, with a box beside it, moved: through C, and by the library.
struct Both {
  SolidHandle c{nullptr, &cw_free};
  Solid<double> solid = Sphere<double>({0, 0, 0}, 1);
};

Both composite() {
  const TemporaryFolder folder;
  const std::string file = (folder / "two.obj").string();
  writeSurface(file, twoPatches());
  const double center[3] = {0.1, 0.2, 0.9};
  const double lower[3] = {-3, -1, -1};
  const double upper[3] = {-2, 1, 0.5};
  const double offset[3] = {0.3, -0.2, 0.1};
  const double axis[3] = {1, 2, 3};
  const double through[3] = {0.5, 0, -1};
  const auto mesh = made([&](auto* r) { return cw_read_surface(file.c_str(), 1.5, 1, r); });
  const auto ball = made([&](auto* r) { return cw_sphere(center, 0.5, r); });
  const auto box = made([&](auto* r) { return cw_box(lower, upper, r); });
  const auto less = made([&](auto* r) { return cw_difference(mesh.get(), ball.get(), r); });
  const std::array<const cw_solid*, 2> parts{less.get(), box.get()};
  const auto all = made([&](auto* r) { return cw_union(parts.data(), 2, r); });
  const auto moved = made([&](auto* r) { return cw_translated(all.get(), offset, r); });

  const auto soup = readSurface(file, {.scale = 1.5, .placement = {}}).soup;
  Solid<double> solid = (MeshSDF<double>(soup) - Sphere<double>({0.1, 0.2, 0.9}, 0.5)) |
                        Cuboid<double>({-3, -1, -1}, {-2, 1, 0.5});
  solid.translate({0.3, -0.2, 0.1});
  solid.rotate(37, {1, 2, 3}, {0.5, 0, -1});
  return {made([&](auto* r) { return cw_rotated(moved.get(), 37, axis, through, r); }), solid};
}

std::vector<Vec3<double>> queryPoints(std::size_t count) {
  RandomPoints<double> random(4, /*seed=*/3);
  std::vector<Vec3<double>> points(count);
  for (auto& p : points) p = random.next();
  points[count / 2].y = std::numeric_limits<double>::quiet_NaN();
  return points;
}

bool sameBits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST(CApiTest, BatchesOfPointsHaveTheLibrarysBits) {
  const auto both = composite();
  const auto points = queryPoints(70'000);  // more than closest points are asked for at once
  const auto n = static_cast<std::int64_t>(points.size());
  std::vector<double> distances(points.size());
  std::vector<cw_surface_point> nearest(points.size());
  ASSERT_EQ(cw_signed_distances(both.c.get(), &points[0].x, n, distances.data(), 0), CW_OK);
  ASSERT_EQ(cw_closest_points(both.c.get(), &points[0].x, n, nearest.data(), 2), CW_OK);
  std::array<int, 4> ofPatch{};
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto expected = both.solid.closestPoint(points[i]);
    const auto& found = nearest[i];
    ASSERT_TRUE(sameBits(distances[i], both.solid.signedDistance(points[i]))) << i;
    ASSERT_TRUE(sameBits(found.distance, expected.distance)) << i;
    ASSERT_TRUE(sameBits(found.tolerance, expected.tolerance)) << i;
    for (int k = 0; k < 3; ++k) {
      ASSERT_TRUE(sameBits(found.point[k], expected.point[k])) << i;
      ASSERT_TRUE(sameBits(found.normal[k], expected.normal[k])) << i;
    }
    ASSERT_EQ(static_cast<std::uint32_t>(found.patch), expected.owner.patch) << i;
    ASSERT_EQ(static_cast<std::uint32_t>(found.face), expected.owner.face) << i;
    if (i != points.size() / 2) ++ofPatch.at(expected.owner.patch);
  }
  for (const int count : ofPatch) EXPECT_GT(count, 100);
}

TEST(CApiTest, BoxesHaveTheLibrarysClasses) {
  const auto both = composite();
  RandomPoints<double> random(3, /*seed=*/5);
  std::vector<Box<double>> boxes(20'000);
  for (auto& box : boxes) {
    const auto at = random.next();
    box = {at, at + Vec3<double>{0.2, 0.1, 0.3}};
  }
  std::vector<std::uint8_t> classes(boxes.size());
  ASSERT_EQ(cw_classify_boxes(both.c.get(), &boxes[0].lower.x,
                              static_cast<std::int64_t>(boxes.size()), classes.data(), 0),
            CW_OK);
  std::array<int, 4> seen{};
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    ASSERT_EQ(classes[i], static_cast<std::uint8_t>(both.solid.classify(boxes[i]))) << i;
    ++seen.at(classes[i]);
  }
  EXPECT_GT(seen[CW_INSIDE], 100);
  EXPECT_GT(seen[CW_OUTSIDE], 100);
  EXPECT_GT(seen[CW_CUT], 100);
}

TEST(CApiTest, GridsAreFilledInPlace) {
  const auto both = composite();
  const Level<double> level({-4, -4, -4}, {0.25, 0.2, 0.3}, Centering::Cell);
  const IndexBox indices{{-2, 3, 4}, {30, 33, 20}};
  const std::array<std::size_t, 3> n{indices.length(0), indices.length(1), indices.length(2)};
  // z fastest and downwards, two values for each index.
  const cw_grid grid{
      {-4, -4, -4},
      {0.25, 0.2, 0.3},
      {-2, 3, 4},
      {30, 33, 20},
      {static_cast<std::int64_t>(2 * n[1] * n[2]), static_cast<std::int64_t>(2 * n[2]), -2},
      0};
  std::vector<double> values(2 * indices.count(), 77);
  std::vector<std::int32_t> patches(values.size(), 77);
  const std::size_t start = 2 * (n[2] - 1);
  ASSERT_EQ(cw_fill(both.c.get(), &grid, 3, values.data() + start, patches.data() + start, 0),
            CW_OK);
  std::vector<double> expected(indices.count());
  std::vector<std::uint32_t> expectedPatches(indices.count());
  fill(both.solid, GridPatch<double>{level, indices},
       {.distance = GridView<double>::contiguous(expected.data(), indices),
        .patch = GridView<std::uint32_t>::contiguous(expectedPatches.data(), indices)},
       {.band = 3, .progress = {}});
  std::size_t beyond = 0;
  for (std::size_t i = 0; i < n[0]; ++i) {
    for (std::size_t j = 0; j < n[1]; ++j) {
      for (std::size_t k = 0; k < n[2]; ++k) {
        const std::size_t here = 2 * ((i * n[1] + j) * n[2] + (n[2] - 1 - k));
        const std::size_t there = (k * n[1] + j) * n[0] + i;
        ASSERT_TRUE(sameBits(values[here], expected[there]));
        ASSERT_EQ(static_cast<std::uint32_t>(patches[here]), expectedPatches[there]);
        ASSERT_EQ(values[here + 1], 77);
        beyond += patches[here] == -1 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(beyond, 100U);
  EXPECT_LT(beyond, indices.count() - 100);
}

TEST(CApiTest, ClassifiesTheCellsOfAGrid) {
  const auto both = composite();
  const IndexBox indices{{-2, 3, 4}, {30, 33, 20}};
  const cw_grid grid{{-4, -4, -4}, {0.25, 0.2, 0.3}, {-2, 3, 4}, {30, 33, 20}, {0, 0, 0}, 0};
  std::vector<std::uint8_t> classes(indices.count(), 77);
  ASSERT_EQ(cw_classify_cells(both.c.get(), &grid, classes.data(), 0), CW_OK);
  const Level<double> level({-4, -4, -4}, {0.25, 0.2, 0.3});
  std::size_t n = 0;
  std::array<int, 4> count{};
  for (int k = 4; k <= 20; ++k) {
    for (int j = 3; j <= 33; ++j) {
      for (int i = -2; i <= 30; ++i, ++n) {
        ASSERT_EQ(classes[n], static_cast<int>(both.solid.classify(level.cell({i, j, k}))));
        ++count[classes[n]];
      }
    }
  }
  EXPECT_GT(count[CW_OUTSIDE], 100);
  EXPECT_GT(count[CW_CUT], 100);
}

TEST(CApiTest, KnowsItsBoxAndPatches) {
  const auto both = composite();
  Box<double> box;
  ASSERT_EQ(cw_bounding_box(both.c.get(), &box.lower.x, &box.upper.x), CW_OK);
  EXPECT_EQ(box.lower, both.solid.boundingBox().lower);
  EXPECT_EQ(box.upper, both.solid.boundingBox().upper);
  const auto names = both.solid.patchNames();
  std::int32_t count = 0;
  ASSERT_EQ(cw_patch_count(both.c.get(), &count), CW_OK);
  ASSERT_EQ(static_cast<std::size_t>(count), names.size());
  for (std::int32_t i = 0; i < count; ++i) {
    const char* name = nullptr;
    ASSERT_EQ(cw_patch_name(both.c.get(), i, &name), CW_OK);
    EXPECT_EQ(name, names[static_cast<std::size_t>(i)]);
  }
}

TEST(CApiTest, PatchesWithoutNamesAreNumbered) {
  const auto soup = tetrahedron();
  const std::vector<std::int32_t> triangles(soup.corners.begin(), soup.corners.end());
  const std::vector<std::int32_t> patches{0, 1, 2, 1};
  cw_mesh mesh{&soup.points[0].x, 4, triangles.data(), 4, patches.data(), 3, nullptr};
  const auto solid = made([&](auto* r) { return cw_from_mesh(&mesh, 1, r); });
  const char* name = nullptr;
  ASSERT_EQ(cw_patch_name(solid.get(), 2, &name), CW_OK);
  EXPECT_STREQ(name, "patch 2");

  mesh.patches = nullptr;
  mesh.patchCount = 0;
  const auto plain = made([&](auto* r) { return cw_from_mesh(&mesh, 1, r); });
  std::int32_t count = 0;
  ASSERT_EQ(cw_patch_count(plain.get(), &count), CW_OK);
  EXPECT_EQ(count, 1);
}

TEST(CApiTest, ManyThreadsAskAtOnceAndEachHasItsOwnError) {
  const auto both = composite();
  const auto points = queryPoints(2'000);
  const auto n = static_cast<std::int64_t>(points.size());
  std::vector<double> expected(points.size());
  ASSERT_EQ(cw_signed_distances(both.c.get(), &points[0].x, n, expected.data(), 1), CW_OK);
  std::vector<std::vector<double>> found(6, std::vector<double>(points.size()));
  std::vector<std::string> messages(found.size());
  std::vector<std::thread> threads;
  for (std::size_t t = 0; t < found.size(); ++t) {
    threads.emplace_back([&, t] {
      cw_solid* none = nullptr;
      const double center[3] = {0, 0, 0};
      EXPECT_STREQ(cw_last_error(), "");
      EXPECT_EQ(cw_sphere(center, -1.0 - static_cast<double>(t), &none), CW_ERROR_ARGUMENT);
      EXPECT_EQ(cw_signed_distances(both.c.get(), &points[0].x, n, found[t].data(), 1), CW_OK);
      messages[t] = cw_last_error();
    });
  }
  for (auto& thread : threads) thread.join();
  for (std::size_t t = 0; t < found.size(); ++t) {
    EXPECT_NE(messages[t].find("-" + std::to_string(t + 1)), std::string::npos) << messages[t];
    EXPECT_EQ(std::memcmp(found[t].data(), expected.data(), points.size() * sizeof(double)), 0);
  }
}

}  // namespace
}  // namespace cutwater::test
