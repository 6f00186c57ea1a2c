#include <Cutwater/Adapters/ChomboCutCells.hpp>
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
#include <type_traits>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

constexpr int kDim = CH_SPACEDIM;
const Real kDx = Real(1.0 / 16);

ProblemDomain cubeOf(int n, const std::array<bool, 3>& periodic = {}) {
  return {::Box(IntVect(0), IntVect(n - 1)), periodic.data()};
}

/// All that Chombo asks of a region of a domain of n cells a side, from `lo` to `hi`, with a cell
/// around it.
class Graph {
 public:
  using Key = std::array<int, 4>;  ///< a cell, and the number of the piece in it

  Graph(const ChomboCutCells& cells, const ProblemDomain& domain, int lo, int hi,
        const RealVect& origin = RealVect(), Real dx = kDx)
      : region_(IntVect(lo), IntVect(hi)), kinds_(region_, 1) {
    cells.fillGraph(kinds_, nodes_, region_, region_, domain, origin, dx, DataIndex());
    for (const auto& node : nodes()) {
      byKey_[{node.m_cell[0], node.m_cell[1], kDim == 3 ? node.m_cell[kDim - 1] : 0,
              node.m_cellIndex}] = &node;
    }
  }

  [[nodiscard]] const std::vector<IrregNode>& nodes() const { return nodes_.constStdVector(); }
  /// 1: regular, 0: irregular, -1: covered.
  int kind(const IntVect& cell) { return kinds_(cell, 0); }
  [[nodiscard]] const IrregNode* find(const IntVect& cell, int piece) const {
    const auto found = byKey_.find({cell[0], cell[1], kDim == 3 ? cell[kDim - 1] : 0, piece});
    return found == byKey_.end() ? nullptr : found->second;
  }
  [[nodiscard]] bool contains(const IntVect& cell) const {
    for (int dir = 0; dir < kDim; ++dir) {
      if (cell[dir] < region_.smallEnd()[dir] || cell[dir] > region_.bigEnd()[dir]) return false;
    }
    return true;
  }

 private:
  ::Box region_;
  BaseFab<int> kinds_;
  Vector<IrregNode> nodes_;
  std::map<Key, const IrregNode*> byKey_;
};

/// The n-th face of a node towards a side has the same numbers in the node across. Returns whether
/// there is one.
bool expectTheSameAcross(Graph& graph, const IrregNode& node, int dir, Side::LoHiSide side,
                         std::size_t n) {
  const auto own = static_cast<std::size_t>(IrregNode::index(dir, side));
  const auto back =
      static_cast<std::size_t>(IrregNode::index(dir, side == Side::Lo ? Side::Hi : Side::Lo));
  auto across = node.m_cell;
  across[dir] += side == Side::Lo ? -1 : 1;
  EXPECT_EQ(node.m_faceCentroid[own][n][dir], 0);
  if (!graph.contains(across)) return false;
  const int to = node.m_arc[own][n];
  if (to < 0) {
    EXPECT_EQ(to, -2);
    EXPECT_EQ(graph.kind(across), 1);
    return false;
  }
  const auto* other = graph.find(across, to);
  if (other == nullptr) {
    ADD_FAILURE() << "no node there";
    return false;
  }
  const auto& arcs = other->m_arc[back].constStdVector();
  const auto found = std::find(arcs.begin(), arcs.end(), node.m_cellIndex);
  if (found == arcs.end()) {
    ADD_FAILURE() << "no way back";
    return false;
  }
  const auto m = static_cast<std::size_t>(found - arcs.begin());
  EXPECT_EQ(node.m_areaFrac[own][n], other->m_areaFrac[back][m]);
  for (int d = 0; d < kDim; ++d) {
    EXPECT_EQ(node.m_faceCentroid[own][n][d], other->m_faceCentroid[back][m][d]);
  }
  return true;
}

/// All faces lead to what is there. Returns the number of those between pieces.
int expectTwoSides(Graph& graph) {
  int between = 0;
  for (const auto& node : graph.nodes()) {
    EXPECT_EQ(graph.kind(node.m_cell), 0);
    EXPECT_GT(node.m_volFrac, 0);
    EXPECT_LE(node.m_volFrac, 1);
    for (int d = 0; d < kDim; ++d) {
      EXPECT_LE(std::abs(node.m_volCentroid[d]), 0.5);
      EXPECT_LE(std::abs(node.m_bndryCentroid[d]), 0.5);
    }
    for (int dir = 0; dir < kDim; ++dir) {
      for (const auto side : {Side::Lo, Side::Hi}) {
        const auto own = static_cast<std::size_t>(IrregNode::index(dir, side));
        EXPECT_EQ(node.m_areaFrac[own].size(), node.m_arc[own].size());
        EXPECT_EQ(node.m_faceCentroid[own].size(), node.m_arc[own].size());
        for (std::size_t n = 0; n < node.m_arc[own].size(); ++n) {
          EXPECT_GT(node.m_areaFrac[own][n], 0);
          EXPECT_LE(node.m_areaFrac[own][n], 1);
          between += expectTheSameAcross(graph, node, dir, side, n) ? 1 : 0;
        }
      }
    }
  }
  return between;
}

TEST(ChomboCutCellsTest, BothSidesOfFacesAgree) {
  const auto domain = cubeOf(16);
  const Solid<double> ball = Sphere<double>({0.5012, 0.4987, 0.5031}, 0.3);
  const ChomboCutCells cells(SolidCutter(ball), domain, RealVect(), kDx);
  Graph graph(cells, domain, 0, 15);
  EXPECT_GT(expectTwoSides(graph), 500);
  EXPECT_EQ(graph.nodes().size(), 416U);
  double fluid = 0;
  for (int k = 0; k < 16; ++k) {
    for (int j = 0; j < 16; ++j) {
      for (int i = 0; i < 16; ++i) {
        IntVect at(i);
        at[1] = j;
        at[2] = k;
        if (graph.kind(at) == 1) ++fluid;
      }
    }
  }
  for (const auto& node : graph.nodes()) fluid += node.m_volFrac;
  EXPECT_NEAR(fluid / 4096, 1 - 4 * std::numbers::pi / 3 * 0.027, 1e-6);
}

// A plate within a layer of cells: each of them has a piece on both sides, which do not meet.
TEST(ChomboCutCellsTest, APlateHasTwoSides) {
  const auto domain = cubeOf(16);
  const double h = 1.0 / 16;
  const Solid<double> plate = Cuboid<double>({6.3 * h, 2.5 * h, 3.5 * h}, {6.6 * h, 2, 2});
  const ChomboCutCells cells(SolidCutter(plate), domain, RealVect(), kDx);
  Graph graph(cells, domain, 0, 15);
  EXPECT_GT(expectTwoSides(graph), 500);
  int pairs = 0;
  for (int k = 5; k < 15; ++k) {
    for (int j = 5; j < 15; ++j) {
      IntVect at(6);
      at[1] = j;
      at[2] = k;
      const auto* below = graph.find(at, 0);
      const auto* above = graph.find(at, 1);
      ASSERT_TRUE(below != nullptr && above != nullptr);
      EXPECT_NEAR(below->m_volFrac, 0.3, 1e-6);
      EXPECT_NEAR(above->m_volFrac, 0.4, 1e-6);
      EXPECT_EQ(below->m_arc[0].constStdVector(), (std::vector<int>{0}));
      EXPECT_EQ(below->m_arc[kDim].size(), 0U);
      EXPECT_EQ(above->m_arc[0].size(), 0U);
      EXPECT_EQ(above->m_arc[kDim].constStdVector(), (std::vector<int>{0}));
      EXPECT_EQ(below->m_arc[1].constStdVector(), (std::vector<int>{0}));
      EXPECT_EQ(above->m_arc[1].constStdVector(), (std::vector<int>{1}));
      EXPECT_NEAR(below->m_bndryCentroid[0], -0.2, 1e-6);
      EXPECT_NEAR(above->m_bndryCentroid[0], 0.1, 1e-6);
      EXPECT_NEAR(below->m_volCentroid[0], -0.35, 1e-6);
      // The cell across is all fluid, and irregular, as Chombo wants it there.
      at[0] = 5;
      const auto* whole = graph.find(at, 0);
      ASSERT_NE(whole, nullptr);
      EXPECT_EQ(graph.kind(at), 0);
      EXPECT_EQ(whole->m_volFrac, 1);
      EXPECT_EQ(whole->m_arc[kDim].constStdVector(), (std::vector<int>{0}));
      EXPECT_EQ(whole->m_areaFrac[kDim][0], 1);
      EXPECT_EQ(whole->m_arc[0].constStdVector(), (std::vector<int>{-2}));
      ++pairs;
    }
  }
  EXPECT_EQ(pairs, 100);
}

TEST(ChomboCutCellsTest, RegionsAreClassified) {
  const auto domain = cubeOf(16);
  const Solid<double> ball = Sphere<double>({0.5, 0.5, 0.5}, 0.3);
  const ChomboCutCells cells(SolidCutter(ball), domain, RealVect(), kDx);
  const GeometryService& service = cells;
  const auto ask = [&](int lo, int hi) {
    return service.InsideOutside(::Box(IntVect(lo), IntVect(hi)), domain, RealVect(), kDx);
  };
  EXPECT_EQ(ask(0, 3), GeometryService::Regular);
  EXPECT_EQ(ask(6, 9), GeometryService::Covered);
  EXPECT_EQ(ask(0, 15), GeometryService::Irregular);
  EXPECT_EQ(ask(0, 8), GeometryService::Irregular);
  EXPECT_TRUE(service.isRegular(::Box(IntVect(0), IntVect(1)), domain, RealVect(), kDx));
  EXPECT_TRUE(service.isCovered(::Box(IntVect(7), IntVect(8)), domain, RealVect(), kDx));
  EXPECT_TRUE(service.canGenerateMultiCells());
  EXPECT_FALSE(service.generatesHigherOrderMoments());
}

IndexTM<int, kDim> powersOf(int x, int y, int z) {
  IndexTM<int, kDim> power;
  power[0] = x;
  power[1] = y;
  power[2] = z;
  return power;
}
IndexTM<int, kDim - 1> powersOf(int first, int second) {
  IndexTM<int, kDim - 1> power;
  power[0] = first;
  power[1] = second;
  return power;
}

/// Integrals over a cell below z = h, from its middle, of x^p y^q z^r.
double belowPlane(int p, int q, int r, double dx, double h) {
  const auto along = [](int power, double from, double to) {
    return (std::pow(to, power + 1) - std::pow(from, power + 1)) / (power + 1);
  };
  return along(p, -dx / 2, dx / 2) * along(q, -dx / 2, dx / 2) * along(r, -dx / 2, h);
}

constexpr double kRounding = std::is_same_v<Real, float> ? 1e-6 : 1e-14;

// Below a plate, in cells that are cut at 0.3 of their height.
TEST(ChomboCutCellsTest, MomentsAreFromTheMiddle) {
  const auto domain = cubeOf(16);
  const double dx = 1.0 / 16;
  const Solid<double> plate = MeshSDF<double>(
      tessellation::box({2.5 * dx, 2.5 * dx, 6.3 * dx}, {14.5 * dx, 14.5 * dx, 9.2 * dx}));
  const ChomboCutCells cells(CellCutter(plate), domain, RealVect(), kDx, {.moments = true});
  EXPECT_TRUE(static_cast<const GeometryService&>(cells).generatesHigherOrderMoments());
  Graph graph(cells, domain, 0, 15);
  IntVect at(8);
  at[2] = 6;
  const auto* node = graph.find(at, 0);
  ASSERT_NE(node, nullptr);
  const double h = -0.2 * dx;
  for (const auto& power : IndMomSpaceDim::getMonomialPowers().constStdVector()) {
    const double volume = belowPlane(power[0], power[1], power[2], dx, h);
    EXPECT_NEAR(node->m_volumeMoments[power], volume, kRounding * dx * dx * dx);
    const double wall = belowPlane(power[0], power[1], 0, dx, dx / 2) / dx * std::pow(h, power[2]);
    EXPECT_NEAR(node->m_EBMoments[power], wall, kRounding * dx * dx);
  }
  EXPECT_NEAR(node->m_normalPartialDeriv[2][0], -1, kRounding);  // into the fluid
  EXPECT_NEAR(node->m_normalPartialDeriv[0][0], 0, kRounding);
  const auto high = static_cast<std::size_t>(IrregNode::index(1, Side::Hi));
  EXPECT_NEAR(node->m_faceMoments[high][powersOf(0, 0)], 0.3 * dx * dx, kRounding * dx * dx);
  EXPECT_NEAR(node->m_faceMoments[high][powersOf(0, 1)], -0.35 * 0.3 * dx * dx * dx,
              kRounding * dx * dx * dx);  // along z
  EXPECT_EQ(node->m_faceMoments[static_cast<std::size_t>(IrregNode::index(2, Side::Hi))][0], 0);
}

// Chombo adds moments of cells up: those of all must be those of the domain.
TEST(ChomboCutCellsTest, MomentsAddUp) {
  const auto domain = cubeOf(16);
  const double dx = 1.0 / 16;
  const Vec3<double> center{0.5012, 0.4987, 0.5031};
  const Solid<double> ball = Sphere<double>(center, 0.3);
  const ChomboCutCells cells(SolidCutter(ball), domain, RealVect(), kDx, {.moments = true});
  Graph graph(cells, domain, 0, 15);
  double area = 0;
  double second = 0;  // of z, about 0
  Vec3<double> vectors;
  for (const auto& node : graph.nodes()) {
    area += node.m_EBMoments[0];
    const double z = (node.m_cell[2] + 0.5) * dx;
    const auto& m = node.m_EBMoments;
    second += m[powersOf(0, 0, 2)] + 2 * z * m[powersOf(0, 0, 1)] + z * z * m[0];
    double open = 0;
    for (int dir = 0; dir < kDim; ++dir) {
      vectors[dir] += node.m_normalPartialDeriv[dir][0] * m[0];
      open += node.m_faceMoments[static_cast<std::size_t>(IrregNode::index(dir, Side::Hi))][0] -
              node.m_faceMoments[static_cast<std::size_t>(IrregNode::index(dir, Side::Lo))][0] -
              node.m_normalPartialDeriv[dir][0] * m[0];
    }
    EXPECT_NEAR(open, 0, 10 * kRounding);
  }
  const double whole = 4 * std::numbers::pi * 0.09;
  EXPECT_NEAR(area, whole, 1e-5);
  EXPECT_NEAR(second, whole * (center.z * center.z + 0.03), 1e-5);
  EXPECT_NEAR(length(vectors), 0, 100 * kRounding);
}

// As many cells as hosts have.
TEST(ChomboCutCellsTest, AMillionCellsAgree) {
  const auto domain = cubeOf(104);
  const Solid<double> torus = MeshSDF<double>(tessellation::torus(0.3, 0.11, 60, 30));
  const RealVect origin(Real(-0.5), Real(-0.515625), Real(-0.53125));
  const Real dx = Real(1.0 / 104);
  const ChomboCutCells cells(CellCutter(torus), domain, origin, dx);
  Graph graph(cells, domain, 0, 103, origin, dx);
  EXPECT_GT(expectTwoSides(graph), 30'000);
}

TEST(ChomboCutCellsTest, PeriodsGoOn) {
  const auto domain = cubeOf(16, {true, false, true});
  const Solid<double> ball = Sphere<double>({0.02, 0.5, 0.97}, 0.3);
  EXPECT_THROW(ChomboCutCells(SolidCutter(ball), domain, RealVect(), kDx), Error);
  const SolidCutter cutter(ball, FluidSide::Outside, {.period = {1, 0, 1}});
  EXPECT_THROW(ChomboCutCells(cutter, cubeOf(16), RealVect(), kDx), Error);
  const ChomboCutCells cells(cutter, domain, RealVect(), kDx);
  Graph graph(cells, domain, 0, 15);
  expectTwoSides(graph);
  int across = 0;
  for (const auto& node : graph.nodes()) {
    for (const int face : {0, kDim}) {
      if (node.m_cell[0] != (face == 0 ? 0 : 15)) continue;
      for (const int to : node.m_arc[face].constStdVector()) {
        EXPECT_NE(to, -1);
        across += to >= 0 ? 1 : 0;
      }
    }
    for (const int to : node.m_arc[1].constStdVector()) {
      if (node.m_cell[1] != 0) continue;
      EXPECT_EQ(to, -1);
    }
  }
  EXPECT_GT(across, 20);
  const ::Box beyond(IntVect(-2), IntVect(-1));
  EXPECT_THROW(static_cast<void>(cells.InsideOutside(beyond, cubeOf(16), RealVect(), kDx)), Error);
  EXPECT_THROW(static_cast<void>(cells.InsideOutside(beyond, domain, RealVect(), 2 * kDx)), Error);
}

// A wall in a plane of the grid: beside it a cell is irregular, all fluid, and has no face there.
TEST(ChomboCutCellsTest, WallsInPlanesOfTheGridCloseFaces) {
  const auto domain = cubeOf(16);
  const Solid<double> box =
      MeshSDF<double>(tessellation::box({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}));
  const ChomboCutCells cells(CellCutter(box), domain, RealVect(), kDx);
  Graph graph(cells, domain, 0, 15);
  expectTwoSides(graph);
  IntVect at(8);
  at[0] = 3;
  EXPECT_EQ(graph.kind(at), 0);
  const auto* node = graph.find(at, 0);
  ASSERT_NE(node, nullptr);
  EXPECT_EQ(node->m_volFrac, 1);
  EXPECT_EQ(node->m_arc[kDim].size(), 0U);
  EXPECT_EQ(node->m_arc[0].constStdVector(), (std::vector<int>{-2}));
  EXPECT_EQ(node->m_bndryCentroid[0], Real(0.5));
  at[0] = 4;
  EXPECT_EQ(graph.kind(at), -1);
}

}  // namespace
}  // namespace cutwater::test
