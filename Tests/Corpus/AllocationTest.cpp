// Every allocation fails once: the n-th, for n = 1, 2, ... until the work is done without it. Each
// time a clean exception arrives, and nothing is left behind.

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Grid/Fill.hpp>
#include <Cutwater/Mesh/DcelSDF.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Cleaning/CapOnPlane.hpp>
#include <Cutwater/Surface/Cleaning/Clean.hpp>
#include <Cutwater/Surface/Cleaning/ExtendTo.hpp>
#include <Cutwater/Surface/Cleaning/MirrorAt.hpp>
#include <Cutwater/Surface/MeshReport.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <new>

#include <gtest/gtest.h>

#include "Support/AllocationCount.hpp"
#include "Support/DamagedSoups.hpp"

namespace cutwater::test {
namespace {

constexpr long long kMany = 20'000;  // more than any work here allocates

/// Returns how many allocations had to fail until the work succeeded. A few it can do without:
/// shrink_to_fit() leaves a vector as it is, std::stable_sort() has a way without a buffer.
template <typename Work>
long long expectCleanFailures(const Work& work) {
  constexpr long long kDispensable = 8;
  work();  // what is made once and for all, such as threads and tables, is there now
  long long withstood = 0;
  for (long long n = 1; n < kMany; ++n) {
    AllocationCount count;
    count.failAt(n);
    bool hasFailed = false;
    try {
      work();
    } catch (const std::bad_alloc&) {
      hasFailed = true;
    }
    const bool isDone = count.count() < n;
    count.failAt(0);
    EXPECT_EQ(count.alive(), 0) << "allocation " << n << " of " << count.count();
    if (isDone) {
      EXPECT_FALSE(hasFailed);
      EXPECT_LE(withstood, kDispensable);
      return n - 1;
    }
    withstood += hasFailed ? 0 : 1;
  }
  ADD_FAILURE() << "it never succeeds";
  return 0;
}

std::string sample(const std::string& name) {
  std::ifstream file(std::filesystem::path(CUTWATER_CORPUS) / "files" / name, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(AllocationTest, ReadersFailCleanly) {
  for (const auto* name :
       {"stl-ascii-several-solids", "stl-binary", "obj-groups", "off-quads", "ply-ascii-extras",
        "ply-little-int-int", "ply-big-int-int", "vtk-strips-and-polygons", "vtk-ascii-offsets-lf",
        "vtk-binary-5.1", "gzip-members"}) {
    SCOPED_TRACE(name);
    const std::string bytes = sample(name);
    ASSERT_FALSE(bytes.empty());
    const auto view = std::as_bytes(std::span(bytes));
    const auto whole = readSurface(view, name).soup;
    const auto read = [&] { EXPECT_EQ(readSurface(view, name).soup.corners, whole.corners); };
    EXPECT_GT(expectCleanFailures(read), 5);
    const auto path = std::filesystem::path(CUTWATER_CORPUS) / "files" / name;
    const auto load = [&] { EXPECT_EQ(readSurface(path).soup.corners, whole.corners); };
    EXPECT_GT(expectCleanFailures(load), 5);
  }
}

/// Reads as it should not; true if it is refused. What the message needs may be missing, too.
bool isRefused(std::span<const std::byte> bytes) {
  try {
    static_cast<void>(readSurface(bytes, "name"));
  } catch (const Error&) {
    return true;
  }
  return false;
}

TEST(AllocationTest, RefusalsFailCleanly) {
  for (const auto* name : {"stl-ascii-coordinate-00", "obj-index-00", "off-one-face-less",
                           "ply-header-no-x", "vtk-offsets-last", "gzip-obj-cut"}) {
    SCOPED_TRACE(name);
    const std::string bytes = sample(name);
    const auto view = std::as_bytes(std::span(bytes));
    EXPECT_GT(expectCleanFailures([&] { EXPECT_TRUE(isRefused(view)); }), 3);
  }
}

PolygonSoup openSphere() {
  auto soup = tessellation::icosphere(1, 2);
  soup = onlyFaces(soup, [](std::size_t i) { return i > 2; });
  return soup;
}

TEST(AllocationTest, MeshesFailCleanly) {
  for (const auto& soup : {tessellation::icosphere(1, 2), openSphere()}) {
    EXPECT_GT(expectCleanFailures([&] {
                const DcelMesh<double> mesh(soup);
                static_cast<void>(check(mesh).table());
              }),
              20);
    EXPECT_GT(expectCleanFailures([&] {
                const MeshSDF<float> mesh(soup, {.findSelfIntersections = true, .probes = 16});
                EXPECT_LT(mesh.signedDistance({0, 0, 0}), 0);
              }),
              20);
    EXPECT_GT(expectCleanFailures([&] {
                auto copy = soup;
                weldExactly(copy);
                EXPECT_EQ(copy.points.size(), soup.points.size());
              }),
              5);
  }
  const auto sphere = tessellation::icosphere(1, 1);
  EXPECT_GT(expectCleanFailures([&] { DcelSDF<double>(DcelMesh<double>(sphere)); }), 10);
}

TEST(AllocationTest, CutCellsFailCleanly) {
  const Solid<double> solid(MeshSDF<double>(tessellation::torus(0.3, 0.1, 6, 4)));
  const CellCutter cutter(solid);
  const auto grid = cellsBetween({std::vector{-0.5, 0.0, 0.1, 0.5}, std::vector{-0.5, 0.05, 0.5},
                                  std::vector{-0.2, 0.01, 0.2}});
  const auto cells = cutter.cut(grid, {.threads = 1});
  ASSERT_GT(cells.pieceCount, 8U);
  EXPECT_GT(expectCleanFailures([&] { const CellCutter another(solid); }), 10);
  EXPECT_GT(expectCleanFailures([&] {
              EXPECT_EQ(cutter.cut(grid, {.polygons = true, .threads = 1}).pieces.volume,
                        cells.pieces.volume);
            }),
            50);
  EXPECT_GT(expectCleanFailures([&] { (void)cutter.cutInPlane(grid, 0.02, {.threads = 1}); }), 50);
  EXPECT_GT(expectCleanFailures([&] { (void)coarsened(cells, {3, 2, 1}); }), 20);
  EXPECT_GT(expectCleanFailures([&] { (void)merged(cells, {.smallest = 0.1}); }), 20);
}

/// Half a sphere, its faces with points of their own; some twice, turned or without area.
PolygonSoup wreckedBowl() {
  auto soup = bowl(8);
  for (std::size_t i = 0; i < 6; ++i) soup.addPolygon(soup.polygon(i));
  soup = unwelded(flipped(flipped(soup, 3), 9));
  const std::array<std::uint32_t, 3> needle{0, 1, 1};
  soup.addPolygon(needle);
  return soup;
}

TEST(AllocationTest, CleaningFailsCleanlyAndChangesNothing) {
  const auto expectUnharmed = [](const PolygonSoup& soup, auto change) {
    const auto work = [&] {
      auto copy = soup;
      try {
        change(copy);
      } catch (const std::bad_alloc&) {
        EXPECT_TRUE(copy.points == soup.points && copy.corners == soup.corners &&
                    copy.offsets == soup.offsets && copy.patches == soup.patches &&
                    copy.patchNames == soup.patchNames);
        throw;
      }
    };
    EXPECT_GT(expectCleanFailures(work), 20);
  };
  const auto wreck = wreckedBowl();
  expectUnharmed(wreck, [](PolygonSoup& soup) {
    clean(soup, {.weldWithin = 1e-6, .splitJunctionsWithin = 1e-7});
    EXPECT_GT(soup.polygonCount(), 0U);
  });
  auto open = wreck;
  clean(open);
  expectUnharmed(open, [](PolygonSoup& soup) {
    EXPECT_EQ(capOnPlane(soup, {{0, 0, 0}, {0, 0, 1}}).closed.count, 1U);
  });
  expectUnharmed(open, [](PolygonSoup& soup) {
    static_cast<void>(mirrorAt(soup, {{0, 0, 0}, {0, 0, 1}}));
  });
  expectUnharmed(open, [](PolygonSoup& soup) { static_cast<void>(extendTo(soup, 2, 1)); });
}

TEST(AllocationTest, GeometryFilesFailCleanly) {
  const MeshSDF<double> mesh(openSphere());
  EXPECT_GT(expectCleanFailures([&] { static_cast<void>(mesh.toBytes()); }), 2);
  const auto bytes = mesh.toBytes();
  EXPECT_GT(expectCleanFailures([&] {
              for (const int threads : {1, 2}) {
                static_cast<void>(MeshSDF<double>::view(bytes, {.threads = threads}));
              }
            }),
            1);
  const auto path = std::filesystem::path(CUTWATER_CORPUS) / "geometry" / "open-float";
  EXPECT_GT(expectCleanFailures([&] { static_cast<void>(MeshSDF<float>::open(path)); }), 2);
  std::vector<Vec3<double>> positions(mesh.soup().points);
  const auto moved = [&] { static_cast<void>(mesh.refitted(positions)); };
  EXPECT_GT(expectCleanFailures(moved), 2);
}

TEST(AllocationTest, BatchesAndGridsFailCleanly) {
  const Solid<double> solid =
      MeshSDF<double>(openSphere()) | Sphere<double>({2, 0, 0}, 0.5) | Sphere<double>({0, 2, 0}, 1);
  const std::vector<Vec3<double>> points(1000, Vec3<double>{0.5, 0.25, 0.125});
  std::vector<double> values(points.size());
  std::vector<SurfacePoint<double>> nearest(points.size());
  std::vector<Box<double>> boxes(points.size(), {{0, 0, 0}, {0.1, 0.1, 0.1}});
  std::vector<BoxClass> classes(points.size());
  for (const int threads : {1, 2}) {
    expectCleanFailures([&] { solid.signedDistances(points, values, {.threads = threads}); });
    expectCleanFailures([&] { solid.closestPoints(points, nearest, {.threads = threads}); });
    expectCleanFailures([&] { solid.classify(boxes, classes, {}, {.threads = threads}); });
    const Level<double> level({-2, -2, -2}, {0.25, 0.25, 0.25}, Centering::Cell);
    const IndexBox indices{{0, 0, 0}, {15, 15, 15}};
    std::vector<double> grid(4096);
    expectCleanFailures([&] {
      fill<double>(solid, {level, indices}, GridView<double>::contiguous(grid.data(), indices),
                   {.threads = threads});
    });
  }
}

}  // namespace
}  // namespace cutwater::test
