// The code of Docs/adapters.md, amrex.md, chombo.md and dealii.md.
#include <Cutwater/Adapters/Amrex.hpp>
#include <Cutwater/Adapters/AmrexEB.hpp>
#include <Cutwater/Adapters/Chombo.hpp>
#include <Cutwater/Adapters/ChomboCutCells.hpp>
#include <Cutwater/Adapters/DealII.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Cylinder.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <memory>
#include <numbers>

#include <deal.II/grid/grid_generator.h>
#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

const Solid<double> kBody = Sphere<double>({0.5, 0.5, 0.5}, 0.3);

amrex::Geometry geometryOf(int cells) {
  return {amrex::Box(amrex::IntVect(0), amrex::IntVect(cells - 1)), {0, 0, 0}, {1, 1, 1}};
}

TEST(DocsTest, FluidAroundABodyAndInAPipe) {
  // [DOCS
  // Around a body: the fluid is outside of the solid, e.g. in the domain's corner.
  const Solid<double> body = Sphere<double>({0.5, 0.5, 0.5}, 0.3);
  const FluidDomain<double> around(body, FluidSide::Outside, {0.01, 0.01, 0.01});

  // In a pipe: the solid is the shape of the bore.
  const Solid<double> bore = Cylinder<double>({0, 0.5, 0.5}, {1, 0.5, 0.5}, 0.2);
  const FluidDomain<double> within(bore, FluidSide::Inside, {0.5, 0.5, 0.5});
  // DOCS]
  EXPECT_LT(around.levelSet({0, 0, 0}), 0);
  EXPECT_LT(within.levelSet({0.2, 0.5, 0.5}), 0);
  EXPECT_GT(within.levelSet({0.2, 0.8, 0.5}), 0);
}

TEST(DocsTest, CutCellsOfAmrex) {
  const Solid<double> hull = MeshSDF<double>(tessellation::icosphere(0.6, 2));
  const auto geometry = geometryOf(16);
  double lost = 0;
  // [DOCS
  const CellCutter cutter(hull);  // a SolidCutter for other solids than meshes
  const AmrexIndexSpace& space = buildEB(cutter, geometry);
  for (const auto& [cell, volume] : space.cells(geometry).lost()) lost += volume;
  // DOCS]
  EXPECT_GT(space.cells(geometry).cells().cellCount, 100U);
  EXPECT_LT(lost, 1e-3);
  amrex::EB2::IndexSpace::clear();
}

TEST(DocsTest, GeometryShopOfAmrex) {
  const auto& body = kBody;
  const auto geometry = geometryOf(16);
  // [DOCS
  const AmrexShop shop({body, FluidSide::Outside, {0.01, 0.01, 0.01}});
  const int requiredCoarsening = 0;
  const int maxCoarsening = 0;
  amrex::EB2::Build(shop, geometry, requiredCoarsening, maxCoarsening);
  // DOCS]
  EXPECT_EQ(amrex::EB2::lastBuild.boxType, AmrexShop::mixedcells);
  EXPECT_GT(amrex::EB2::lastBuild.irregularEdges, 100U);
}

class Solver : public amrex::AmrCore {
 public:
  using amrex::AmrCore::AmrCore;

  // [DOCS
  // Of your class derived from amrex::AmrCore.
  void ErrorEst(int level, amrex::TagBoxArray& tags, amrex::Real /*time*/, int /*n*/) override {
    tagCells({.cut = 3, .bands = {{.distance = 0.05, .level = 2}}}, body, tags, Geom(level), level);
  }
  // DOCS]

  Solid<double> body = kBody;
};

TEST(DocsTest, TagsOfAmrex) {
  Solver solver(geometryOf(8));
  amrex::TagBoxArray tags({solver.Geom(1).Domain()}, 0);
  solver.ErrorEst(1, tags, 0, 0);
  EXPECT_EQ(tags.fabs()[0].array()(3, 8, 8), amrex::TagBox::SET);
  EXPECT_EQ(tags.fabs()[0].array()(0, 0, 0), amrex::TagBox::CLEAR);
}

TEST(DocsTest, CutCellsOfChombo) {
  const Solid<double> hull = MeshSDF<double>(tessellation::icosphere(0.6, 2));
  const ProblemDomain domain(::Box(IntVect(0), IntVect(15)));
  const RealVect origin;
  const double dx = 1.0 / 16;
  // [DOCS
  const ChomboCutCells cut(CellCutter(hull), domain, origin, dx);
  const GeometryService& service = cut;  // for EBIndexSpace::define(domain, origin, dx, service)
  // DOCS]
  EXPECT_EQ(service.InsideOutside(domain.domainBox(), domain, origin, dx),
            GeometryService::Irregular);
}

TEST(DocsTest, ImplicitFunctionOfChombo) {
  const auto& body = kBody;
  // [DOCS
  const ChomboIF function({body, FluidSide::Outside, {0.01, 0.01, 0.01}});
  // DOCS]
  EXPECT_EQ(function.InsideOutside({0.4, 0.4, 0.4}, {0.6, 0.6, 0.6}), GeometryService::Covered);
}

TEST(DocsTest, LevelSetAndClassifierOfDealII) {
  const auto& body = kBody;
  dealii::Triangulation<3> mesh;
  dealii::GridGenerator::hyper_cube(mesh);
  mesh.refine_global(3);
  std::size_t intersected = 0;
  // [DOCS
  const FluidDomain<double> domain(body, FluidSide::Outside, {0.01, 0.01, 0.01});
  const DealIIFunction<3> levelSet(domain, {.hessianStep = 1e-5});
  DealIIClassifier<3> classifier(domain);
  classifier.reclassify(mesh);
  for (const auto& cell : mesh.active_cell_iterators()) {
    if (classifier.location(cell) == dealii::NonMatching::LocationToLevelSet::intersected) {
      ++intersected;
    }
  }
  // DOCS]
  EXPECT_GT(intersected, 50U);
  EXPECT_EQ(levelSet.value({0.5, 0.5, 0.5}), 0.3);
}

TEST(DocsTest, QuadraturesForDealII) {
  const auto& body = kBody;
  dealii::Triangulation<3> mesh;
  dealii::GridGenerator::hyper_cube(mesh);
  mesh.refine_global(3);
  double fluid = 0;
  // [DOCS
  const SolidCutter cutter(body, FluidSide::Outside, {.points = 3});
  const DealIICutCells cut(cutter, mesh);
  for (const auto& cell : mesh.active_cell_iterators()) {
    for (std::size_t n = 0; n < cut.pieceCount(cell); ++n) {
      const DealIIPiece piece = cut.piece(cell, n);
      for (const double weight : piece.inside.get_weights()) fluid += weight;  // of the unit cell
    }
  }
  // DOCS]
  for (const auto& cell : mesh.active_cell_iterators()) {
    fluid += cut.location(cell) == dealii::NonMatching::LocationToLevelSet::inside ? 1 : 0;
  }
  EXPECT_NEAR(fluid / 512, 1 - 4 * std::numbers::pi / 3 * 0.027, 1e-6);
}

}  // namespace
}  // namespace cutwater::test
