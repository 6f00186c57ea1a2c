#include <Cutwater/Io/Tables.hpp>
#include <Cutwater/Lattice/BeamLattice.hpp>

#include <fstream>
#include <random>

#include <gtest/gtest.h>

#include "Support/Random.hpp"
#include "TableFile.hpp"

namespace cutwater::test {
namespace {

void expectSame(const BeamGraph& a, const BeamGraph& b) {
  EXPECT_EQ(a.nodes, b.nodes);
  ASSERT_EQ(a.beams.size(), b.beams.size());
  for (std::size_t i = 0; i < a.beams.size(); ++i) {
    EXPECT_EQ(a.beams[i].nodes, b.beams[i].nodes);
    EXPECT_EQ(a.beams[i].radii, b.beams[i].radii);
    EXPECT_EQ(a.beams[i].body, b.beams[i].body);
    EXPECT_EQ(a.beams[i].caps, b.beams[i].caps);
  }
  ASSERT_EQ(a.balls.size(), b.balls.size());
  for (std::size_t i = 0; i < a.balls.size(); ++i) {
    EXPECT_EQ(a.balls[i].node, b.balls[i].node);
    EXPECT_EQ(a.balls[i].radius, b.balls[i].radius);
  }
}

using BeamTableTest = TableFile<readBeams>;

TEST_F(BeamTableTest, ReadsNodesBeamsAndBalls) {
  const auto graph = read(
      "# a lattice\nnode, 0, 0, 0\nNode,1e-1,-2,3\nbeam,0,1,.5,0.25\n\n"
      "node,5,5,5\nbeam,2,1,0,1,Butt,hemisphere\nball,2,3\n");
  BeamGraph expected{{{0, 0, 0}, {0.1, -2, 3}, {5, 5, 5}},
                     {{{0, 1}, {0.5, 0.25}},
                      {{2, 1}, {0, 1}, BeamBody::Frustum, {BeamCap::Butt, BeamCap::Hemisphere}}},
                     {{2, 3}}};
  expectSame(graph, expected);
  for (auto& p : expected.nodes) p = 2.0 * p;
  for (auto& beam : expected.beams) beam.radii = {2 * beam.radii[0], 2 * beam.radii[1]};
  expected.balls[0].radius = 6;
  expectSame(read("node,0,0,0\nnode,.1,-2,3\nnode,5,5,5\nbeam,0,1,.5,.25\n"
                  "beam,2,1,0,1,butt,hemisphere\nball,2,3",
                  {.scale = 2}),
             expected);
}

TEST_F(BeamTableTest, SkipsLinesOfCommentsAlone) {
  const auto graph = read("# a lattice\nnode, 0, 0, 0\n  # of\nnode, 1, 0, 0\nbeam, 0, 1, 1, 1\n#");
  EXPECT_EQ(graph.nodes.size(), 2U);
  EXPECT_EQ(graph.beams.size(), 1U);
  EXPECT_EQ(refusal("node, 0, 0, 0 # here\n"), "line 1: expected a number, found \"0 # here\"");
}

TEST_F(BeamTableTest, ReadsBackWhatItWrote) {
  RandomPoints<double> random(1, 6);
  BeamGraph graph;
  for (std::uint32_t i = 0; i < 500; ++i) {
    graph.nodes.push_back(std::ldexp(1.0, static_cast<int>(i % 60) - 30) * random.next());
    if (i == 0) continue;
    const auto radii = abs(random.next());
    BeamGraph::Beam beam{{i, i / 2}, {radii.x, i % 5 == 0 ? 0.0 : radii.y}};
    if (i % 3 == 0) {
      beam.body = BeamBody::Frustum;
      beam.caps = {static_cast<BeamCap>(i % 9 / 3), static_cast<BeamCap>(i % 27 / 9)};
    }
    graph.beams.push_back(beam);
    if (i % 7 == 0) graph.balls.push_back({i, radii.z});
  }
  writeBeams(file, graph);
  const auto again = readBeams(file);
  expectSame(again, graph);
  const BeamLattice<double> before(graph);
  const BeamLattice<double> after(again);
  for (int i = 0; i < 100; ++i) {
    const auto p = random.next();
    EXPECT_EQ(after.signedDistance(p), before.signedDistance(p));
  }
}

TEST_F(BeamTableTest, RefusesFilesThatLieWithTheLine) {
  const std::string nodes = "node,0,0,0\nnode,1,0,0\n";
  EXPECT_EQ(refusal(nodes + "beam,0,2,1,1\n"), "line 3: there is no node 2 among the 2 before");
  EXPECT_EQ(refusal(nodes + "beam,0,-1,1,1\n"), "line 3: there is no node -1 among the 2 before");
  EXPECT_EQ(refusal(nodes + "ball,7,1\n"), "line 3: there is no node 7 among the 2 before");
  EXPECT_EQ(refusal("beam,0,1,1,1\n" + nodes), "line 1: there is no node 0 among the 0 before");
  EXPECT_EQ(refusal(nodes + "beam,0,0.5,1,1\n"), "line 3: expected an integer, found \"0.5\"");
  EXPECT_EQ(refusal(nodes + "beam,0,1,-1,1\n"), "line 3: need radii that are not negative");
  EXPECT_EQ(refusal(nodes + "beam,0,1,0,0\n"), "line 3: need a radius above 0");
  EXPECT_EQ(refusal(nodes + "ball,0,0\n"), "line 3: need a radius above 0");
  EXPECT_EQ(refusal(nodes + "beam,0,1,1\n"), "line 3: need 5 fields, found 4");
  EXPECT_EQ(refusal(nodes + "beam,0,1,1,1,butt\n"), "line 3: need 5 fields, found 6");
  EXPECT_EQ(refusal(nodes + "beam,0,1,1,1,butt,round\n"),
            "line 3: expected butt, hemisphere or sphere, found \"round\"");
  EXPECT_EQ(refusal(nodes + "beam,1,1,1,1,butt,butt\n"),
            "line 3: a frustum needs nodes in two places");
  EXPECT_EQ(refusal(nodes + "strut,0,1,1,1\n"),
            "line 3: expected node, beam or ball, found \"strut\"");
  EXPECT_EQ(refusal("node,0,0,inf\n"), "line 1: need finite numbers, found \"inf\"");
  EXPECT_EQ(refusal(nodes), "line 2: the file ends without a beam");
}

TEST_F(BeamTableTest, ReadsOrRefusesWhateverIsChanged) {
  const std::string good =
      "node,0,0,0\nnode,1e2,-.5,3\nbeam,0,1,.5,0.25\nbeam,1,0,1,0,butt,sphere\nball,1,2\n";
  const std::string_view bytes = "0123456789.,-+e# \n\r\tnbx\xff";
  std::mt19937 random(9);
  int read = 0;
  int refused = 0;
  for (int i = 0; i < 1000; ++i) {
    auto text = good;
    for (auto changes = 1 + random() % 2; changes > 0; --changes) {
      text[random() % text.size()] = bytes[random() % bytes.size()];
    }
    std::ofstream(file, std::ios::binary) << text;
    try {
      const auto graph = readBeams(file);
      ++read;
      writeBeams(file, graph);
      expectSame(readBeams(file), graph);
    } catch (const Error& error) {
      ++refused;
      EXPECT_EQ(error.kind(), ErrorKind::File) << text;
      EXPECT_TRUE(std::string(error.what()).starts_with(file.string() + ": line ")) << error.what();
    }
  }
  EXPECT_GT(read, 50);
  EXPECT_GT(refused, 50);
}

TEST_F(BeamTableTest, WritesNothingThatItWouldRefuse) {
  const std::vector<Vec3<double>> nodes{{0, 0, 0}, {1, 0, 0}};
  const auto refuses = [&](const BeamGraph& graph) {
    EXPECT_THROW(writeBeams(file, graph), Error);
    EXPECT_FALSE(std::filesystem::exists(file));
  };
  refuses({nodes, {}, {}});
  refuses({nodes, {{{0, 2}, {1, 1}}}, {}});
  refuses({nodes, {{{0, 1}, {-1, 1}}}, {}});
  refuses({nodes, {{{0, 1}, {0, 0}}}, {}});
  refuses({nodes, {{{1, 1}, {1, 1}, BeamBody::Frustum}}, {}});
  refuses({nodes, {}, {{0, 0}}});
  refuses({nodes, {}, {{2, 1}}});
  refuses({{{std::nan(""), 0, 0}}, {}, {{0, 1}}});
}

}  // namespace
}  // namespace cutwater::test
