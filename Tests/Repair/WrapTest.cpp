#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Repair/Wrap.hpp>

#include <cmath>

#include "RepairChecks.hpp"

namespace cutwater::test {
namespace {

/// A box with most of what goes wrong: faces missing, turned, doubled, unwelded, one through it.
PolygonSoup wreck() {
  auto soup = tessellation::box({0, 0, 0}, {3, 2, 1}, 4);
  soup = onlyFaces(soup, [](std::size_t i) { return i % 17 != 3; });
  for (std::size_t i = 0; i < soup.polygonCount(); i += 5) soup = flipped(std::move(soup), i);
  soup = together(soup, onlyFaces(soup, [](std::size_t i) { return i < 9; }));
  soup = jittered(unwelded(soup), 1e-4);
  const std::uint32_t first = static_cast<std::uint32_t>(soup.points.size());
  soup.points.insert(soup.points.end(), {{1, 1, -1}, {2, 1, -1}, {1.5, 1.2, 2}});
  soup.addPolygon(std::array{first, first + 1, first + 2});
  return soup;
}

void expectEncloses(const PolygonSoup& wrapped, const PolygonSoup& soup) {
  const MeshSDF<double> solid(wrapped, {.requireWatertight = true});
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    EXPECT_LT(solid.signedDistance(middleOf(soup, i)), 0) << i;
    for (const auto corner : soup.polygon(i)) {
      EXPECT_LT(solid.signedDistance(soup.points[corner]), 0) << i;
    }
  }
}

TEST(Wrap, AWreckBecomesASolid) {
  const auto before = wreck();
  auto soup = before;
  const auto report = wrap(soup, {.gap = 1.2, .offset = 0.02});
  expectSolid(soup);
  expectEncloses(soup, before);
  EXPECT_EQ(reportOf(soup).components, 1U);
  EXPECT_EQ(report.facesBefore, before.polygonCount());
  EXPECT_EQ(report.facesAfter, soup.polygonCount());
  EXPECT_LT(report.nearest, 0.02 * 1.02);
  EXPECT_GT(report.nearest, 0);
  // A missing face of 0.75 by 0.5 is closed, and a ball of 1.2 does not reach further into it.
  EXPECT_GT(report.farthest, 0.1);
  EXPECT_LT(report.farthest, 0.6 + 0.02);
  EXPECT_GT(report.after.volume, 6);
  EXPECT_LT(report.after.volume, 7.5);
}

TEST(Wrap, FacesHaveThePatchThatTheyAreNearestTo) {
  auto soup = cube();
  soup.patchNames = {"x0", "x1", "y0", "y1", "z0", "z1"};
  soup.patches = {0, 1, 2, 3, 4, 5};
  wrap(soup, {.gap = 0.3});
  EXPECT_EQ(soup.patchNames.size(), 6U);
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto p = middleOf(soup, i) - Vec3<double>{0.5, 0.5, 0.5};
    const int axis = static_cast<int>(soup.patches[i]) / 2;
    const double outward = soup.patches[i] % 2 == 0 ? -p[axis] : p[axis];
    EXPECT_NEAR(outward, std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 0.01)
        << i;  // the offset, around edges
  }
}

TEST(Wrap, TheGapDecidesWhatIsClosed) {
  // A box without its lid: seen from above, an opening of 1 by 1.
  const auto open = onlyFaces(cube(), [](std::size_t i) { return i != 5; });
  auto closed = open;
  wrap(closed, {.gap = 1.6, .offset = 0.02});
  EXPECT_GT(measure(closed).volume, 1);
  auto hollow = open;
  wrap(hollow, {.gap = 0.4, .offset = 0.02});
  EXPECT_LT(measure(hollow).volume, 0.4);  // walls, from within and from without
  EXPECT_GT(measure(hollow).volume, 5 * 2 * 0.02 * 0.9);
}

TEST(Wrap, SizeAndPlaceDoNotMatter) {
  auto small = wreck();
  const auto reference = wrap(small, {.gap = 1.2, .offset = 0.02});
  for (const double scale : {0x1p-40, 0x1p40}) {
    auto soup = withPoints(wreck(), [&](const auto& p) { return scale * p; });
    const auto report = wrap(soup, {.gap = 1.2 * scale, .offset = 0.02 * scale});
    EXPECT_EQ(soup.corners, small.corners);
    EXPECT_EQ(report.after.volume, reference.after.volume * scale * scale * scale);
  }
  auto far = moved(wreck(), {1e6, -1e6, 1e6});
  wrap(far, {.gap = 1.2, .offset = 0.02});
  expectSolid(far);
  EXPECT_NEAR(measure(far).volume, reference.after.volume, 0.05 * reference.after.volume);
}

ErrorKind kindOf(const WrapOptions& options, PolygonSoup soup = cube()) {
  const auto before = soup;
  try {
    wrap(soup, options);
  } catch (const Error& error) {
    EXPECT_TRUE(sameSoup(soup, before));
    return error.kind();
  }
  ADD_FAILURE() << "was not refused";
  return ErrorKind::File;
}

TEST(Wrap, IsEstimatedFirst) {
  const auto ball = tessellation::icosphere(1, 4);
  const WrapOptions options{.gap = 0.08};
  const auto expected = estimateWrap(ball, options);
  EXPECT_EQ(expected.gap, 0.08);
  auto soup = ball;
  double before = 0;
  auto watched = options;
  watched.progress = [&](double fraction) {
    EXPECT_LE(before, fraction);
    EXPECT_LE(fraction, 1);
    before = fraction;
  };
  const auto report = wrap(soup, watched);
  EXPECT_NEAR(expected.triangles / static_cast<double>(report.facesAfter), 1, 0.3);
  EXPECT_GT(before, 0.3);
  EXPECT_GT(expected.seconds, 0.1 * report.seconds);  // the machine may be busy meanwhile
  EXPECT_LT(expected.seconds, 10 * report.seconds);
}

TEST(Wrap, NamesTheGapThatFits) {
  const WrapEstimate expected{.gap = 0.1, .triangles = 1e6, .seconds = 101, .secondsAtOnce = 1};
  EXPECT_DOUBLE_EQ(expected.gapWithin(101), 0.1);
  EXPECT_DOUBLE_EQ(expected.gapWithin(26), 0.2);
  EXPECT_DOUBLE_EQ(expected.gapWithin(51), 0.15);  // 0.1 sqrt(2), rounded up
  EXPECT_TRUE(std::isinf(expected.gapWithin(1)));
}

TEST(Wrap, Refusals) {
  EXPECT_EQ(kindOf({}), ErrorKind::Argument);
  EXPECT_EQ(kindOf({.gap = -1}), ErrorKind::Argument);
  EXPECT_EQ(kindOf({.gap = 0.1, .offset = 0.0}), ErrorKind::Argument);
  EXPECT_EQ(kindOf({.gap = 0.1, .seconds = 0}), ErrorKind::Argument);
  EXPECT_EQ(kindOf({.gap = 1e-5}), ErrorKind::Limit);
  EXPECT_EQ(kindOf({.gap = 0.1, .offset = 1e-15}), ErrorKind::Limit);
  EXPECT_EQ(kindOf({.gap = 0.01, .seconds = 1e-3}), ErrorKind::Limit);
  EXPECT_EQ(kindOf({.gap = 0.1}, PolygonSoup{}), ErrorKind::Topology);
}

}  // namespace
}  // namespace cutwater::test
