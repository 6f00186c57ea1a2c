// Self-intersections held against CGAL: whole meshes against its own search, pairs of triangles
// against intersections constructed in exact arithmetic.

#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Surface/SelfIntersections.hpp>
#include <Cutwater/Triangles/TriangleIntersection.hpp>

#include <random>
#include <set>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

using Corners = std::array<std::uint32_t, 3>;
using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

/// What CGAL finds in a soup that is a manifold mesh, numbered like the soup's polygons; faces
/// without area as pairs with themselves.
Pairs pairsByCgal(const PolygonSoup& soup) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  using Mesh = CGAL::Surface_mesh<Point>;
  namespace Processing = CGAL::Polygon_mesh_processing;
  std::vector<Point> points;
  for (const auto& p : soup.points) points.emplace_back(p.x, p.y, p.z);
  std::vector<std::vector<std::size_t>> faces;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto corners = soup.polygon(i);
    faces.emplace_back(corners.begin(), corners.end());
  }
  EXPECT_TRUE(Processing::is_polygon_soup_a_polygon_mesh(faces));
  Mesh mesh;
  Processing::polygon_soup_to_polygon_mesh(points, faces, mesh);
  std::vector<std::pair<Mesh::Face_index, Mesh::Face_index>> found;
  Processing::self_intersections(mesh, std::back_inserter(found));
  Pairs pairs;
  for (const auto& [a, b] : found) pairs.emplace(std::minmax<std::uint32_t>(a, b));
  return pairs;
}

std::vector<Corners> trianglesOf(const PolygonSoup& soup) {
  std::vector<Corners> triangles;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto corners = soup.polygon(i);
    EXPECT_EQ(corners.size(), 3U);
    triangles.push_back({corners[0], corners[1], corners[2]});
  }
  return triangles;
}

struct KnownMesh {
  const char* name;
  const char* file;
  bool intersects;
};

void PrintTo(const KnownMesh& mesh, std::ostream* out) {
  *out << mesh.name;
}

class KnownMeshTest : public ::testing::TestWithParam<KnownMesh> {};

TEST_P(KnownMeshTest, FindsThePairsThatCgalFinds) {
  const auto soup = readSurface(GetParam().file).soup;
  const auto triangles = trianglesOf(soup);
  auto expected = pairsByCgal(soup);
  const auto flat = std::erase_if(expected, [](const auto& p) { return p.first == p.second; });
  EXPECT_EQ(!expected.empty(), GetParam().intersects);

  const auto found = findSelfIntersections<double>(soup.points, triangles);
  EXPECT_TRUE(found.complete);
  EXPECT_EQ(found.skippedTriangles, flat);
  // As many pairs, and each of CGAL's among ours: the same set.
  EXPECT_EQ(found.pairs.count, expected.size());
  for (const auto& [a, b] : expected) {
    EXPECT_TRUE(findSelfIntersections<double>(soup.points, std::array{triangles[a], triangles[b]}))
        << a << " and " << b;
  }
  auto next = expected.begin();
  for (const auto& pair : found.pairs.examples) {
    EXPECT_EQ(std::pair(index(pair.first), index(pair.second)), *next++);
  }
}

const KnownMesh kMeshes[] = {
    {"hull", CUTWATER_OPENFOAM_EXAMPLES "/resources/geometry/DTC-scaled.stl.gz", false},
    {"elephant", CUTWATER_CGAL_MESHES "/elephant.off", false},
    {"fandisk", CUTWATER_CGAL_MESHES "/fandisk.off", false},
    {"armadillo", CUTWATER_CGAL_MESHES "/armadillo.off", false},
    {"ALSTOMTEST4", CUTWATER_CGAL_MESHES "/ALSTOM_TEST4.off", true},
    {"ChineseDragon10kv", CUTWATER_CGAL_MESHES "/ChineseDragon-10kv.off", true},
    {"bones", CUTWATER_CGAL_MESHES "/bones.off", true},
    {"bull", CUTWATER_CGAL_MESHES "/bull.off", true},
    {"camel", CUTWATER_CGAL_MESHES "/camel.off", true},
    {"degtrisliding", CUTWATER_CGAL_MESHES "/degtri_sliding.off", true},
    {"man", CUTWATER_CGAL_MESHES "/man.off", true},
    {"mannequindevil", CUTWATER_CGAL_MESHES "/mannequin-devil.off", true},
    {"maskcone", CUTWATER_CGAL_MESHES "/mask_cone.off", true},
    {"tetraintersectedbytriangle", CUTWATER_CGAL_MESHES "/tetra_intersected_by_triangle.off", true},
};
INSTANTIATE_TEST_SUITE_P(Meshes, KnownMeshTest, ::testing::ValuesIn(kMeshes),
                         [](const auto& mesh) { return std::string(mesh.param.name); });

/// Constructs what two triangles have in common, and looks whether it is more than they share.
class ExactOracle {
 public:
  explicit ExactOracle(std::span<const Vec3<double>> points) {
    for (const auto& p : points) points_.emplace_back(p.x, p.y, p.z);
  }

  [[nodiscard]] bool hasArea(const Corners& t) const { return !triangle(t).is_degenerate(); }

  [[nodiscard]] bool intersect(const Corners& a, const Corners& b) const {
    std::vector<Point> shared;
    for (const auto corner : a) {
      if (std::find(b.begin(), b.end(), corner) != b.end()) shared.push_back(points_[corner]);
    }
    if (shared.size() == 3) return true;
    const auto common = CGAL::intersection(triangle(a), triangle(b));
    if (!common) return false;
    if (const auto* point = boost::get<Point>(&*common)) {
      return shared.size() != 1 || *point != shared[0];
    }
    if (const auto* segment = boost::get<Kernel::Segment_3>(&*common)) {
      const Kernel::Segment_3 edge(shared.empty() ? Point() : shared.front(),
                                   shared.empty() ? Point() : shared.back());
      return shared.size() != 2 || (*segment != edge && *segment != edge.opposite());
    }
    return true;  // an area
  }

 private:
  using Kernel = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  using Point = Kernel::Point_3;

  [[nodiscard]] Kernel::Triangle_3 triangle(const Corners& t) const {
    return {points_[t[0]], points_[t[1]], points_[t[2]]};
  }

  std::vector<Point> points_;
};

/// Random triangles among points from a small grid, so that every coincidence occurs: shared,
/// touching, collinear, coplanar, equal positions under different numbers.
struct GridSoup {
  std::vector<Vec3<double>> points;
  std::vector<Corners> triangles;

  GridSoup(std::mt19937& engine, int levels, int thickness, std::size_t pointCount,
           std::size_t triangleCount) {
    const auto below = [&](auto n) {
      return static_cast<int>(engine() % static_cast<unsigned>(n));
    };
    for (std::size_t i = 0; i < pointCount; ++i) {
      const int x = below(levels);
      const int y = below(levels);
      points.push_back({1.0 * x, 1.0 * y, 1.0 * below(thickness)});
    }
    for (std::size_t i = 0; i < triangleCount; ++i) {
      Corners t{};
      for (auto& corner : t) corner = static_cast<std::uint32_t>(below(pointCount));
      triangles.push_back(t);
    }
  }
};

/// The count and the examples of a search against all pairs by the oracle.
void expectOraclesPairs(const GridSoup& soup) {
  const auto& [points, triangles] = soup;
  const ExactOracle oracle(points);
  std::size_t flat = 0;
  Pairs expected;
  for (std::uint32_t i = 0; i < triangles.size(); ++i) {
    if (!oracle.hasArea(triangles[i])) {
      ++flat;
      continue;
    }
    for (std::uint32_t j = i + 1; j < triangles.size(); ++j) {
      if (!oracle.hasArea(triangles[j])) continue;
      const bool meet = oracle.intersect(triangles[i], triangles[j]);
      if (meet) expected.emplace(i, j);
      for (const auto& [a, b] : {std::pair(i, j), std::pair(j, i)}) {
        ASSERT_EQ(intersect(points, triangles[a], triangles[b]), meet)
            << points[triangles[a][0]] << points[triangles[a][1]] << points[triangles[a][2]] << ", "
            << points[triangles[b][0]] << points[triangles[b][1]] << points[triangles[b][2]];
      }
    }
  }
  const auto found = findSelfIntersections<double>(points, triangles);
  EXPECT_EQ(found.skippedTriangles, flat);
  EXPECT_EQ(found.pairs.count, expected.size());
  auto next = expected.begin();
  for (const auto& pair : found.pairs.examples) {
    ASSERT_EQ(std::pair(index(pair.first), index(pair.second)), *next++);
  }
}

TEST(SelfIntersectionsTest, AgreeWithExactConstructionsOnGridSoups) {
  std::mt19937 engine(7);
  for (int round = 0; round < scaled(40); ++round) {
    expectOraclesPairs(GridSoup(engine, 4, 4, 30, 24));   // points often shared
    expectOraclesPairs(GridSoup(engine, 3, 3, 200, 24));  // seldom
    expectOraclesPairs(GridSoup(engine, 5, 1, 20, 20));   // all in a plane
    expectOraclesPairs(GridSoup(engine, 6, 2, 60, 24));
  }
}

TEST(SelfIntersectionsTest, AgreeWithExactConstructionsOnNearlyDegenerateSoups) {
  // A grid's coincidences undone in the last digit: only exact predicates see by how much.
  std::mt19937 engine(8);
  for (int round = 0; round < scaled(20); ++round) {
    GridSoup soup(engine, 3, 3, 40, 24);
    for (auto& p : soup.points) {
      for (int axis = 0; axis < 3; ++axis) {
        p[axis] = std::nextafter(0.1 + 0.3 * p[axis], static_cast<double>(engine() % 3U));
      }
    }
    expectOraclesPairs(soup);
  }
}

TEST(SelfIntersectionsTest, AgreeWithExactConstructionsOnRandomSoups) {
  std::mt19937 engine(9);
  std::uniform_real_distribution<double> unit;
  for (int round = 0; round < scaled(5); ++round) {
    GridSoup soup(engine, 2, 2, 60, 60);
    for (auto& p : soup.points) p = {unit(engine), unit(engine), unit(engine)};
    expectOraclesPairs(soup);
  }
}

}  // namespace
}  // namespace cutwater::test
