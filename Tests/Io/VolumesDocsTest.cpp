// The code of Docs/volumes.md.

#include <Cutwater/Bvh/PointCloud.hpp>
#include <Cutwater/Grid/SolidVolume.hpp>
#include <Cutwater/Io/Tables.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/InfiniteCylinder.hpp>

#include <fstream>

#include <gtest/gtest.h>

#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {
namespace {

Solid<double> cross(double radius) {
  const auto along = [=](const Vec3<double>& axis) {
    return InfiniteCylinder<double>({0.5, 0.5, 0.5}, axis, radius);
  };
  return along({1, 0, 0}) | along({0, 1, 0}) | along({0, 0, 1});
}

TEST(VolumesDocsTest, EnclosesPorosityAndRadius) {
  const auto lattice = cross(0.2);
  // [DOCS
  const Box<double> cell{{0, 0, 0}, {1, 1, 1}};
  const VolumeBounds found = solidVolume(lattice, cell, {.fraction = 0.02});
  const auto [least, most] = found.porosity();  // certainly
  const double about = 1 - found.estimate / found.boxVolume;
  // DOCS]
  EXPECT_LE(least, about);
  EXPECT_GE(most, about);

  // [DOCS
  const auto solidOf = [](double radius) { return cross(radius); };  // a Solid<double>
  const auto beams = porosityRadius<double>(0.7, solidOf, {0.05, 0.4}, cell,
                                            {.tolerance = 0.1, .volume = {.fraction = 0.02}});
  const auto [thinnest, thickest] = beams.radius;
  // DOCS]
  EXPECT_LE(thinnest, 0.2009);  // 3 pi r^2 - 8 sqrt(2) r^3 = 0.3
  EXPECT_GE(thickest, 0.2008);
}

TEST(VolumesDocsTest, FindsPointsAndBalls) {
  const std::vector<Vec3<double>> points{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}};
  const Vec3<double> p{0.9, 0, 0};
  // [DOCS
  const PointCloud<double> cloud(points);
  const Neighbor<double> nearest = cloud.nearest(p);  // .primitive, .distance
  std::array<Neighbor<double>, 2> two;
  const std::size_t count = cloud.nearest(p, two, /*limit=*/5.0);
  // DOCS]
  EXPECT_EQ(nearest.primitive, 1U);
  EXPECT_EQ(count, 2U);
  EXPECT_EQ(two[1].primitive, 0U);

  const TemporaryFolder folder;
  const auto file = folder / "bed.csv";
  std::ofstream(file) << "x,y,z,r\n0,0,0,1\n3,0,0,1\n";
  // [DOCS
  const PackedBed<double> bed(readBalls(file));
  const std::uint32_t ball = bed.closestPoint({2.5, 0.5, 2}).owner.face;
  // DOCS]
  EXPECT_EQ(ball, 1U);
}

}  // namespace
}  // namespace cutwater::test
