// A gyroid sheet, thinner than the cells around it, on a mesh of deal.II. See README.md.
#include <Cutwater/Adapters/DealII.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include <deal.II/base/quadrature_lib.h>
#include <deal.II/fe/fe_q.h>
#include <deal.II/grid/grid_generator.h>

using namespace cutwater;
using dealii::NonMatching::LocationToLevelSet;

namespace {

/// Without it, the mesh would have the gyroid's symmetries.
constexpr Vec3<double> kShift{0.011, 0.023, 0.017};

/// The sheet |g| < 0.1 around a gyroid of two periods in the unit cube. Each component of g's
/// gradient is at most the wave number, so that sqrt(3) of these are a Lipschitz constant.
Solid<double> gyroidSheet() {
  constexpr double kWave = 4 * std::numbers::pi;
  const auto sheet = [](const Vec3<double>& p) {
    const auto q = kWave * (p - kShift);
    const double g = std::sin(q.x) * std::cos(q.y) + std::sin(q.y) * std::cos(q.z) +
                     std::sin(q.z) * std::cos(q.x);
    return std::abs(g) - 0.1;
  };
  const Guarantee<double> promise{
      .lipschitz = std::sqrt(3.0) * kWave, .continuous = true, .ulps = 200};
  return FunctionSDF<double, decltype(sheet)>(sheet, promise);
}

struct Volumes {
  double fluid = 0;        // of cells that are all fluid
  double intersected = 0;  // of cells that are neither all fluid nor all body
  double sampled = 0;      // of the fluid in these, from 5 x 5 x 5 points of each
  std::size_t cells = 0;   // that are intersected
  std::size_t missed = 0;  // with points of both signs, and not seen by MeshClassifier
};

Volumes volumes(const dealii::Triangulation<3>& mesh, const DealIIClassifier<3>& classifier,
                const dealii::Function<3>& levelSet) {
  const dealii::FE_Q<3> element(1);
  dealii::NonMatching::MeshClassifier<3> meshClassifier(mesh, levelSet, element);
  meshClassifier.reclassify();
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
    const auto inFluid = std::ranges::count_if(values, [](double value) { return value < 0; });
    const double share = static_cast<double>(inFluid) / static_cast<double>(values.size());
    sum.sampled += share * cell->measure();
    const bool isSeen =
        meshClassifier.location_to_level_set(cell) == LocationToLevelSet::intersected;
    if (0 < share && share < 1 && !isSeen) ++sum.missed;
  }
  return sum;
}

}  // namespace

int main() {
  const FluidDomain<double> domain(gyroidSheet(), FluidSide::Outside,
                                   kShift + Vec3<double>{0.125, 0, 0});
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
    std::printf(
        "level %d: %zu of %u cells may be cut; fluid %.4f, certainly in %.4f .. %.4f; "
        "MeshClassifier misses %zu\n",
        level, sum.cells, mesh.n_active_cells(), sum.fluid + sum.sampled, sum.fluid,
        sum.fluid + sum.intersected, sum.missed);
    isSound =
        isSound && sum.missed > 0 && sum.fluid <= 0.9356 && 0.9356 <= sum.fluid + sum.intersected;
    if (level == 6) break;
    for (const auto& cell : mesh.active_cell_iterators()) {
      if (classifier.location(cell) == LocationToLevelSet::intersected) cell->set_refine_flag();
    }
    mesh.execute_coarsening_and_refinement();
  }
  // The true share of the fluid, from a sum over 613 x 613 x 613 points, is 0.93563.
  return isSound && std::abs(sum.fluid + sum.sampled - 0.9356) < 1e-3 ? 0 : 1;
}
