// Cells of surfaces that meet themselves: against unions of tetrahedra in rational numbers, and
// against unions of meshes by CGAL.

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <cmath>
#include <random>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <gtest/gtest.h>

#include "Support/CutIdentities.hpp"
#include "Support/DamagedSoups.hpp"
#include "Support/Scale.hpp"
#include "Support/Shells.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {
namespace {

/// A convex polyhedron in rational numbers: its faces, counterclockwise as seen from outside.
class RationalBody {
 public:
  using Number = CGAL::Gmpq;
  using Point = std::array<Number, 3>;
  using Face = std::vector<Point>;

  explicit RationalBody(const PolygonSoup& soup) {
    for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
      auto& face = faces_.emplace_back();
      for (const auto corner : soup.polygon(i)) {
        const auto& p = soup.points[corner];
        face.push_back({Number(p.x), Number(p.y), Number(p.z)});
      }
    }
  }

  /// The volume of what bodies have in common. No two may have faces in one plane.
  static Number common(const std::vector<const RationalBody*>& bodies) {
    Number sum(0);
    for (const auto* body : bodies) {
      for (auto face : body->faces_) {
        for (const auto* other : bodies) {
          if (other != body) face = other->within(face);
        }
        for (std::size_t k = 2; k < face.size(); ++k) {
          sum += product(face[0], normalOf(face[k - 1], face[k])) / 6;
        }
      }
    }
    return sum;
  }

 private:
  static Point difference(const Point& a, const Point& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }
  static Number product(const Point& a, const Point& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  static Point normalOf(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }
  /// The part of a convex polygon in this body (Sutherland and Hodgman 1974).
  [[nodiscard]] Face within(Face polygon) const {
    for (const auto& face : faces_) {
      const auto n = normalOf(difference(face[1], face[0]), difference(face[2], face[0]));
      Face left;
      for (std::size_t i = 0; i < polygon.size(); ++i) {
        const auto& p = polygon[i];
        const auto& q = polygon[(i + 1) % polygon.size()];
        const Number atP = product(n, difference(p, face[0]));
        const Number atQ = product(n, difference(q, face[0]));
        if (atP <= 0) left.push_back(p);
        if ((atP < 0 && atQ > 0) || (atP > 0 && atQ < 0)) {
          auto& cut = left.emplace_back();
          for (std::size_t k = 0; k < 3; ++k) cut[k] = p[k] + atP / (atP - atQ) * (q[k] - p[k]);
        }
      }
      polygon = std::move(left);
    }
    return polygon;
  }

  std::vector<Face> faces_;
};

PolygonSoup someTetrahedron(std::mt19937& random) {
  auto soup = tetrahedron();
  std::uniform_real_distribution<double> number(0.05, 0.95);
  do {
    for (auto& p : soup.points) p = {number(random), number(random), number(random)};
  } while (volumeOf(soup) < 0.02);
  return soup;
}

CutCells cutUnion(const PolygonSoup& soup, int n, FluidSide side) {
  return CellCutter(Solid<double>(MeshSDF<double>(soup)), side)
      .cut(GridPatch<double>{Level<double>({0, 0, 0}, {1.0 / n, 1.0 / n, 1.0 / n}),
                             IndexBox::ofSize(n, n, n)});
}

/// By inclusion and exclusion, in each cell.
TEST(CutUnionsTest, TetrahedraInRationals) {
  std::mt19937 random(21);
  std::size_t meeting = 0;
  for (int round = 0; round < scaled(12) && !HasFailure(); ++round) {
    const auto a = someTetrahedron(random);
    const auto b = someTetrahedron(random);
    const auto c = someTetrahedron(random);
    const RationalBody inA(a);
    const RationalBody inB(b);
    const RationalBody inC(c);
    const int n = 1 + round % 3;
    const auto cells = cutUnion(joined({a, b, c}), n, FluidSide::Inside);
    expectIdentities(cells, 1e-12);
    meeting += check(cells).meetingCells;
    for (int number = 0; number < n * n * n; ++number) {
      const Index3 index{number % n, number / n % n, number / n / n};
      const auto box = cells.boxOf(index);
      const RationalBody cell(tessellation::box(box.lower, box.upper));
      const auto common = [&](std::vector<const RationalBody*> bodies) {
        bodies.push_back(&cell);
        return RationalBody::common(bodies);
      };
      const auto exact = common({&inA}) + common({&inB}) + common({&inC}) - common({&inA, &inB}) -
                         common({&inB, &inC}) - common({&inA, &inC}) + common({&inA, &inB, &inC});
      EXPECT_NEAR(fluidIn(cells, index), CGAL::to_double(exact), 1e-15) << number;
    }
  }
  EXPECT_GT(meeting, 20U);
}

using CgalKernel = CGAL::Exact_predicates_exact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<CgalKernel::Point_3>;

CgalMesh cgalMesh(const PolygonSoup& soup) {
  CgalMesh mesh;
  std::vector<CgalMesh::Vertex_index> vertices;
  for (const auto& p : soup.points) vertices.push_back(mesh.add_vertex({p.x, p.y, p.z}));
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto p = soup.polygon(i);
    mesh.add_face(vertices[p[0]], vertices[p[1]], vertices[p[2]]);
  }
  return mesh;
}

/// A torus and a ball: in cells where they meet, and in others.
TEST(CutUnionsTest, MeshesByCgal) {
  namespace pmp = CGAL::Polygon_mesh_processing;
  auto torus = triangulated(moved(tessellation::torus(0.25, 0.1, 40, 20), {0.5, 0.5, 0.5}));
  auto ball = triangulated(moved(tessellation::icosphere(0.2, 3), {0.71, 0.52, 0.55}));
  auto first = cgalMesh(torus);
  auto second = cgalMesh(ball);
  CgalMesh whole;
  ASSERT_TRUE(pmp::corefine_and_compute_union(first, second, whole));
  const double volume = CGAL::to_double(pmp::volume(whole));
  double area = 0;
  for (const auto face : whole.faces()) {
    area += std::sqrt(CGAL::to_double(pmp::squared_face_area(face, whole)));
  }
  for (const int n : {1, 2, 7, 24, 50}) {
    const auto cells = cutUnion(joined({torus, ball}), n, FluidSide::Outside);
    expectIdentities(cells, 1e-12);
    const auto report = check(cells);
    EXPECT_NEAR(report.bodyVolume, volume, 1e-14);
    EXPECT_NEAR(report.fluidVolume, 1 - volume, 1e-14);
    EXPECT_NEAR(report.wallArea, area, 1e-11);
    EXPECT_GT(report.meetingCells, 0U);
    if (n > 20) {
      EXPECT_LT(4 * report.meetingCells, report.cutCells);
    }
    const auto inside = cutUnion(joined({torus, ball}), n, FluidSide::Inside);
    expectIdentities(inside, 1e-12);
    EXPECT_NEAR(check(inside).fluidVolume, volume, 1e-14);
    EXPECT_NEAR(check(inside).wallArea, area, 1e-11);
  }
}

}  // namespace
}  // namespace cutwater::test
