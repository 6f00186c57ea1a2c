#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Operations/Algebra.hpp>
#include <Cutwater/Shapes/Plane.hpp>
#include <Cutwater/Shapes/Sphere.hpp>
#include <Cutwater/Tpms/TpmsSolid.hpp>

#include <array>

#include "Support/Guarantee.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/SameCrossings.hpp"
#include "Support/Scale.hpp"
#include "Tpms/PlainPatterns.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class TpmsSolidTest : public ::testing::Test {};
TYPED_TEST_SUITE(TpmsSolidTest, Precisions);

constexpr std::array kParts{TpmsPart::Wall,     TpmsPart::Channels, TpmsPart::ChannelA,
                            TpmsPart::ChannelB, TpmsPart::WallInA,  TpmsPart::WallInB};

/// Whether a value of F is in the part.
bool isIn(TpmsPart part, double f, double h) {
  switch (part) {
    case TpmsPart::Wall:
      return std::abs(f) < h;
    case TpmsPart::Channels:
      return std::abs(f) > h;
    case TpmsPart::ChannelA:
      return f > h;
    case TpmsPart::ChannelB:
      return f < -h;
    case TpmsPart::WallInA:
      return f > 0 && f < h;
    default:
      return f < 0 && f > -h;
  }
}

TYPED_TEST(TpmsSolidTest, PartsOfEveryPatternKeepTheirGuarantee) {
  using T = TypeParam;
  const auto plain = plainPatterns();
  std::size_t next = 0;
  for (const auto& pattern : TpmsPattern::all()) {
    SCOPED_TRACE(pattern.name());
    const double h = 0.4 * std::min(pattern.pinch(TpmsChannel::A), pattern.pinch(TpmsChannel::B));
    const auto part = kParts[next % kParts.size()];
    const auto& formula = plain[next++].value;
    constexpr double kSize = 2;
    const auto inside = [&](const Vec3<double>& p) {
      const double turn = 2 * std::numbers::pi / kSize;
      return isIn(part, formula(turn * p.x, turn * p.y, turn * p.z), static_cast<T>(h));
    };
    expectGuarantee(TpmsSolid<T>(TpmsField<T>(pattern, T(kSize)), part, static_cast<T>(h)), 1.2,
                    {.inside = inside, .probes = 1500, .lines = 24});
    expectGuarantee(TpmsSolid<T>(TpmsField<T>(pattern, T(1)), TpmsPart::ChannelA, T(0)), 0.6,
                    {.probes = 1000, .lines = 24});
  }
}

TYPED_TEST(TpmsSolidTest, StretchedCellsAndGradedLevelsKeepTheirGuarantee) {
  using T = TypeParam;
  const TpmsMap<T> map(Vec3<T>{1, 2, T(0.75)});
  const GuaranteeOptions options{.probes = 2000, .lines = 24};
  expectGuarantee(TpmsSolid<T>({TpmsPattern::gyroid(), map}, TpmsPart::Wall, T(0.4)), 1, options);
  const auto level = GradedValue<T>::byValueOf(Sphere<T>({0, 0, 0}, T(0.25)), {T(0.2), T(0.9), 1});
  for (const auto part : kParts) {
    const auto inside = [&](const Vec3<double>& p) {
      const double h = 0.2 + 0.7 * std::clamp(length(p) - 0.25, 0.0, 1.0);
      const double turn = 2 * std::numbers::pi;
      return isIn(part, plainPatterns()[1].value(turn * p.x, turn * p.y, turn * p.z), h);
    };
    expectGuarantee(TpmsSolid<T>({TpmsPattern::schwarzP(), T(1)}, part, level), 1,
                    {.inside = inside, .probes = 1000, .lines = 24});
  }
}

/// The test runs once for each instruction set.
TYPED_TEST(TpmsSolidTest, ValuesAreTheSameOnEveryInstructionSet) {
  using T = TypeParam;
  RandomPoints<T> random(T(3), 5);
  std::vector<Vec3<T>> points(100);
  for (auto& p : points) p = random.next();
  std::vector<T> all;
  std::vector<T> values(points.size());
  for (const auto& pattern : TpmsPattern::all()) {
    const TpmsSolid<T> solid({pattern, TpmsMap<T>(Vec3<T>{1, T(1.5), 2})}, TpmsPart::WallInB,
                             T(0.1));
    solid.signedDistances(points, values);
    all.insert(all.end(), values.begin(), values.end());
  }
  EXPECT_EQ(xxHash64(std::as_bytes(std::span<const T>(all))),
            sizeof(T) == 4 ? 12831404586761815146U : 5631855399450535433U);
}

TYPED_TEST(TpmsSolidTest, CrossingsOfManySegmentsAreThoseOfEach) {
  using T = TypeParam;
  RandomPoints<T> random(2, /*seed=*/11);
  std::vector<Segment<T>> segments;
  for (int i = 0; i < 150; ++i) segments.push_back({random.next(), random.next()});
  const TpmsField<T> uniform(TpmsPattern::gyroid(), T(1.5));
  EXPECT_GT(expectSameCrossings<T>(TpmsSolid<T>(uniform, TpmsPart::Wall, T(0.3)), segments), 100U);
  const TpmsField<T> around(TpmsPattern::schwarzP(), TpmsMap<T>::cylindrical({T(1), 6, T(1)}));
  Solid<T> channel = TpmsSolid<T>(around, TpmsPart::ChannelA, T(0.1));
  channel.rotate(20, 1);
  EXPECT_GT(expectSameCrossings<T>(channel, segments), 100U);
}

TYPED_TEST(TpmsSolidTest, MovedOnesKeepTheirGuarantee) {
  using T = TypeParam;
  TpmsSolid<T> solid({TpmsPattern::frd(), T(1)}, TpmsPart::ChannelB, T(-0.3));
  solid.rotate(30, {1, 2, 3});
  solid.translate({3, T(0.1), -2});
  expectGuarantee(solid, 0.8, {.probes = 2000, .lines = 24});
  const Solid<T> ball = Sphere<T>({0, 0, 0}, T(0.9)) & solid;
  EXPECT_EQ(ball.guarantee().outside, Quality::LowerBound);
  expectGuarantee(ball, 1.2, {.probes = 2000, .lines = 24});
}

TEST(TpmsSolidsTest, FloatKeepsToItsRounding) {
  for (const auto& pattern : TpmsPattern::all()) {
    const float level = 0.5F * static_cast<float>(std::min(pattern.pinch(TpmsChannel::A),
                                                           pattern.pinch(TpmsChannel::B)));
    for (const auto part : kParts) {
      expectRounding(TpmsSolid<float>({pattern, 2.0F}, part, level),
                     TpmsSolid<double>({pattern, 2.0}, part, level), 3);
    }
  }
}

TEST(TpmsSolidsTest, BoundsAreNear) {
  // Of a bare pattern: of the distance, the bound near the surface is most of it.
  const TpmsSolid<double> half({TpmsPattern::schwarzP(), 2 * std::numbers::pi}, TpmsPart::ChannelB,
                               0);
  const double root = std::numbers::pi / 2;
  EXPECT_NEAR(half.signedDistance({root - 0.1, root - 0.1, root - 0.1}), 0.1 * std::sqrt(3.0),
              0.02);
  EXPECT_EQ(half.classify({{1.2, 1.2, 1.2}, {1.3, 1.3, 1.3}}), BoxClass::Outside);
  EXPECT_EQ(half.classify({{1.8, 1.8, 1.8}, {1.9, 1.9, 1.9}}), BoxClass::Inside);
  EXPECT_EQ(half.classify({{1.5, 1.5, 1.5}, {1.6, 1.6, 1.6}}), BoxClass::Cut);
}

TEST(TpmsSolidsTest, PartsOfOneLevelFitToTheBit) {
  const std::array<TpmsField<double>, 2> fields{
      TpmsField<double>(TpmsPattern::iwp(), 1.7),
      TpmsField<double>(TpmsPattern::iwp(),
                        TpmsMap<double>(1.7).deformed({.amplitude = 0.1, .spacing = {1, 1, 1}}))};
  for (const auto& field : fields) {
    const TpmsSolid<double> wall(field, TpmsPart::Wall, 0.8);
    const TpmsSolid<double> channels(field, TpmsPart::Channels, 0.8);
    const TpmsSolid<double> a(field, TpmsPart::ChannelA, 0.8);
    const TpmsSolid<double> b(field, TpmsPart::ChannelB, 0.8);
    RandomPoints<double> random(3);
    std::array<int, 2> inside{};
    for (int i = 0; i < scaled(3000); ++i) {
      const auto p = random.next();
      const double ofWall = wall.signedDistance(p);
      const double ofA = a.signedDistance(p);
      const double ofB = b.signedDistance(p);
      ASSERT_EQ(channels.signedDistance(p), -ofWall);
      ASSERT_EQ((ofWall < 0 ? 1 : 0) + (ofA < 0 ? 1 : 0) + (ofB < 0 ? 1 : 0), 1) << p;
      ASSERT_EQ(std::min(ofA, ofB), -ofWall);
      ++inside[ofWall < 0 ? 0 : 1];
    }
    EXPECT_GT(inside[0], 300);
    EXPECT_GT(inside[1], 300);
  }
}

TEST(TpmsSolidsTest, RefusesLevelsAtWhichChannelsBreakUp) {
  const auto make = [](const TpmsPattern& pattern, TpmsPart part, GradedValue<double> level) {
    return TpmsSolid<double>({pattern, 1.0}, part, std::move(level));
  };
  const auto lidinoid = TpmsPattern::lidinoid();  // pinches .93683 and .17394
  EXPECT_NO_THROW(make(lidinoid, TpmsPart::Wall, 0.17));
  EXPECT_THROW(make(lidinoid, TpmsPart::Wall, 0.18), Error);
  EXPECT_THROW(make(lidinoid, TpmsPart::Channels, 0.18), Error);
  EXPECT_THROW(make(lidinoid, TpmsPart::WallInB, 0.18), Error);
  EXPECT_NO_THROW(make(lidinoid, TpmsPart::WallInA, 0.18));
  EXPECT_NO_THROW(make(lidinoid, TpmsPart::ChannelA, 0.93));
  EXPECT_THROW(make(lidinoid, TpmsPart::ChannelA, 0.94), Error);
  EXPECT_THROW(make(lidinoid, TpmsPart::ChannelA, -0.18), Error);
  EXPECT_NO_THROW(make(lidinoid, TpmsPart::ChannelB, -0.9));
  EXPECT_THROW(make(lidinoid, TpmsPart::ChannelB, 0.18), Error);
  const auto gyroid = TpmsPattern::gyroid();
  const auto plane = Plane<double>({0, 0, 0}, {0, 0, 1});
  for (const double bad : {0.0, -0.1, 1.41421, 2.0}) {
    EXPECT_THROW(make(gyroid, TpmsPart::Wall, bad), Error) << bad;
  }
  EXPECT_THROW(make(gyroid, TpmsPart::Wall, GradedValue<double>::byValueOf(plane, {0.2, 1.5, 1})),
               Error);
  EXPECT_THROW(make(gyroid, TpmsPart::Wall, std::nan("")), Error);
  EXPECT_THROW(make(gyroid, TpmsPart::ChannelA, std::nan("")), Error);
}

}  // namespace
}  // namespace cutwater::test
