#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/BeamGraph.hpp>

#include <gtest/gtest.h>

namespace cutwater::test {
namespace {

TEST(BeamGraphTest, HasEveryStrutOnceAndSharesNodes) {
  const auto cubic = beamsOf(UnitCell::simpleCubic(), {{2, 1, 1}, {3, 2, 1}}, 0.1);
  EXPECT_EQ(cubic.nodes.size(), 4U * 3 * 2);
  EXPECT_EQ(cubic.beams.size(), 3U * 3 * 2 + 4 * 2 * 2 + 4 * 3 * 1);
  EXPECT_EQ(cubic.nodes[cubic.beams.back().nodes[1]].z, 1);
  EXPECT_EQ(beamsOf(UnitCell::octet(), {{1, 1, 1}, {1, 1, 1}}, 0.1).nodes.size(), 14U);
  for (const auto& cell : UnitCell::all()) {
    const auto one = beamsOf(cell, {{1, 1, 1}, {1, 1, 1}}, 0.1);
    EXPECT_EQ(one.beams.size(), cell.closedStruts().size()) << cell.name();
    double sum = 0;
    for (const auto& beam : one.beams) {
      sum += length(one.nodes[beam.nodes[0]] - one.nodes[beam.nodes[1]]);
    }
    double closed = 0;
    for (const auto& [a, b] : cell.closedStruts()) closed += length(b - a);
    EXPECT_NEAR(sum, closed, 1e-12);
  }
  EXPECT_THROW((void)beamsOf(UnitCell::bcc(), {{1, 1, 1}, {1, 0, 1}}, 0.1), Error);
  EXPECT_THROW((void)beamsOf(UnitCell::bcc(), {{1, -1, 1}, {1, 1, 1}}, 0.1), Error);
  EXPECT_THROW((void)beamsOf(UnitCell::bcc(), {{1, 1, 1}, {4096, 4096, 4096}}, 0.1), Error);
}

}  // namespace
}  // namespace cutwater::test
