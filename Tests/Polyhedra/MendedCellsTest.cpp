#include <Cutwater/Polyhedra/Detail/EditedMesh.hpp>
#include <Cutwater/Polyhedra/Detail/MendedCells.hpp>

#include <numeric>
#include <utility>

#include <gtest/gtest.h>

#include "Bricks.hpp"

namespace cutwater::test {
namespace {

/// Two cells, one of them a thin angle around the other: its center is within that one.
FluidMesh thinAngle() {
  EditedMesh mesh(brick({2, 2, 1}));
  static_cast<void>(mesh.join(mesh.join(0, 1), 2));
  auto angle = std::move(mesh).take();
  for (auto& point : angle.points) {
    if (point.x == 1) point.x = 0.25;
    if (point.y == 1) point.y = 0.25;
  }
  angle.cells.volume = {0.9375, 3.0625};
  return angle;
}

/// What checkMesh would tell of.
std::size_t flawsOf(const FluidMesh& mesh) {
  const auto report = check(mesh);
  return report.invertedFaces + report.invertedCells + report.skewFaces + report.nonOrthogonalFaces;
}

TEST(MendedCellsTest, ASoundMeshIsAsItWas) {
  const auto row = brick({5, 2, 1});
  expectSame(withMendedCells(row, {}), row);
}

TEST(MendedCellsTest, AnAngleIsDividedOrJoined) {
  const auto angle = thinAngle();
  EXPECT_GT(flawsOf(angle), 0U);
  for (const bool joins : {false, true}) {
    const auto mended = withMendedCells(angle, {.joins = joins});
    expectClosed(mended);
    EXPECT_EQ(joins ? flawsOf(mended) : check(mended).invertedFaces, 0U);
    EXPECT_EQ(mended.cells.leaf.size(), joins ? 1U : 3U);
    EXPECT_EQ(mended.joinedPieces, joins ? 3U : 2U);
    const auto& volume = mended.cells.volume;
    EXPECT_NEAR(std::accumulate(volume.begin(), volume.end(), 0.0), 4, 1e-14);
    EXPECT_NEAR(check(mended).meshVolume, 4, 1e-14);
  }
}

}  // namespace
}  // namespace cutwater::test
