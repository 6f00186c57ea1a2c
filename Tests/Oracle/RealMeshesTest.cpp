// Distances and signs on surfaces from real files, held against CGAL and quadruple precision.

#include <Cutwater/Mesh/DcelSDF.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Mesh/ReadSurface.hpp>

#include <memory>
#include <random>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include "Support/Precisions.hpp"
#include "Support/Scale.hpp"
#include "Support/TriangleOracle.hpp"

namespace cutwater::test {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using SurfaceMesh = CGAL::Surface_mesh<Point>;
using AabbPrimitive = CGAL::AABB_face_graph_triangle_primitive<SurfaceMesh>;
using AabbTree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, AabbPrimitive>>;

/// The surface as CGAL sees it.
class CgalOracle {
 public:
  explicit CgalOracle(const PolygonSoup& soup) {
    std::vector<Point> points;
    for (const auto& p : soup.points) points.emplace_back(p.x, p.y, p.z);
    std::vector<std::vector<std::size_t>> faces;
    for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
      const auto corners = soup.polygon(i);
      faces.emplace_back(corners.begin(), corners.end());
    }
    CGAL::Polygon_mesh_processing::orient_polygon_soup(points, faces);  // splits touching vertices
    CGAL::Polygon_mesh_processing::polygon_soup_to_polygon_mesh(points, faces, mesh_);
    tree_ = std::make_unique<AabbTree>(mesh_.faces().begin(), mesh_.faces().end(), mesh_);
    tree_->accelerate_distance_queries();
    side_ = std::make_unique<CGAL::Side_of_triangle_mesh<SurfaceMesh, Kernel>>(mesh_);
  }

  /// Distance to the triangle that CGAL finds nearest, in quadruple precision.
  Float128 distance(const Vec3<double>& p) const {
    const auto face = tree_->closest_point_and_primitive({p.x, p.y, p.z}).second;
    std::array<Vec3<double>, 3> corner;
    std::size_t i = 0;
    for (const auto v : CGAL::vertices_around_face(mesh_.halfedge(face), mesh_)) {
      const auto& q = mesh_.point(v);
      corner[i++] = {q.x(), q.y(), q.z()};
    }
    return triangleDistanceExactly(p, corner[0], corner[1], corner[2]);
  }
  bool isInside(const Vec3<double>& p) const {
    return (*side_)({p.x, p.y, p.z}) == CGAL::ON_BOUNDED_SIDE;
  }

 private:
  SurfaceMesh mesh_;
  std::unique_ptr<AabbTree> tree_;
  std::unique_ptr<CGAL::Side_of_triangle_mesh<SurfaceMesh, Kernel>> side_;
};

struct RealSurface {
  const char* name;
  const char* file;
  std::size_t turnedShells = 0;
};

void PrintTo(const RealSurface& surface, std::ostream* out) {
  *out << surface.name;
}

const RealSurface kSurfaces[] = {
    {"hull", CUTWATER_OPENFOAM_EXAMPLES "/resources/geometry/DTC-scaled.stl.gz"},
    {"flange", CUTWATER_OPENFOAM_EXAMPLES "/resources/geometry/flange.stl.gz"},
    {"bullet", CUTWATER_OPENFOAM_EXAMPLES "/resources/geometry/bullet.stl.gz"},
    {"simpleCar",
     CUTWATER_OPENFOAM_EXAMPLES
     "/heatTransfer/buoyantSimpleFoam/simpleCarSolarPanel/constant/triSurface/simpleCar.stl.gz",
     1},
    {"NACA0012", CUTWATER_OPENFOAM_EXAMPLES
     "/compressible/rhoSimpleFoam/aerofoilNACA0012/constant/geometry/NACA0012.obj.gz"},
    {"rotating", CUTWATER_OPENFOAM_EXAMPLES
     "/mesh/foamyHexMesh/mixerVessel/constant/triSurface/rawSurfaces/rotating.stl.gz"},
    {"elephant", CUTWATER_CGAL_MESHES "/elephant.off"},
    {"fandisk", CUTWATER_CGAL_MESHES "/fandisk.off"},
    {"armadillo", CUTWATER_CGAL_MESHES "/armadillo.off"},
};

/// Probes where it matters: beside faces, edges and vertices, from 1e-12 to 1 diagonal away.
class Probes {
 public:
  Probes(const MeshSDF<double>& mesh, unsigned seed)
      : mesh_(mesh), diagonal_(mesh.boundingBox().diagonal()), engine_(seed) {}

  Vec3<double> next() {
    std::uniform_real_distribution<double> unit;
    const auto id = static_cast<std::uint32_t>(engine_() % mesh_.triangleCount());
    const auto corner = mesh_.triangle(id);
    double u = unit(engine_);
    double v = unit(engine_);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const auto where = engine_() % 4;  // in the face (twice as often), on an edge, on a vertex
    if (where == 1) v = 0;
    if (where == 2) u = v = 0;
    const auto foot = corner[0] + u * (corner[1] - corner[0]) + v * (corner[2] - corner[0]);
    const double reach = diagonal_ * std::pow(10.0, -12 * unit(engine_));
    return foot + reach * direction();
  }

 private:
  Vec3<double> direction() {
    std::normal_distribution<double> gauss;
    const double x = gauss(engine_);
    const double y = gauss(engine_);
    const double z = gauss(engine_);
    return normalized(Vec3<double>{x, y, z});
  }

  const MeshSDF<double>& mesh_;
  double diagonal_;
  std::mt19937 engine_;
};

class RealMeshesTest : public ::testing::TestWithParam<RealSurface> {
 protected:
  const PolygonSoup soup_ = readSurface(GetParam().file).soup;
};

TEST_P(RealMeshesTest, AgreesWithCgalInDistanceAndSign) {
  const MeshSDF<double> mesh(soup_);
  EXPECT_EQ(mesh.signReport().turnedShells, GetParam().turnedShells);
  const CgalOracle oracle(soup_);
  const double size = mesh.guarantee().size;
  Probes probes(mesh, 11);
  const int count = scaled(100'000);
  int inBand = 0;
  int wrong = 0;
  double worst = 0;
  for (int i = 0; i < count; ++i) {
    const auto p = probes.next();
    const auto hit = mesh.closestPoint(p);
    ASSERT_EQ(hit.distance, mesh.signedDistance(p));
    // The better of two candidates: CGAL's triangle and ours.
    const auto [a, b, c] = mesh.triangle(hit.triangle);
    const Float128 exact = std::min(oracle.distance(p), triangleDistanceExactly(p, a, b, c));
    const double unit = std::numeric_limits<double>::epsilon() * (length(p) + size);
    worst = std::max(
        worst, std::abs(static_cast<double>(Float128(std::abs(hit.distance)) - exact)) / unit);
    EXPECT_LE(std::abs(length(p - hit.point) - std::abs(hit.distance)), 16 * unit) << p;
    if (exact <= Float128(8 * unit)) {
      ++inBand;
    } else if ((hit.distance < 0) != oracle.isInside(p)) {
      ++wrong;
    }
  }
  RecordProperty("worst_eps", std::to_string(worst));
  EXPECT_LE(worst, 8.0);
  EXPECT_EQ(wrong, 0) << "of " << count;
  EXPECT_LT(inBand, count / 4);  // or the test would say little
}

TEST_P(RealMeshesTest, FloatKeepsItsErrorBound) {
  PolygonSoup rounded = soup_;
  for (auto& p : rounded.points) p = Vec3<double>(Vec3<float>(p));
  const MeshSDF<double> exact(rounded);
  const MeshSDF<float> mesh(rounded);
  const auto promise = mesh.guarantee();
  Probes probes(exact, 12);
  int ties = 0;
  for (int i = 0; i < scaled(10'000); ++i) {
    const auto p = Vec3<float>(probes.next());
    const double expected = exact.signedDistance(Vec3<double>(p));
    const double bound = promise.error(length(p));
    const double found = mesh.signedDistance(p);
    ASSERT_LE(std::abs(std::abs(found) - std::abs(expected)), bound) << p;
    // The sign may be that of a sheet that ties within rounding, and of no other.
    if (std::abs(expected) > bound && (found < 0) != (expected < 0)) {
      const auto [a, b, c] = exact.triangle(mesh.closestPoint(p).triangle);
      const auto tie = triangleDistanceExactly(Vec3<double>(p), a, b, c);
      ASSERT_LE(static_cast<double>(tie) - std::abs(expected), bound) << p;
      ++ties;
    }
  }
  EXPECT_LE(ties, scaled(10));
}

INSTANTIATE_TEST_SUITE_P(Surfaces, RealMeshesTest, ::testing::ValuesIn(kSurfaces),
                         [](const auto& surface) { return std::string(surface.param.name); });

TEST(RealMeshesTest, TheTreeChangesNoBit) {
  const auto soup = readSurface(CUTWATER_CGAL_MESHES "/elephant.off").soup;
  const MeshSDF<double> mesh(soup);
  const DcelSDF<double> brute{DcelMesh<double>(soup)};
  Probes probes(mesh, 13);
  for (int i = 0; i < scaled(2'000); ++i) {
    const auto p = probes.next();
    const auto a = mesh.closestPoint(p);
    const auto b = brute.closestPoint(p);
    ASSERT_EQ(a.distance, b.distance) << p;
    ASSERT_EQ(a.triangle, b.triangle) << p;
    ASSERT_EQ(a.feature, b.feature) << p;
  }
}

}  // namespace
}  // namespace cutwater::test
