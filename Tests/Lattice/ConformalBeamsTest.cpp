#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/BeamLattice.hpp>
#include <Cutwater/Lattice/CellMappings.hpp>
#include <Cutwater/Lattice/ConformalBeams.hpp>
#include <Cutwater/Lattice/PeriodicLattice.hpp>
#include <Cutwater/Shapes/Sphere.hpp>

#include <algorithm>
#include <map>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include "Support/Guarantee.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

HexahedralCells regular(const HexahedralCells::Counts& count, const Vec3<double>& size) {
  return {count,
          BoxMapping({{0, 0, 0}, {count[0] * size.x, count[1] * size.y, count[2] * size.z}})};
}

HexahedralCells pipeCells(const HexahedralCells::Counts& count) {
  return {count, PipeMapping({.innerRadius = 0.6, .outerRadius = 1, .length = 0.8})};
}

double lengthOf(const BeamGraph& graph) {
  double sum = 0;
  for (const auto& [nodes, radii, body, caps] : graph.beams) {
    sum += length(graph.nodes[nodes[1]] - graph.nodes[nodes[0]]);
  }
  return sum;
}

double leastDistanceOfNodes(const BeamGraph& graph) {
  double least = 1e300;
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      least = std::min(least, length(graph.nodes[i] - graph.nodes[j]));
    }
  }
  return least;
}

TEST(ConformalBeamsTest, RegularBoxesAreRegularArrays) {
  const Vec3<double> size{1, 0.75, 1.25};
  for (const auto& cell : UnitCell::all()) {
    SCOPED_TRACE(cell.name());
    const auto plain = beamsOf(cell, {size, {3, 2, 4}}, 0.0625);
    const auto mapped = beamsOf(cell, regular({3, 2, 4}, size), 0.0625);
    ASSERT_EQ(mapped.nodes.size(), plain.nodes.size());
    ASSERT_EQ(mapped.beams.size(), plain.beams.size());
    for (std::size_t i = 0; i < plain.nodes.size(); ++i) {
      EXPECT_LT(length(mapped.nodes[i] - plain.nodes[i]), 2e-15);
    }
    for (std::size_t i = 0; i < plain.beams.size(); ++i) {
      EXPECT_EQ(mapped.beams[i].nodes, plain.beams[i].nodes);
      EXPECT_EQ(mapped.beams[i].radii, plain.beams[i].radii);
    }
    const BeamLattice<double> solid(mapped);
    const PeriodicLattice<double> array(cell, {size, {3, 2, 4}}, 0.0625);
    RandomPoints<double> random(3, 8);
    for (int i = 0; i < scaled(200); ++i) {
      const auto p = random.next() + Vec3<double>{1.5, 1, 2};
      EXPECT_NEAR(solid.signedDistance(p), array.signedDistance(p), 4e-15);
    }
  }
}

/// Of the cells' struts those that an array of n^3 cells has: on a row of n cells n, and one more
/// if their middles lie in the faces between, and the row is not closed.
std::size_t strutsOf(const UnitCell& cell, const HexahedralCells& cells) {
  std::size_t all = 0;
  for (const auto& strut : cell.struts()) {
    std::size_t copies = 1;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool isInFace = std::abs(strut.middle()[static_cast<int>(axis)]) < 1e-9;
      copies *= cells.count()[axis] + (isInFace && !cells.closed()[axis] ? 1 : 0);
    }
    all += copies;
  }
  return all;
}

TEST(ConformalBeamsTest, EveryStrutIsThereOnceAlsoAtTheSeam) {
  const auto closed = pipeCells({2, 9, 3});
  const HexahedralCells open({2, 9, 3}, PipeMapping({0.6, 1, 0.8, 0, 200}));
  for (const auto& cell : UnitCell::all()) {
    SCOPED_TRACE(cell.name());
    for (const auto* const cells : {&closed, &open}) {
      const auto graph = beamsOf(cell, *cells, 0.01, {.subdivisions = 1});
      EXPECT_EQ(graph.beams.size(), strutsOf(cell, *cells));
      std::set<std::array<std::uint32_t, 2>> known;
      for (const auto& beam : graph.beams) {
        auto nodes = beam.nodes;
        std::ranges::sort(nodes);
        EXPECT_TRUE(known.insert(nodes).second);
      }
      EXPECT_GT(leastDistanceOfNodes(graph), 0.02);
    }
  }
  // 18 corners and 9 centres per ring; of nodes at the seam there are no two.
  const auto bcc = beamsOf(UnitCell::bcc(), pipeCells({1, 9, 1}), 0.01, {.subdivisions = 1});
  EXPECT_EQ(bcc.nodes.size(), 4U * 9 + 9);
  std::map<std::uint32_t, int> uses;
  for (const auto& beam : bcc.beams) {
    for (const auto node : beam.nodes) ++uses[node];
  }
  EXPECT_EQ(uses[0], 2);  // a corner of two cells, on either side of the seam
}

TEST(ConformalBeamsTest, PipesHaveTheSymmetryOfTheTurn) {
  const auto cells = pipeCells({1, 8, 1});
  for (const auto& cell : {UnitCell::octet(), UnitCell::srs(), UnitCell::diamond()}) {
    const BeamLattice<double> lattice(beamsOf(cell, cells, 0.03));
    auto turned = lattice;
    turned.rotate(45, 2);
    RandomPoints<double> random(1.2);
    for (int i = 0; i < 300; ++i) {
      const auto p = random.next();
      EXPECT_NEAR(turned.signedDistance(p), lattice.signedDistance(p), 1e-14) << cell.name();
    }
  }
}

TEST(ConformalBeamsTest, StrutsAreTrilinearImages) {
  const auto cells = pipeCells({2, 8, 2}).withNoise({.amplitude = 0.04, .seed = 5});
  const auto cell = UnitCell::bcc();
  // All in the first cell's middle: the straight struts of a cell with bent ones.
  const auto graph = beamsOf(cell, cells, 0.02, {.subdivisions = 16});
  EXPECT_EQ(graph.beams.size(), 16 * strutsOf(cell, cells));
  const BeamLattice<double> lattice(graph);
  for (int i = 0; i <= 160; ++i) {
    const double t = i / 160.0;
    const Vec3<double> onStrut{1 + t, 3 + t, 1 - t};
    // On the strut, but for the arc over a sixteenth of it.
    EXPECT_NEAR(lattice.signedDistance(cells.at(onStrut)), -0.02, 1e-3);
    if (i % 10 == 0) {
      EXPECT_NEAR(lattice.signedDistance(cells.at(onStrut)), -0.02, 1e-15);
    }
  }
  // With fewer parts, chords cut the arc; straight edges are never divided.
  EXPECT_LT(lengthOf(beamsOf(cell, cells, 0.02, {.subdivisions = 1})), lengthOf(graph));
  const auto edges = beamsOf(UnitCell::simpleCubic(), cells, 0.02, {.subdivisions = 16});
  EXPECT_EQ(edges.beams.size(), strutsOf(UnitCell::simpleCubic(), cells));
}

TEST(ConformalBeamsTest, StrutsAcrossFacesUseTheNeighboursMap) {
  // Cells of length 1 and 3: a strut over the face, from the middle of one to that of the other.
  const UnitCell rod("rod", std::vector<CellStrut>{{{0.5, 0.5, 0.5}, {1.5, 0.5, 0.5}}});
  const HexahedralCells cells({2, 1, 1}, [](const Vec3<double>& u) {
    return Vec3<double>{u.x < 0.75 ? 2 * u.x : 4 * (u.x - 0.5) + 2, u.y, u.z};
  });
  ASSERT_EQ(cells.corner(2, 0, 0).x, 4);
  const auto graph = beamsOf(rod, cells, 0.1, {.subdivisions = 2});
  // Middles lie in the faces x = 0, 1 and 2; beyond the ends the last cells go on.
  std::set<double> places;
  for (const auto& node : graph.nodes) places.insert(node.x);
  EXPECT_EQ(places, (std::set<double>{-0.5, 0.5, 1, 2.5, 5.5}));
}

/// Thinner towards x.
struct ThinnerTowardsX {
  double operator()(const Vec3<double>& p) const { return 0.1 - 0.05 * p.x; }
};

TEST(ConformalBeamsTest, RadiiAreThoseOfTheThicknessAtNodes) {
  const auto cells = pipeCells({1, 8, 1});
  const auto cell = UnitCell::bcc();
  const auto center = Sphere<double>({1, 0, 0}, 0.1);
  const auto byDistance =
      beamsOf(cell, cells,
              Thickness<double>::byDistanceTo(center, {.start = 0.1, .end = 0.05, .over = 0.5}),
              {.subdivisions = 5});
  const auto byFunction = beamsOf(
      cell, cells,
      Thickness<double>::by(ThinnerTowardsX(), {.lipschitz = 0.05, .least = 0.05, .most = 0.15}));
  for (const auto& beam : byDistance.beams) {
    for (std::size_t end = 0; end < 2; ++end) {
      const auto& p = byDistance.nodes[beam.nodes[end]];
      const double distance = std::abs(length(p - Vec3<double>{1, 0, 0}) - 0.1);
      EXPECT_NEAR(beam.radii[end], 0.1 - 0.1 * std::min(distance, 0.5), 1e-15);
    }
  }
  for (const auto& beam : byFunction.beams) {
    for (std::size_t end = 0; end < 2; ++end) {
      const double x = byFunction.nodes[beam.nodes[end]].x;
      EXPECT_NEAR(beam.radii[end], 0.1 - 0.05 * x, 1e-15);
    }
  }
  // From the corner to the centre, in parts of a quarter.
  const auto byCell = beamsOf(cell, cells, Thickness<double>::byDistanceToCellCenter(0.04, 0.08));
  std::set<double> radii;
  for (const auto& beam : byCell.beams) {
    for (const double radius : beam.radii) radii.insert(std::round(1e6 * radius) / 1e6);
  }
  EXPECT_EQ(radii, (std::set<double>{0.04, 0.05, 0.06, 0.07, 0.08}));
}

TEST(ConformalBeamsTest, StraightStrutsAreDividedWhereTheirRadiusIsNotLinear) {
  // Thick about the middle of one edge of twelve.
  const auto thickness =
      Thickness<double>::byDistanceTo(Sphere<double>({0.5, 0, 0}, 0.125), {0.2, 0.1, 0.25});
  const auto graph = beamsOf(UnitCell::simpleCubic(), regular({1, 1, 1}, {1, 1, 1}), thickness);
  ASSERT_EQ(graph.beams.size(), 11U + 4);
  std::map<double, double> radii;
  for (const auto& beam : graph.beams) {
    for (std::size_t end = 0; end < 2; ++end) {
      const auto& node = graph.nodes[beam.nodes[end]];
      if (node.y == 0 && node.z == 0) radii[node.x] = beam.radii[end];
    }
  }
  ASSERT_EQ(radii.size(), 5U);
  for (const auto& [x, radius] : radii) {
    EXPECT_NEAR(radius, x == 0 || x == 1 ? 0.1 : 0.15, 1e-15) << x;
  }
}

/// By the definition of a round cone, in double precision, beam by beam: the hull of two balls is
/// the union of all between them.
bool isInRoundCones(const BeamGraph& graph, const Vec3<double>& p) {
  return std::ranges::any_of(graph.beams, [&](const BeamGraph::Beam& beam) {
    const auto a = graph.nodes[beam.nodes[0]];
    const auto ab = graph.nodes[beam.nodes[1]] - a;
    if (length(p - a) > length(ab) + beam.radii[0] + beam.radii[1]) return false;
    // |p - a - t ab| - r(t) is convex in t: the least by golden section.
    const auto value = [&](double t) {
      return length(p - a - t * ab) - ((1 - t) * beam.radii[0] + t * beam.radii[1]);
    };
    double low = 0;
    double high = 1;
    for (int i = 0; i < 80; ++i) {
      const double step = (high - low) * (2 - std::numbers::phi);
      (value(low + step) < value(high - step) ? high : low) =
          value(low + step) < value(high - step) ? high - step : low + step;
    }
    return std::min({value(0), value(1), value(low)}) < 0;
  });
}

template <typename T>
void expectConformalGuarantee(const BeamGraph& graph, double extent) {
  const BeamLattice<T> lattice(graph);
  expectGuarantee(lattice, extent,
                  {.inside = [&](const Vec3<double>& p) { return isInRoundCones(graph, p); },
                   .probes = 300,
                   .lines = 16,
                   .covering = 6});
}

TEST(ConformalBeamsTest, EveryCellKeepsItsGuaranteeInAPipe) {
  const auto cells = pipeCells({1, 8, 1}).withNoise({.amplitude = 0.03, .seed = 3});
  const auto thickness = Thickness<double>::byDistanceToCellCenter(0.03, 0.06);
  for (const auto& cell : UnitCell::all()) {
    SCOPED_TRACE(cell.name());
    const auto graph = beamsOf(cell, cells, thickness, {.subdivisions = 2});
    expectConformalGuarantee<double>(graph, 1.2);
    expectConformalGuarantee<float>(graph, 1.2);
  }
}

TEST(ConformalBeamsTest, LensesAndBentPipesKeepTheirGuarantee) {
  const HexahedralCells lens(
      {3, 3, 1},
      LensMapping({.diameter = 2, .centerThickness = 0.8, .frontRadius = 2, .backRadius = 3}));
  expectConformalGuarantee<double>(beamsOf(UnitCell::octet(), lens, 0.05), 1.2);
  const std::vector<Vec3<double>> points{
      {-0.8, -0.4, 0}, {0, -0.4, 0.2}, {0.5, 0.3, 0.2}, {0.4, 0.9, -0.2}};
  const Spine spine(points);
  const AlongSpine bentPipe(spine, PipeMapping({0.12, 0.3, spine.length()}));
  const auto graph =
      beamsOf(UnitCell::bccz(), {{1, 8, 6}, bentPipe},
              Thickness<double>::byDistanceTo(Sphere<double>({0, 0, 0}, 0.5), {0.04, 0.02, 0.3}));
  expectConformalGuarantee<double>(graph, 1.2);
}

TEST(ConformalBeamsTest, RefusesWhatCannotBe) {
  const auto cells = regular({2, 2, 2}, {1, 1, 1});
  EXPECT_THROW((void)beamsOf(UnitCell::bcc(), cells, 0.1, {.subdivisions = 0}), Error);
  try {
    (void)beamsOf(UnitCell::weairePhelan(), cells, 0.1, {.subdivisions = 1U << 20U});
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Limit);
    EXPECT_STREQ(error.what(), "beamsOf: need at most 2^31 beams");
  }
}

}  // namespace
}  // namespace cutwater::test
