#include <Cutwater/Adapters/Amrex.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Sdf/FunctionSDF.hpp>
#include <Cutwater/Shapes/Cuboid.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <atomic>
#include <numbers>
#include <type_traits>

#include "CutCells.hpp"
#include "Support/Grid.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

using Real = amrex::Real;
using amrex::Box;
using amrex::IntVect;

constexpr bool kIsDouble = std::is_same_v<Real, double>;
constexpr auto kCpu = amrex::RunOn::Cpu;

std::size_t offset(int i) {
  return static_cast<std::size_t>(i);
}

/// The unit cube in n x n x n cells.
amrex::Geometry unitCube(int n) {
  return {Box(IntVect(0), IntVect(n - 1)), {0, 0, 0}, {1, 1, 1}};
}

FluidDomain<Real> around(const Solid<Real>& solid) {
  return {solid, FluidSide::Outside, {Real(0.01), Real(0.02), Real(0.03)}};
}

const Sphere<Real> kBall({Real(0.5012), Real(0.4987), Real(0.5031)}, Real(0.3));
constexpr double kBallVolume = 4 * std::numbers::pi / 3 * 0.027;

struct SphereCase {
  int cells;
  std::size_t cut;
};

// Counts that AMReX itself, October 2024, gave for this sphere.
TEST(AmrexTest, CutsTheCellsThatAmrexCuts) {
  const AmrexShop shop(around(kBall));
  for (const auto [cells, cut] : {SphereCase{16, 416}, {32, 1760}, {64, 6964}, {128, 27793}}) {
    if (!kIsDouble && cells == 128) continue;  // its least cells are below that precision
    const CutCells result(shop, unitCube(cells), 16);
    EXPECT_EQ(result.count(), cut);
    EXPECT_EQ(result.wrongIntercepts(), 0U);
    const double error = std::abs(result.fluidVolume() - (1 - kBallVolume));
    EXPECT_LT(error, 0.6 / cells / cells);  // of second order
  }
}

TEST(AmrexTest, CutsTheSameCellsFromEitherSide) {
  const AmrexShop inside(FluidDomain<Real>(kBall, FluidSide::Inside, {0.5, 0.5, 0.5}));
  const auto geometry = unitCube(64);
  const CutCells result(inside, geometry, 16);
  EXPECT_EQ(result.count(), 6964U);
  EXPECT_EQ(result.wrongIntercepts(), 0U);
  EXPECT_NEAR(result.fluidVolume(), kBallVolume, 1e-3);
}

/// AMReX's own way with a box: all of its nodes.
class SamplingShop : public AmrexShop {
 public:
  explicit SamplingShop(const FluidDomain<Real>& domain) : AmrexShop(domain), function_(domain) {}

  int getBoxType(const Box& nodes, const amrex::Geometry& geometry, amrex::RunOn /*runOn*/) const {
    bool anyFluid = false;
    bool anyBody = false;
    forEachIndex({{nodes.smallEnd()[0], nodes.smallEnd()[1], nodes.smallEnd()[2]},
                  {nodes.bigEnd()[0], nodes.bigEnd()[1], nodes.bigEnd()[2]}},
                 [&](const Index3& node) {
                   const auto at = [&](int dir, int i) {
                     return geometry.ProbLo(dir) + static_cast<Real>(i) * geometry.CellSize(dir);
                   };
                   const Real value = function_({at(0, node.i), at(1, node.j), at(2, node.k)});
                   (value < 0 ? anyFluid : anyBody) = true;
                 });
    return !anyBody ? allregular : !anyFluid ? allcovered : mixedcells;
  }

 private:
  AmrexFunction function_;
};

TEST(AmrexTest, AsksFarLessOftenThanSampling) {
  std::atomic<std::size_t> calls = 0;
  const auto twoBalls = [&](const Vec3<Real>& p) {
    ++calls;
    const auto from = [&](const Vec3<Real>& center) { return length(p - center) - Real(0.11); };
    return std::min(from({Real(0.3), Real(0.31), Real(0.32)}),
                    from({Real(0.7), Real(0.68), Real(0.66)}));
  };
  const auto domain = around(
      FunctionSDF<Real, decltype(twoBalls)>(twoBalls, Guarantee<Real>{.outside = Quality::Exact,
                                                                      .inside = Quality::Exact,
                                                                      .lipschitz = Real(1),
                                                                      .continuous = true,
                                                                      .size = Real(1)}));
  const auto geometry = unitCube(128);
  calls = 0;
  const CutCells certified(AmrexShop(domain), geometry, 8);
  const std::size_t certifiedCalls = calls;
  calls = 0;
  const CutCells sampled(SamplingShop(domain), geometry, 8);
  const std::size_t sampledCalls = calls;
  EXPECT_EQ(certified.count(), sampled.count());
  EXPECT_NEAR(certified.fluidVolume(), sampled.fluidVolume(), 1e-9);
  // What is left are the nodes and edges of mixed grids, which both ask about.
  EXPECT_LT(certifiedCalls * 3, sampledCalls);
  RecordProperty("certified", static_cast<int>(certifiedCalls));
  RecordProperty("sampled", static_cast<int>(sampledCalls));
}

// A plate of a hundredth of a cell: no node sees it wherever it stands.
TEST(AmrexTest, NeverCallsABoxRegularThatTheSurfaceTouches) {
  const auto geometry = unitCube(16);
  const Box all = amrex::surroundingNodes(geometry.Domain());
  RandomPoints<Real> random(1);
  for (int n = 0; n < 200; ++n) {
    const auto offset = Real(0.5) + Real(0.3) * random.next().x;
    const Solid<Real> plate = Cuboid<Real>({offset, Real(0.2), Real(0.2)},
                                           {offset + Real(0.01 / 16), Real(0.9), Real(0.9)});
    const AmrexShop around(FluidDomain<Real>(plate, FluidSide::Outside, {0, 0, 0}));
    EXPECT_EQ(around.getBoxType(all, geometry, kCpu), AmrexShop::mixedcells);
    const int i = static_cast<int>(std::floor(offset * 16));
    EXPECT_EQ(around.getBoxType({{i, 8, 8}, {i + 1, 9, 9}}, geometry, kCpu), AmrexShop::mixedcells);
    EXPECT_EQ(around.getBoxType({{i - 2, 8, 8}, {i - 1, 9, 9}}, geometry, kCpu),
              AmrexShop::allregular);
    const AmrexShop within(FluidDomain<Real>(plate, FluidSide::Inside,
                                             {offset + Real(0.005 / 16), Real(0.5), Real(0.5)}));
    EXPECT_EQ(within.getBoxType(all, geometry, kCpu), AmrexShop::mixedcells);
    EXPECT_EQ(within.getBoxType({{i - 2, 8, 8}, {i - 1, 9, 9}}, geometry, kCpu),
              AmrexShop::allcovered);
  }
}

TEST(AmrexTest, BoxesThatOnlyTouchAreMixed) {
  const auto geometry = unitCube(16);
  const AmrexShop shop(around(Cuboid<Real>({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75})));
  EXPECT_EQ(shop.getBoxType({{0, 0, 0}, {4, 16, 16}}, geometry, kCpu), AmrexShop::mixedcells);
  EXPECT_EQ(shop.getBoxType({{0, 0, 0}, {3, 16, 16}}, geometry, kCpu), AmrexShop::allregular);
  EXPECT_EQ(shop.getBoxType({{4, 5, 5}, {7, 7, 7}}, geometry, kCpu), AmrexShop::mixedcells);
  EXPECT_EQ(shop.getBoxType({{5, 5, 5}, {7, 7, 7}}, geometry, kCpu), AmrexShop::allcovered);
}

TEST(AmrexTest, FunctionAndFabAgreeToTheBitNearTheSurface) {
  const auto geometry = unitCube(16);
  const auto domain = around(kBall);
  const AmrexFunction function(domain);
  amrex::BaseFab<Real> fab(Box({-3, -2, 1}, {19, 17, 12}));
  AmrexShop(domain).fillFab(fab, geometry, kCpu, Box({-8, -8, -8}, {24, 24, 24}));
  const auto values = fab.array();
  int near = 0;
  forEachIndex({{-3, -2, 1}, {19, 17, 12}}, [&](const Index3& node) {
    const amrex::RealArray p{static_cast<Real>(node.i) / 16, static_cast<Real>(node.j) / 16,
                             static_cast<Real>(node.k) / 16};
    const Real value = values(node.i, node.j, node.k);
    const Real expected = function(p);
    if (std::abs(expected) <= Real(1.25) / 16) {
      EXPECT_TRUE(sameBits(value, expected));
      ++near;
    } else {
      EXPECT_EQ(value, std::copysign(Real(1.25) / 16, expected));
    }
  });
  EXPECT_GT(near, 100);
}

// A bar that leaves the domain and ends behind its face: with the faces extended it does not end.
TEST(AmrexTest, FabsGoOnUnchangedBehindTheBoundingBox) {
  const auto geometry = unitCube(16);
  const Box within = amrex::surroundingNodes(geometry.Domain());
  const AmrexShop shop(
      around(Cuboid<Real>({Real(0.4), Real(0.4), Real(0.4)}, {Real(1.1), Real(0.6), Real(0.61)})));
  const Box nodes({12, 0, 0}, {20, 16, 16});
  amrex::BaseFab<Real> fab(nodes);
  shop.fillFab(fab, geometry, kCpu, within);
  const auto values = fab.array();
  forEachIndex({{16, 0, 0}, {20, 16, 16}}, [&](const Index3& node) {
    EXPECT_EQ(values(node.i, node.j, node.k), values(16, node.j, node.k));
  });
  EXPECT_GT(values(20, 8, 8), 0);

  // Its edges behind the face are cut where those on the face are.
  const Box edges({12, 0, 0}, {20, 15, 16});
  amrex::BaseFab<amrex::EB2::Type_t> types(edges);
  types.setVal(amrex::EB2::Type::irregular);
  amrex::BaseFab<Real> y(edges);
  const amrex::BaseFab<amrex::EB2::Type_t> none(Box({0, 0, 0}, {0, 0, 0}));
  amrex::BaseFab<Real> unused(Box({0, 0, 0}, {0, 0, 0}));
  shop.getIntercept({unused.array(), y.array(), unused.array()},
                    {none.const_array(), types.const_array(), none.const_array()}, values, geometry,
                    kCpu, within);
  EXPECT_NEAR(y.array()(20, 6, 8), 0.4, 1e-6);
  EXPECT_NEAR(y.array()(20, 9, 8), 0.6, 1e-6);
}

TEST(AmrexTest, InterceptsAreKnownOnIrregularEdgesOnlyAndMoveWithTheLevelSet) {
  namespace Type = amrex::EB2::Type;
  const auto geometry = unitCube(16);
  const AmrexShop shop(around(kBall));
  const Box nodes({2, 8, 8}, {5, 9, 9});
  amrex::BaseFab<Real> fab(nodes);
  shop.fillFab(fab, geometry, kCpu, nodes);
  const Box edges({2, 8, 8}, {4, 9, 9});
  amrex::BaseFab<Real> x(edges);
  x.setVal(7);
  amrex::BaseFab<amrex::EB2::Type_t> types(edges);
  types.setVal(Type::regular);
  types.array()(3, 8, 8) = Type::irregular;  // the surface is at x = 0.2012 or so: 3.2 cells
  amrex::BaseFab<Real> none(Box({0, 0, 0}, {0, 0, 0}));
  const amrex::BaseFab<amrex::EB2::Type_t> noTypes(Box({0, 0, 0}, {0, 0, 0}));
  const AmrexShop::EdgeArrays intercepts{x.array(), none.array(), none.array()};
  const AmrexShop::TypeArrays typeArrays{types.const_array(), noTypes.const_array(),
                                         noTypes.const_array()};
  shop.getIntercept(intercepts, typeArrays, fab.const_array(), geometry, kCpu, nodes);
  forEachIndex({{2, 8, 8}, {4, 9, 9}}, [&](const Index3& edge) {
    const bool isCut = edge == Index3{3, 8, 8};
    EXPECT_EQ(std::isnan(x.array()(edge.i, edge.j, edge.k)), !isCut);
  });
  const double offset = 0.5 - 0.4987;
  const double height = 0.5 - 0.5031;
  EXPECT_NEAR(x.array()(3, 8, 8), 0.5012 - std::sqrt(0.09 - offset * offset - height * height),
              1e-6);

  // AMReX covers the cells around the edge before it: node 3 becomes 0.
  fab.array()(3, 8, 8) = 0;
  types.array()(3, 8, 8) = Type::covered;
  types.array()(2, 8, 8) = Type::irregular;
  const Real kept = x.array()(3, 8, 8);
  shop.updateIntercept(intercepts, typeArrays, fab.const_array(), geometry);
  EXPECT_EQ(x.array()(2, 8, 8), Real(3) / 16);
  EXPECT_EQ(x.array()(3, 8, 8), kept);
}

TEST(AmrexTest, IsWhatBuildAsksOfAShop) {
  static_assert(std::is_copy_constructible_v<AmrexShop>);
  static_assert(std::is_same_v<AmrexShop::FunctionType, AmrexFunction>);
  static_assert(!AmrexShop::isGPUable());
  EXPECT_EQ(AmrexShop::allregular, -1);
  EXPECT_EQ(AmrexShop::mixedcells, 0);
  EXPECT_EQ(AmrexShop::allcovered, 1);
}

TEST(AmrexTest, RefusesTheWrongSide) {
  EXPECT_THROW(AmrexShop({kBall, FluidSide::Outside, {0.5, 0.5, 0.5}}), Error);
  EXPECT_THROW(AmrexFunction({kBall, FluidSide::Inside, {0, 0, 0}}), Error);
}

TEST(AmrexTest, TagsAreThoseOfTag) {
  const auto geometry = unitCube(32);
  const Solid<Real> solid = kBall | Cuboid<Real>({Real(0.1), Real(0.1), Real(0.101)},
                                                 {Real(0.4), Real(0.4), Real(0.102)});
  const Refinement<Real> rules{.cut = 3, .bands = {{.distance = Real(0.05), .level = 1}}};
  for (const int level : {0, 1, 3}) {
    const auto whole = IndexBox::ofSize(32, 32, 32);
    std::vector<std::uint8_t> marks(whole.count());
    tag(rules, solid, {Level<Real>({0, 0, 0}, {Real(1) / 32, Real(1) / 32, Real(1) / 32}), whole},
        level, GridView<std::uint8_t>::contiguous(marks.data(), whole));

    std::vector<Box> grids;
    for (int i = 0; i < 32; i += 16) grids.emplace_back(IntVect(i, 0, 0), IntVect(i + 15, 31, 31));
    amrex::TagBoxArray tags(grids, 2);
    for (auto& fab : tags.fabs()) fab.setVal(amrex::TagBox::CLEAR);
    tags.fabs()[0].array()(0, 31, 31) = amrex::TagBox::BUF;  // of somebody else's
    tagCells(rules, solid, tags, geometry, level);
    std::size_t set = 0;
    forEachIndex(whole, [&](const Index3& cell) {
      const auto mark = GridView<std::uint8_t>::contiguous(marks.data(), whole)
                            .at(offset(cell.i), offset(cell.j), offset(cell.k));
      const auto found = tags.fabs()[cell.i < 16 ? 0 : 1].array()(cell.i, cell.j, cell.k);
      const auto other = cell == Index3{0, 31, 31} ? amrex::TagBox::BUF : amrex::TagBox::CLEAR;
      EXPECT_EQ(found, mark == 1 ? amrex::TagBox::SET : other);
      set += found == amrex::TagBox::SET ? 1 : 0;
    });
    EXPECT_EQ(set > 0, level < 3);
    EXPECT_EQ(tags.fabs()[0].array()(16, 8, 8), amrex::TagBox::CLEAR)
        << "ghost cells are not asked";
  }
}

}  // namespace
}  // namespace cutwater::test
