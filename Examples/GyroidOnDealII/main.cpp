// A gyroid sheet, thinner than the cells around it, on a mesh of deal.II. See README.md.
#include <Cutwater/Adapters/DealII.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>

#include <cmath>
#include <cstdio>
#include <numbers>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_generator.h>

using namespace cutwater;
using dealii::NonMatching::LocationToLevelSet;

namespace {

/// The sheet |g| < 0.1 around a gyroid of two periods in the unit cube. Each component of g's
/// gradient is at most the wave number, so that sqrt(3) of these are a Lipschitz constant.
Solid<double> gyroidSheet() {
  constexpr double kWave = 4 * std::numbers::pi;
  const auto sheet = [](const Vec3<double>& p) {
    const auto q = kWave * p;
    const double g = std::sin(q.x) * std::cos(q.y) + std::sin(q.y) * std::cos(q.z) +
                     std::sin(q.z) * std::cos(q.x);
    return std::abs(g) - 0.1;
  };
  const Guarantee<double> promise{
      .lipschitz = std::sqrt(3.0) * kWave, .continuous = true, .ulps = 200};
  return FunctionSDF<double, decltype(sheet)>(sheet, promise);
}

/// How many cells deal.II's own classifier says the sheet meets.
std::size_t seenByMeshClassifier(const dealii::Triangulation<3>& mesh,
                                 const dealii::Function<3>& levelSet) {
  const dealii::FE_Q<3> element(1);
  dealii::NonMatching::MeshClassifier<3> classifier(mesh, levelSet, element);
  classifier.reclassify();
  std::size_t count = 0;
  for (const auto& cell : mesh.active_cell_iterators()) {
    if (classifier.location_to_level_set(cell) == LocationToLevelSet::intersected) ++count;
  }
  return count;
}

struct Volumes {
  double fluid = 0;        // of cells that are all fluid
  double intersected = 0;  // of cells that are neither all fluid nor all body
  double sampled = 0;      // of the fluid in these, from 5 x 5 x 5 points of each
  std::size_t cells = 0;   // that are intersected
};

Volumes volumes(const dealii::Triangulation<3>& mesh, const DealIIClassifier<3>& classifier,
                const dealii::Function<3>& levelSet) {
  const dealii::QIterated<3> samples(dealii::QMidpoint<1>(), 5);
  std::vector<dealii::Point<3>> points(samples.size());
  std::vector<double> values(samples.size());
  Volumes sum;
  for (const auto& cell : mesh.active_cell_iterators()) {
    const auto location = classifier.location(cell);
    if (location == LocationToLevelSet::inside) sum.fluid += cell->measure();
    if (location != LocationToLevelSet::intersected) continue;
    ++sum.cells;
    sum.intersected += cell->measure();
    const auto box = cell->bounding_box();
    for (unsigned int i = 0; i < points.size(); ++i) points[i] = box.unit_to_real(samples.point(i));
    levelSet.value_list(points, values);
    for (unsigned int i = 0; i < values.size(); ++i) {
      if (values[i] < 0) sum.sampled += samples.weight(i) * cell->measure();
    }
  }
  return sum;
}

}  // namespace

int main() {
  const FluidDomain<double> domain(gyroidSheet(), FluidSide::Outside, {0.125, 0, 0});
  const DealIIFunction<3> levelSet(domain);
  DealIIClassifier<3> classifier(domain);

  dealii::Triangulation<3> mesh;
  dealii::GridGenerator::hyper_cube(mesh);
  mesh.refine_global(4);
  Volumes sum;
  bool isSound = true;
  for (int level = 4;; ++level) {
    classifier.reclassify(mesh);
    sum = volumes(mesh, classifier, levelSet);
    const auto seen = seenByMeshClassifier(mesh, levelSet);
    std::printf(
        "level %d: %zu of %u cells may be cut (MeshClassifier sees %zu); fluid %.4f, "
        "certainly in %.4f .. %.4f\n",
        level, sum.cells, mesh.n_active_cells(), seen, sum.fluid + sum.sampled, sum.fluid,
        sum.fluid + sum.intersected);
    isSound =
        isSound && seen < sum.cells && sum.fluid <= 0.9356 && 0.9356 <= sum.fluid + sum.intersected;
    if (level == 6) break;
    for (const auto& cell : mesh.active_cell_iterators()) {
      if (classifier.location(cell) == LocationToLevelSet::intersected) cell->set_refine_flag();
    }
    mesh.execute_coarsening_and_refinement();
  }
  // The true share of the fluid, from a sum over 613 x 613 x 613 points, is 0.93563.
  return isSound && std::abs(sum.fluid + sum.sampled - 0.9356) < 1e-3 ? 0 : 1;
}
