#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Render/CutPlane.hpp>

#include <array>

#include <gtest/gtest.h>

#include "Support/Random.hpp"

namespace cutwater::test {
namespace {

using detail::KeptRegion;
using detail::Ray;

const Box<double> kBox{{-1, -1, -1}, {1, 1, 1}};

TEST(CutPlaneTest, KeepsTheSideThatIsAskedFor) {
  EXPECT_EQ(CutPlane::across(1, 0.5).beyond({9, 2, 9}), 1.5);
  EXPECT_EQ(CutPlane::across(1, 0.5, CutPlane::Keep::Upper).beyond({9, 2, 9}), -1.5);
  EXPECT_DOUBLE_EQ(CutPlane::through({1, 1, 1}, {0, 3, 4}).beyond({7, 1, 2}), 0.8);
}

TEST(CutPlaneTest, RaysKeepWhatPointsSay) {
  const std::array cuts{CutPlane::across(2, 0.3), CutPlane::through({0.2, 0, 0}, {1, 1, 0.5}),
                        CutPlane::across(0, -0.7, CutPlane::Keep::Upper)};
  const KeptRegion region(kBox, cuts, false);
  const auto isKept = [&](const Vec3<double>& p) {
    return kBox.contains(p) && region.clearance(p) == 0;
  };
  RandomPoints<double> wide(2, 5);
  RandomPoints<double> within(1, 6);
  for (int i = 0; i < 500; ++i) {
    const auto from = wide.next();
    const Ray ray{from, normalized(within.next() - from)};
    const auto range = region.clip(ray, 0);
    for (int step = 0; step < 700; ++step) {
      const double along = 0.01 * step + 0.003;
      const bool inside = range.begin < along && along < range.end;
      const double edge = std::min(std::abs(along - range.begin), std::abs(along - range.end));
      if (!range.empty() && edge < 1e-9) continue;
      ASSERT_EQ(inside, isKept(ray.at(along))) << i << ' ' << along;
    }
    if (range.empty() || range.cut == kNone) continue;
    const auto& cut = cuts.at(range.cut);
    ASSERT_NEAR(cut.beyond(ray.at(range.begin)), 0, 1e-12);
    ASSERT_LT(dot(region.normal(range.cut), ray.direction), 0);
  }
}

TEST(CutPlaneTest, SidesOfARegionCut) {
  const Ray ray{{5, 0.2, 0.1}, {-1, 0, 0}};
  EXPECT_EQ(KeptRegion(kBox, {}, false).clip(ray, 0).cut, kNone);
  const KeptRegion cutting(kBox, {}, true);
  const auto range = cutting.clip(ray, 0);
  ASSERT_NE(range.cut, kNone);
  EXPECT_EQ(cutting.normal(range.cut), Vec3<double>(1, 0, 0));
  EXPECT_EQ(range.begin, 4);
  EXPECT_EQ(range.end, 6);
}

TEST(CutPlaneTest, TheRestOfTheBox) {
  const std::array cuts{CutPlane::across(2, 0.3), CutPlane::across(0, -0.7, CutPlane::Keep::Upper),
                        CutPlane::through({0, 0, 0}, {1, 1, 1})};
  const KeptRegion region(kBox, cuts, false);
  EXPECT_EQ(region.rest(), (Box<double>{{-0.7, -1, -1}, {1, 1, 0.3}}));
}

TEST(CutPlaneTest, DirectionsMayHaveAnyLength) {
  for (const double length : {1e-310, 1e-200, 1e200}) {
    const auto plane = CutPlane::through({1, 0, 0}, {length, 0, 0});
    EXPECT_EQ(plane.normal, (Vec3<double>{1, 0, 0}));
    EXPECT_EQ(plane.offset, 1);
  }
}

TEST(CutPlaneTest, Refusals) {
  EXPECT_THROW(CutPlane::across(3, 0), Error);
  EXPECT_THROW(CutPlane::across(0, NAN), Error);
  EXPECT_THROW(CutPlane::through({0, 0, 0}, {0, 0, 0}), Error);
  EXPECT_THROW(CutPlane::through({0, 0, INFINITY}, {0, 0, 1}), Error);
}

}  // namespace
}  // namespace cutwater::test
