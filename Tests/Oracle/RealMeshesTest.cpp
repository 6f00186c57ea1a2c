// Distances and signs on surfaces from real files, held against CGAL and quadruple precision.

#include <Cutwater/Mesh/DcelSDF.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include "Oracle/CgalOracle.hpp"
#include "Oracle/Probes.hpp"
#include "Support/Precisions.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

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

class RealMeshesTest : public ::testing::TestWithParam<RealSurface> {
 protected:
  const PolygonSoup soup_ = triangulated(readSurface(GetParam().file).soup);
};

TEST_P(RealMeshesTest, TakesFewBytesPerTriangle) {
  const auto triangles = soup_.polygonCount();
  if (triangles < 5'000) GTEST_SKIP() << "nodes and leaves of small trees are not full";
  EXPECT_LE(MeshSDF<double>(soup_).memoryBytes(), 150 * triangles);
  EXPECT_LE(MeshSDF<float>(soup_).memoryBytes(), 110 * triangles);
}

TEST_P(RealMeshesTest, ClassifiesBoxesAsCgalDoes) {
  const MeshSDF<double> mesh(soup_);
  const CgalOracle oracle(soup_);
  Probes probes(soup_, 23);
  const double size = soup_.boundingBox().diagonal();
  const int count = scaled(3'000);
  int cut = 0;
  int unknown = 0;
  for (int i = 0; i < count; ++i) {
    const auto corner = probes.next();
    const auto spread = abs(probes.next() - soup_.boundingBox().center());
    const auto extent =
        std::pow(10.0, -0.5 * (i % 8)) * (0.1 * spread + 1e-3 * Vec3<double>{size, size, size});
    const Box<double> box{corner, corner + extent};
    const auto kind = mesh.classify(box);
    const auto bounds = mesh.bounds(box);
    if (kind == BoxClass::Unknown) {
      ++unknown;
    } else {
      ASSERT_EQ(kind == BoxClass::Cut, oracle.meets(box)) << i;
    }
    cut += kind == BoxClass::Cut ? 1 : 0;
    if (kind != BoxClass::Cut && kind != BoxClass::Unknown) {
      ASSERT_EQ(kind == BoxClass::Inside, oracle.isInside(box.center())) << i;
    }
    for (int k = 0; k < 8; ++k) ASSERT_TRUE(bounds.contains(mesh.signedDistance(box.corner(k))));
  }
  EXPECT_GT(cut, count / 20);
  EXPECT_LT(unknown, count / 200 + 2);
}

TEST_P(RealMeshesTest, AgreesWithCgalInDistanceAndSign) {
  const MeshSDF<double> mesh(soup_);
  EXPECT_EQ(mesh.signReport().turnedShells, GetParam().turnedShells);
  const CgalOracle oracle(soup_);
  const double size = mesh.guarantee().size;
  Probes probes(soup_, 11);
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
  Probes probes(rounded, 12);
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
  Probes probes(soup, 13);
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
