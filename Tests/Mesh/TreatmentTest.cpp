#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Mesh/Diagnosis.hpp>
#include <Cutwater/Surface/SurfaceMeasure.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <tuple>

#include "DiagnosisCases.hpp"

namespace cutwater::test {
namespace {

TEST(TreatmentTest, CapsAndMirrorImagesCloseOpeningsInPlanes) {
  const auto soup = openBox();
  const auto found = diagnose(soup);
  ASSERT_EQ(found.openings.size(), 1U);
  EXPECT_EQ(found.openings[0].edges, 4U);
  EXPECT_EQ(found.openings[0].plane, (AxisPlane{2, 1}));
  EXPECT_EQ(found.openings[0].box.lower, (Vec3<double>{0, 0, 1}));
  ASSERT_EQ(found.treatments.size(), 2U);
  const auto& [capped, mirrored] = std::tie(found.treatments[0], found.treatments[1]);
  ASSERT_EQ(capped.closings.size(), 1U);
  EXPECT_EQ(capped.closings[0].kind, ClosingKind::Cap);
  EXPECT_EQ(capped.closings[0].plane, (AxisPlane{2, 1}));
  EXPECT_EQ(capped.tolerance, 0);
  EXPECT_EQ(capped.effect, "openings closed: 1; closed then");
  expectCure(soup, capped, 6, 1);
  ASSERT_EQ(mirrored.closings.size(), 1U);
  EXPECT_EQ(mirrored.closings[0].kind, ClosingKind::Mirror);
  expectCure(soup, mirrored, 10, 2);
  EXPECT_FALSE(found.wrapGap);  // there is something better
}

TEST(TreatmentTest, RimsThatAreNearlyPlaneGetATolerance) {
  auto points = kCorners;
  for (auto& p : points) {
    if (p.z == 1) p.z += 2e-6 * (p.x - p.y);
  }
  const auto soup = makeSoup(points, kOpenSides);
  const auto found = diagnose(soup);
  ASSERT_FALSE(found.treatments.empty());
  EXPECT_EQ(found.treatments[0].closings[0].plane, (AxisPlane{2, 1}));
  EXPECT_GE(found.treatments[0].tolerance, 2e-6);
  EXPECT_LE(found.treatments[0].tolerance, 6e-6);
  expectCure(soup, found.treatments[0], 6, 1);
}

TEST(TreatmentTest, ToleranceOfWelding) {
  Points points;  // every face with points of its own, in turns 3e-7 off
  Faces faces;
  for (const auto& face : kSides) {
    auto& own = faces.emplace_back();
    for (std::size_t i = 0; i < 4; ++i) {
      auto p = kCorners[face[i]];
      for (int k = 0; k < 3; ++k) {
        p[k] += 3e-7 * (static_cast<double>((points.size() + static_cast<std::size_t>(k)) % 3) - 1);
      }
      own.push_back(static_cast<std::uint32_t>(points.size()));
      points.push_back(p);
    }
  }
  const auto soup = makeSoup(points, faces);
  const auto found = diagnose(soup);
  expectDefect(found, "openEdges", Severity::Warning, 24);
  ASSERT_EQ(found.treatments.size(), 1U);
  const auto weld = found.treatments[0].clean.weldWithin;
  ASSERT_TRUE(weld);
  EXPECT_GT(*weld, 3e-7);
  EXPECT_LT(*weld, 1e-5);
  expectCure(soup, found.treatments[0], 6, 1);
}

TEST(TreatmentTest, ToleranceOfJunctions) {
  const auto soup =
      makeSoup(joined(kCorners, Points{{0.5, 0, 0}}),
               {kSides[0], {0, 8, 5, 4}, {8, 1, 5}, kSides[2], kSides[3], kSides[4], kSides[5]});
  const auto found = diagnose(soup);
  ASSERT_EQ(found.treatments.size(), 1U);
  EXPECT_TRUE(found.treatments[0].clean.splitJunctionsWithin);
  expectCure(soup, found.treatments[0], 6, 1);
}

TEST(TreatmentTest, TerrainsAreExtended) {
  constexpr std::uint32_t kSize = 5;
  Points points;
  Faces faces;
  for (std::uint32_t i = 0; i < kSize * kSize; ++i) {
    const auto x = i % kSize;
    const auto y = i / kSize;
    points.push_back({double(x), double(y), 0.25 * (x * y % 3)});
    if (x + 1 < kSize && y + 1 < kSize) faces.push_back({i, i + 1, i + kSize + 1, i + kSize});
  }
  const auto soup = makeSoup(points, faces);
  const auto found = diagnose(soup);
  ASSERT_EQ(found.treatments.size(), 1U);
  const auto& treatment = found.treatments[0];
  ASSERT_EQ(treatment.closings.size(), 1U);
  EXPECT_EQ(treatment.closings[0].kind, ClosingKind::Extend);
  EXPECT_EQ(treatment.closings[0].plane.axis, 2);
  EXPECT_LT(treatment.closings[0].plane.at, 0);
  auto ground = soup;
  treat(ground, treatment);
  EXPECT_TRUE(diagnose(ground).isSound());
  EXPECT_EQ(ground.boundingBox().lower.z, treatment.closings[0].plane.at);
}

/// A ball without one of its triangles, whose hole lies in no plane across an axis.
PolygonSoup ballWithHole() {
  auto soup = tessellation::icosphere(1.0, 2);
  soup.corners.resize(soup.corners.size() - 3);
  soup.offsets.pop_back();
  soup.patches.pop_back();
  return soup;
}

TEST(TreatmentTest, HolesAreFilledByWhatTheCallerBrings) {
  const auto soup = ballWithHole();
  const auto without = diagnose(soup);
  ASSERT_EQ(without.openings.size(), 1U);
  EXPECT_FALSE(without.openings[0].plane);
  EXPECT_TRUE(std::ranges::none_of(without.treatments, &Treatment::isClosed));

  // Fills the only hole there is.
  double asked = 0;
  const HoleFilling filling = [&](PolygonSoup& ball, double widest) {
    asked = widest;
    const auto rims = findRims(ball);
    for (const auto& rim : rims) ball.addPolygon(rim.points);
    return rims.size();
  };
  const auto with = diagnose(soup, {.fillHoles = filling});
  ASSERT_EQ(with.treatments.size(), 1U);
  EXPECT_EQ(with.treatments[0].widestHole, asked);
  EXPECT_NEAR(asked, 0.3 * soup.boundingBox().diagonal(), 0.1 * asked);
  EXPECT_EQ(with.treatments[0].effect, "holes filled: 1; closed then");
  const auto whole = measure(tessellation::icosphere(1.0, 2));
  expectCure(soup, with.treatments[0], whole.area, whole.volume, filling);
  auto copy = soup;
  EXPECT_THROW(treat(copy, with.treatments[0]), Error);  // needs the function, too
}

TEST(TreatmentTest, AWrapIsNamedWhereNothingElseCloses) {
  // Two blades, in planes across axes: a cap would be the blade again.
  const auto soup = makeSoup(
      {{0, 0, 1}, {0, 1, 1}, {0, 1, 2}, {0, 0, 2}, {0, 0, 4}, {1, 0, 4}, {1, 0, 5}, {0, 0, 5}},
      {{0, 1, 2, 3}, {4, 5, 6, 7}});
  const auto found = diagnose(soup);
  EXPECT_TRUE(found.treatments.empty());
  EXPECT_EQ(found.wrapGap, 0.1);  // a thirtieth of the diagonal, of one digit
}

}  // namespace
}  // namespace cutwater::test
