// Compiled against Mock, and against deal.II where there is one: see CMakeLists.txt.
#include <Cutwater/Adapters/DealII.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <deal.II/grid/grid_generator.h>
#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

using Location = dealii::NonMatching::LocationToLevelSet;

const Sphere<double> kBall({0.5012, 0.4987, 0.5031}, 0.3);

FluidDomain<double> around(const Solid<double>& solid) {
  return {solid, FluidSide::Outside, {0.01, 0.02, 0.03}};
}
FluidDomain<double> within(const Solid<double>& solid) {
  return {solid, FluidSide::Inside, {0.5, 0.5, 0.5}};
}

template <int dim>
dealii::BoundingBox<dim> box(const dealii::Point<dim>& lower, const dealii::Point<dim>& upper) {
  return dealii::BoundingBox<dim>(std::pair(lower, upper));
}

/// The unit cube or square in 2^times cells a side.
template <int dim>
void refine(dealii::Triangulation<dim>& mesh, unsigned int times) {
  dealii::GridGenerator::hyper_cube(mesh);
  mesh.refine_global(times);
}

TEST(DealIITest, FunctionIsNegativeInTheFluid) {
  const DealIIFunction<3> outside(around(kBall));
  const DealIIFunction<3> inside(within(kBall));
  const dealii::Point<3> p(0.1, 0.2, 0.3);
  EXPECT_EQ(outside.value(p), -kBall.signedDistance({0.1, 0.2, 0.3}));
  EXPECT_EQ(inside.value(p), kBall.signedDistance({0.1, 0.2, 0.3}));
  for (unsigned int axis = 0; axis < 3; ++axis) {
    const auto expected = kBall.gradient({0.1, 0.2, 0.3})[static_cast<int>(axis)];
    EXPECT_EQ(outside.gradient(p)[axis], -expected);
    EXPECT_EQ(inside.gradient(p)[axis], expected);
  }
}

TEST(DealIITest, ListsAreTheSameAsOneByOne) {
  const DealIIFunction<3> function(around(kBall));
  std::vector<dealii::Point<3>> points;
  for (int i = 0; i < 300; ++i) points.emplace_back(0.003 * i, 1 - 0.002 * i, std::sin(i));
  std::vector<double> values(points.size());
  const dealii::Function<3>& base = function;
  base.value_list(points, values);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_EQ(values[i], base.value(points[i]));
  values.pop_back();
  EXPECT_THROW(base.value_list(points, values), Error);
}

// Of a distance from a point: (1 - n n) / |p - center|.
template <int dim>
void expectHessian(const DealIIFunction<dim>& function, const dealii::Point<dim>& p, double side) {
  const Vec3<double> from =
      Vec3<double>{p[0], p[1], dim == 3 ? p[dim - 1] : 0.6} - Vec3<double>{0.5012, 0.4987, 0.5031};
  const auto n = from / length(from);
  auto hessian = function.hessian(p);
  for (unsigned int i = 0; i < dim; ++i) {
    for (unsigned int j = 0; j < dim; ++j) {
      const double expected =
          ((i == j ? 1 : 0) - n[static_cast<int>(i)] * n[static_cast<int>(j)]) / length(from);
      EXPECT_NEAR(hessian[i][j], side * expected, 1e-6) << i << j;
    }
  }
}

TEST(DealIITest, HessianOfASphereIsThatOfTheDistance) {
  const DealIIOptions options{.z = 0.6, .hessianStep = 1e-5};
  expectHessian<3>(DealIIFunction<3>(within(kBall), options), {0.1, 0.2, 0.3}, 1);
  expectHessian<3>(DealIIFunction<3>(around(kBall), options), {0.6, 0.9, 0.4}, -1);
  expectHessian<2>(DealIIFunction<2>(within(kBall), options), {0.1, 0.2}, 1);
}

TEST(DealIITest, WithoutAStepTheHessianIsDealIIs) {
  auto hessian = DealIIFunction<3>(around(kBall)).hessian({0.1, 0.2, 0.3});
  for (unsigned int i = 0; i < 3; ++i) {
    for (unsigned int j = 0; j < 3; ++j) EXPECT_EQ(hessian[i][j], 0);
  }
}

TEST(DealIITest, FunctionIn2DIsThatOfThePlane) {
  const DealIIFunction<2> function(around(kBall), {.z = 0.6});
  EXPECT_EQ(function.value({0.1, 0.2}), -kBall.signedDistance({0.1, 0.2, 0.6}));
  EXPECT_EQ(function.gradient({0.1, 0.2})[1], -kBall.gradient({0.1, 0.2, 0.6}).y);
}

TEST(DealIITest, LocationsAreThoseOfTheLevelSet) {
  const DealIIClassifier<3> outside(around(kBall));
  const DealIIClassifier<3> inside(within(kBall));
  const auto middle = box<3>({0.45, 0.45, 0.45}, {0.55, 0.55, 0.55});
  const auto corner = box<3>({0, 0, 0}, {0.2, 0.2, 0.2});
  const auto across = box<3>({0, 0.4, 0.4}, {0.5, 0.5, 0.5});
  EXPECT_EQ(outside.location(middle), Location::outside);
  EXPECT_EQ(outside.location(corner), Location::inside);
  EXPECT_EQ(outside.location(across), Location::intersected);
  EXPECT_EQ(inside.location(middle), Location::inside);
  EXPECT_EQ(inside.location(corner), Location::outside);
  EXPECT_EQ(inside.location(across), Location::intersected);
}

/// Least and greatest distance from the sphere's center to a cell.
std::pair<double, double> distances(const dealii::BoundingBox<3>& cell) {
  constexpr std::array kCenter{0.5012, 0.4987, 0.5031};
  const auto& [lower, upper] = cell.get_boundary_points();
  double least = 0;
  double most = 0;
  for (unsigned int axis = 0; axis < 3; ++axis) {
    const double a = lower[axis] - kCenter[axis];
    const double b = upper[axis] - kCenter[axis];
    least += a * b <= 0 ? 0 : std::min(a * a, b * b);
    most += std::max(a * a, b * b);
  }
  return {std::sqrt(least), std::sqrt(most)};
}

TEST(DealIITest, CellsAreClassifiedAsTheyLie) {
  dealii::Triangulation<3> mesh;
  refine(mesh, 4);
  DealIIClassifier<3> classifier(around(kBall));
  for (const auto& cell : mesh.active_cell_iterators()) {
    EXPECT_EQ(classifier.location(cell), Location::unassigned);
  }
  classifier.reclassify(mesh);
  EXPECT_EQ(classifier.undecided(), 0U);
  std::size_t intersected = 0;
  for (const auto& cell : mesh.active_cell_iterators()) {
    const auto [least, most] = distances(cell->bounding_box());
    const auto expected = most < 0.3    ? Location::outside
                          : least > 0.3 ? Location::inside
                                        : Location::intersected;
    EXPECT_EQ(classifier.location(cell), expected);
    intersected += expected == Location::intersected ? 1 : 0;
  }
  EXPECT_GT(intersected, 400U);
}

TEST(DealIITest, ABallInsideOneCellIsFound) {
  dealii::Triangulation<3> mesh;
  refine(mesh, 2);
  DealIIClassifier<3> classifier(around(Sphere<double>({0.375, 0.375, 0.375}, 0.05)));
  classifier.reclassify(mesh);
  std::size_t intersected = 0;
  for (const auto& cell : mesh.active_cell_iterators()) {
    intersected += classifier.location(cell) == Location::intersected ? 1 : 0;
  }
  EXPECT_EQ(intersected, 1U);
}

TEST(DealIITest, CellsIn2DAreClassifiedInThePlane) {
  dealii::Triangulation<2> mesh;
  refine(mesh, 5);
  DealIIClassifier<2> classifier(around(kBall), {.z = 0.6});
  classifier.reclassify(mesh);
  const double radius = std::sqrt(0.09 - (0.6 - 0.5031) * (0.6 - 0.5031));
  for (const auto& cell : mesh.active_cell_iterators()) {
    const auto square = cell->bounding_box();
    const auto& [lower, upper] = square.get_boundary_points();
    const auto [least, most] =
        distances(box<3>({lower[0], lower[1], 0.5031}, {upper[0], upper[1], 0.5031}));
    const auto expected = most < radius    ? Location::outside
                          : least > radius ? Location::inside
                                           : Location::intersected;
    EXPECT_EQ(classifier.location(cell), expected);
  }
}

TEST(DealIITest, RefusesTheWrongSide) {
  EXPECT_THROW(DealIIFunction<3>({kBall, FluidSide::Outside, {0.5, 0.5, 0.5}}), Error);
  EXPECT_THROW(DealIIClassifier<3>({kBall, FluidSide::Inside, {0, 0, 0}}), Error);
}

}  // namespace
}  // namespace cutwater::test
