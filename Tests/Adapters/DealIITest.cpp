// Compiled against Mock, and against deal.II where there is one: see CMakeLists.txt.
#include <Cutwater/Adapters/DealII.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

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

double sumOf(const std::vector<double>& weights) {
  return std::accumulate(weights.begin(), weights.end(), 0.0);
}

/// What quadratures say of all pieces of a mesh of the unit cube.
struct Measured {
  double volume = 0;
  double squareOfX = 0;  // integrated over the volume
  double area = 0;
  double worstClosure = 0;  // of a piece, in the unit cell
  std::size_t pieces = 0;
};

Measured measured(const dealii::Triangulation<3>& mesh, const DealIICutCells& cut) {
  Measured sum;
  for (const auto& cell : mesh.active_cell_iterators()) {
    const auto box = cell->bounding_box();
    const auto& [lower, upper] = box.get_boundary_points();
    const double h = upper[0] - lower[0];
    if (cut.location(cell) == Location::inside) {
      sum.volume += h * h * h;
      sum.squareOfX += h * h * (std::pow(upper[0], 3) - std::pow(lower[0], 3)) / 3;
    }
    for (std::size_t n = 0; n < cut.pieceCount(cell); ++n) {
      const auto piece = cut.piece(cell, n);
      ++sum.pieces;
      sum.volume += h * h * h * sumOf(piece.inside.get_weights());
      for (unsigned i = 0; i < piece.inside.size(); ++i) {
        const double x = lower[0] + h * piece.inside.get_points()[i][0];
        sum.squareOfX += h * h * h * piece.inside.get_weights()[i] * x * x;
      }
      sum.area += h * h * sumOf(piece.surface.get_weights());
      for (unsigned axis = 0; axis < 3; ++axis) {
        double closure = sumOf(piece.faces[2 * axis + 1].get_weights()) -
                         sumOf(piece.faces[2 * axis].get_weights());
        for (unsigned i = 0; i < piece.surface.size(); ++i) {
          closure += piece.surface.get_weights()[i] * piece.surface.get_normal_vectors()[i][axis];
        }
        sum.worstClosure = std::max(sum.worstClosure, std::abs(closure));
      }
    }
  }
  return sum;
}

TEST(DealIITest, QuadraturesOfABallFallWithTheirPoints) {
  dealii::Triangulation<3> mesh;
  refine(mesh, 4);
  const double volume = 1 - 4 * std::numbers::pi / 3 * std::pow(0.3, 3);
  const double area = 4 * std::numbers::pi * 0.09;
  const double squareOfBall =
      4 * std::numbers::pi / 3 * (std::pow(0.3, 5) / 5 + std::pow(0.3, 3) * std::pow(0.5012, 2));
  double bound = 1e-6;
  for (const int points : {2, 4}) {
    SCOPED_TRACE(points);
    const SolidCutter cutter(Solid<double>(kBall), FluidSide::Outside, {.points = points});
    const auto sum = measured(mesh, DealIICutCells(cutter, mesh));
    EXPECT_NEAR(sum.volume, volume, bound);
    EXPECT_NEAR(sum.squareOfX, 1.0 / 3 - squareOfBall, bound);
    EXPECT_NEAR(sum.area, area, 100 * bound);
    EXPECT_LT(sum.worstClosure, 1e4 * bound);
    bound *= 1e-4;
  }
}

/// Planes of the plate are no planes of cells, and turned boxes have exact rows.
TEST(DealIITest, CellsThatAPlateDividesHaveTwoPieces) {
  dealii::Triangulation<3> mesh;
  refine(mesh, 2);
  const auto plate = MeshSDF<double>(tessellation::box({-1, -1, 0.6}, {2, 2, 0.61}));
  const DealIICutCells cut(CellCutter(Solid<double>(plate)), mesh);
  const auto sum = measured(mesh, cut);
  EXPECT_EQ(sum.pieces, 32U);
  EXPECT_NEAR(sum.volume, 0.99, 1e-14);
  EXPECT_NEAR(sum.squareOfX, 0.99 / 3, 1e-14);
  EXPECT_NEAR(sum.area, 2, 1e-14);
  EXPECT_LT(sum.worstClosure, 1e-14);
}

/// Cells are cut in blocks of eight: those beside their ends see the same.
TEST(DealIITest, FacesAreTheSameOnBothSides) {
  constexpr std::size_t kAlong = 16;
  dealii::Triangulation<3> mesh;
  refine(mesh, 4);
  const DealIICutCells cut(SolidCutter(Solid<double>(kBall)), mesh);
  // deal.II and its mock number cells differently.
  std::map<std::array<int, 3>, std::size_t> numbers;
  std::vector<std::vector<DealIIPiece>> pieces(mesh.n_active_cells());
  for (const auto& cell : mesh.active_cell_iterators()) {
    const auto box = cell->bounding_box();
    const auto& lower = box.get_boundary_points().first;
    const auto at = [&](unsigned axis) {
      return static_cast<int>(std::lround(lower[axis] * kAlong));
    };
    numbers[{at(0), at(1), at(2)}] = cell->active_cell_index();
    for (std::size_t n = 0; n < cut.pieceCount(cell); ++n) {
      pieces[cell->active_cell_index()].push_back(cut.piece(cell, n));
    }
  }
  std::size_t compared = 0;
  for (const auto& [at, number] : numbers) {
    for (unsigned axis = 0; axis < 3; ++axis) {
      auto next = at;
      ++next[axis];
      const auto above = numbers.find(next);
      if (above == numbers.end() || pieces[number].empty() || pieces[above->second].empty())
        continue;
      EXPECT_EQ(pieces[number][0].faces[2 * axis + 1].get_weights(),
                pieces[above->second][0].faces[2 * axis].get_weights());
      ++compared;
    }
  }
  EXPECT_GT(compared, 500U);
  EXPECT_EQ(cut.blocks().size(), 8U);
}

TEST(DealIITest, PointsOfFacesAreTheirs) {
  dealii::Triangulation<3> mesh;
  dealii::GridGenerator::hyper_cube(mesh);
  const auto corner = MeshSDF<double>(tessellation::box({0.5, 0.6, 0.8}, {2, 2, 2}));
  const DealIICutCells cut(CellCutter(Solid<double>(corner)), mesh);
  const auto cell = *mesh.active_cell_iterators().begin();
  ASSERT_EQ(cut.location(cell), Location::intersected);
  ASSERT_EQ(cut.pieceCount(cell), 1U);
  const auto piece = cut.piece(cell);
  // Across x: y, z; across y: z, x; across z: x, y.
  const std::array<std::array<double, 2>, 3> body{{{0.6, 0.8}, {0.8, 0.5}, {0.5, 0.6}}};
  for (unsigned face = 0; face < 6; ++face) {
    SCOPED_TRACE(face);
    const auto& rule = piece.faces[face];
    const auto [u, v] = body[face / 2];
    const double closed = face % 2 == 1 ? (1 - u) * (1 - v) : 0;
    EXPECT_NEAR(sumOf(rule.get_weights()), 1 - closed, 1e-14);
    std::array<double, 2> moments{};
    for (unsigned i = 0; i < rule.size(); ++i) {
      for (unsigned a = 0; a < 2; ++a) {
        moments[a] += rule.get_weights()[i] * rule.get_points()[i][a];
      }
    }
    EXPECT_NEAR(moments[0], 0.5 - closed * (1 + u) / 2, 1e-14);
    EXPECT_NEAR(moments[1], 0.5 - closed * (1 + v) / 2, 1e-14);
  }
  EXPECT_THROW(static_cast<void>(cut.piece(cell, 1)), Error);
}

}  // namespace
}  // namespace cutwater::test
