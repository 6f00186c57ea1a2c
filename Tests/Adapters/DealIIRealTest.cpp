// With deal.II itself: what its own classifier and quadratures make of our functions.
#include <Cutwater/Adapters/DealII.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q1.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/hp/q_collection.h>
#include <deal.II/non_matching/fe_immersed_values.h>
#include <deal.II/non_matching/quadrature_generator.h>
#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

using dealii::NonMatching::LocationToLevelSet;
using Mesh = dealii::Triangulation<3>;

FluidDomain<double> within(const Solid<double>& solid, const Vec3<double>& fluidPoint) {
  return {solid, FluidSide::Inside, fluidPoint};
}

void refine(Mesh& mesh, unsigned int times) {
  dealii::GridGenerator::hyper_cube(mesh);
  mesh.refine_global(times);
}

/// How many cells each classifier says are intersected. Where ours is certain, they must agree.
std::pair<std::size_t, std::size_t> intersected(const Mesh& mesh,
                                                const FluidDomain<double>& domain) {
  const DealIIFunction<3> levelSet(domain);
  const dealii::FE_Q<3> element(1);  // must outlive the classifier
  dealii::NonMatching::MeshClassifier<3> theirs(mesh, levelSet, element);
  theirs.reclassify();
  DealIIClassifier<3> ours(domain);
  ours.reclassify(mesh);
  std::pair<std::size_t, std::size_t> count{0, 0};
  for (const auto& cell : mesh.active_cell_iterators()) {
    const auto our = ours.location(cell);
    const auto their = theirs.location_to_level_set(cell);
    count.first += our == LocationToLevelSet::intersected ? 1 : 0;
    count.second += their == LocationToLevelSet::intersected ? 1 : 0;
    if (our != LocationToLevelSet::intersected) {
      EXPECT_EQ(our, their) << cell->center();
    }
  }
  return count;
}

TEST(DealIIRealTest, AgreesWithMeshClassifierWhereThatSeesTheSurface) {
  Mesh mesh;
  refine(mesh, 5);
  const Vec3<double> center{0.5012, 0.4987, 0.5031};
  const auto [ours, theirs] = intersected(mesh, within(Sphere<double>(center, 0.3), center));
  EXPECT_LE(theirs, ours);
  EXPECT_GT(static_cast<double>(theirs), 0.9 * static_cast<double>(ours));
}

TEST(DealIIRealTest, FindsTheBallInsideOneCellThatMeshClassifierMisses) {
  Mesh mesh;
  refine(mesh, 2);
  const Vec3<double> center{0.375, 0.375, 0.375};
  const auto [ours, theirs] = intersected(mesh, within(Sphere<double>(center, 0.05), center));
  EXPECT_EQ(ours, 1U);
  EXPECT_EQ(theirs, 0U);
}

/// Volume of the fluid and area of the surface, by deal.II's quadratures in the cells that we say
/// are intersected.
std::pair<double, double> measures(const Mesh& mesh, const FluidDomain<double>& domain) {
  const DealIIFunction<3> levelSet(domain, {.hessianStep = 1e-5});
  DealIIClassifier<3> classifier(domain);
  classifier.reclassify(mesh);
  const dealii::hp::QCollection<1> rules{dealii::QGauss<1>(3)};  // must outlive the generator
  dealii::NonMatching::QuadratureGenerator<3> generator(rules);
  double volume = 0;
  double area = 0;
  for (const auto& cell : mesh.active_cell_iterators()) {
    const auto location = classifier.location(cell);
    if (location == LocationToLevelSet::inside) volume += cell->measure();
    if (location != LocationToLevelSet::intersected) continue;
    generator.generate(levelSet, cell->bounding_box());
    for (const double weight : generator.get_inside_quadrature().get_weights()) volume += weight;
    for (const double weight : generator.get_surface_quadrature().get_weights()) area += weight;
  }
  return {volume, area};
}

// Needs values, gradients and Hessians, in every cell.
TEST(DealIIRealTest, QuadraturesOfCutCellsMeasureASphere) {
  Mesh mesh;
  refine(mesh, 4);
  const Vec3<double> center{0.5012, 0.4987, 0.5031};
  const auto [volume, area] = measures(mesh, within(Sphere<double>(center, 0.3), center));
  EXPECT_NEAR(volume, 4 * std::numbers::pi / 3 * 0.027, 1e-6);
  EXPECT_NEAR(area, 4 * std::numbers::pi * 0.09, 1e-5);
}

const Vec3<double> kCenter{0.5012, 0.4987, 0.5531};
constexpr double kRadius = 0.3;

/// Boxes of three widths, of three levels around a sphere.
void refineAroundSphere(Mesh& mesh) {
  dealii::GridGenerator::subdivided_hyper_rectangle(mesh, {5, 4, 6}, {0, 0, 0}, {1.1, 0.9, 1.2});
  const Sphere<double> sphere(kCenter, kRadius);
  DealIIClassifier<3> classifier({sphere, FluidSide::Outside, {0.01, 0.01, 0.01}});
  for (int times = 0; times < 2; ++times) {
    classifier.reclassify(mesh);
    for (const auto& cell : mesh.active_cell_iterators()) {
      const bool isCut = classifier.location(cell) == LocationToLevelSet::intersected;
      if (isCut && cell->center()[0] < 0.6) cell->set_refine_flag();
    }
    mesh.execute_coarsening_and_refinement();
  }
}

/// (x^2, y z, x z^2), and its divergence.
dealii::Tensor<1, 3> flowAt(const dealii::Point<3>& p) {
  return dealii::Point<3>(p[0] * p[0], p[1] * p[2], p[0] * p[2] * p[2]);
}
double divergenceAt(const dealii::Point<3>& p) {
  return 2 * p[0] + p[2] + 2 * p[0] * p[2];
}

/// By FEValues, FEImmersedSurfaceValues and FEFaceValues with a piece's quadratures.
class PieceIntegrals {
 public:
  template <typename Cell>
  void add(const Cell& cell, const DealIIPiece& piece) {
    double inside = 0;
    dealii::FEValues<3> values(element_, piece.inside, flags_);
    values.reinit(cell);
    for (const auto q : values.quadrature_point_indices()) {
      volume += values.JxW(q);
      inside += values.JxW(q) * divergenceAt(values.quadrature_point(q));
    }
    double outwards = 0;
    if (piece.surface.size() > 0) {
      dealii::NonMatching::FEImmersedSurfaceValues<3> wall(mapping_, element_, piece.surface,
                                                           flags_ | dealii::update_normal_vectors);
      wall.reinit(cell);
      for (const auto q : wall.quadrature_point_indices()) {
        area += wall.JxW(q);
        outwards += wall.JxW(q) * (flowAt(wall.quadrature_point(q)) * wall.normal_vector(q));
        const auto out =
            wall.quadrature_point(q) - dealii::Point<3>(kCenter.x, kCenter.y, kCenter.z);
        worstNormal = std::max(worstNormal, (wall.normal_vector(q) + out / out.norm()).norm());
      }
    }
    for (const unsigned face : cell->face_indices()) {
      if (piece.faces[face].size() == 0) continue;
      dealii::FEFaceValues<3> open(element_, piece.faces[face],
                                   flags_ | dealii::update_normal_vectors);
      open.reinit(cell, face);
      for (const auto q : open.quadrature_point_indices()) {
        const auto p = open.quadrature_point(q);
        outwards += open.JxW(q) * (flowAt(p) * open.normal_vector(q));
        const Vec3<double> from = Vec3<double>{p[0], p[1], p[2]} - kCenter;
        if (length(from) < kRadius) ++pointsInBody;
      }
    }
    worstFlow = std::max(worstFlow, std::abs(inside - outwards) / cell->measure());
  }

  double volume = 0;
  double area = 0;
  double worstNormal = 0;
  double worstFlow = 0;  // through a piece's boundary, less its sources, over the cell's volume
  int pointsInBody = 0;

 private:
  const dealii::UpdateFlags flags_ = dealii::update_JxW_values | dealii::update_quadrature_points;
  const dealii::FE_Q<3> element_{1};
  const dealii::MappingQ1<3> mapping_;
};

TEST(DealIIRealTest, PiecesAreIntegratedByItsValues) {
  Mesh mesh;
  refineAroundSphere(mesh);
  const SolidCutter cutter(Solid<double>(Sphere<double>(kCenter, kRadius)), FluidSide::Outside,
                           {.points = 5});
  const DealIICutCells cut(cutter, mesh);
  PieceIntegrals sum;
  for (const auto& cell : mesh.active_cell_iterators()) {
    if (cut.location(cell) == LocationToLevelSet::inside) sum.volume += cell->measure();
    for (std::size_t n = 0; n < cut.pieceCount(cell); ++n) sum.add(cell, cut.piece(cell, n));
  }
  const double ball = 4 * std::numbers::pi / 3 * std::pow(kRadius, 3);
  EXPECT_NEAR(sum.volume, 1.1 * 0.9 * 1.2 - ball, 1e-8);
  EXPECT_NEAR(sum.area, 3 * ball / kRadius, 1e-6);
  EXPECT_LT(sum.worstNormal, 1e-12);
  EXPECT_LT(sum.worstFlow, 1e-4);
  EXPECT_EQ(sum.pointsInBody, 0);
}

TEST(DealIIRealTest, CellsThatAreNoBoxesAreRefused) {
  Mesh mesh;
  dealii::GridGenerator::hyper_ball(mesh);
  const SolidCutter cutter(Solid<double>(Sphere<double>(kCenter, kRadius)));
  EXPECT_THROW(DealIICutCells(cutter, mesh), Error);
}

}  // namespace
}  // namespace cutwater::test
