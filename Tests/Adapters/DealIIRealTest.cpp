// With deal.II itself: what its own classifier and quadratures make of our functions.
#include <Cutwater/Adapters/DealII.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <numbers>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_generator.h>
#include <deal.II/grid/grid_tools.h>
#include <deal.II/hp/q_collection.h>
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

}  // namespace
}  // namespace cutwater::test
