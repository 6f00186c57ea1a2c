#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/Tpms/Detail/PatternBatch.hpp>

#include <array>
#include <complex>
#include <numbers>

#include <gtest/gtest.h>

#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"
#include "Tpms/GreatestValue.hpp"
#include "Tpms/PlainPatterns.hpp"

namespace cutwater::test {
namespace {

template <typename T>
class TpmsPatternTest : public ::testing::Test {};
TYPED_TEST_SUITE(TpmsPatternTest, Precisions);

/// Each pattern with its plain formula.
template <typename Check>
void forPatterns(const Check& check) {
  const auto plain = plainPatterns();
  const auto all = TpmsPattern::all();
  ASSERT_EQ(all.size(), plain.size());
  for (std::size_t i = 0; i < all.size(); ++i) {
    SCOPED_TRACE(plain[i].name);
    EXPECT_EQ(all[i].name(), plain[i].name);
    check(all[i], plain[i]);
  }
}

double plainValue(const PlainPattern& plain, const Vec3<double>& turns) {
  return plain.value(kTurn * turns.x, kTurn * turns.y, kTurn * turns.z);
}

TYPED_TEST(TpmsPatternTest, ValuesAndGradientsAreThoseOfThePlainFormulas) {
  using T = TypeParam;
  forPatterns([](const TpmsPattern& pattern, const PlainPattern& plain) {
    RandomPoints<T> random(T(1.5));
    for (int i = 0; i < scaled(2000); ++i) {
      const auto p = random.next();
      const auto sample = pattern.sample(p);
      const Vec3<double> exactly(p);
      const double value = plainValue(plain, exactly);
      const double size = std::max(pattern.range().upper, -pattern.range().lower);
      EXPECT_NEAR(double{sample.value}, value, tolerance<T>(1, 20) * size) << p;
      EXPECT_EQ(pattern.value(p), sample.value);
      for (int axis = 0; axis < 3; ++axis) {
        Vec3<double> step;
        step[axis] = 1e-5;
        const double slope =
            (plainValue(plain, exactly + step) - plainValue(plain, exactly - step)) / 2e-5 / kTurn;
        EXPECT_NEAR(double{sample.gradient[axis]}, slope, 1e-6 + tolerance<T>(1, 20) * size) << p;
      }
    }
  });
}

TYPED_TEST(TpmsPatternTest, BatchesAreOnePointAfterTheOther) {
  using T = TypeParam;
  for (const auto& pattern : TpmsPattern::all()) {
    RandomPoints<T> random(T(3), 3);
    detail::PatternBatch<T> batch;
    for (const int count : {1, 7, 63, 64}) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const auto p = random.next();
        for (std::size_t axis = 0; axis < 3; ++axis) {
          batch.inCells[axis][i] = p[static_cast<int>(axis)];
        }
      }
      detail::samplePattern(pattern.kind(), batch, count);
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        const auto alone =
            pattern.sample(Vec3<T>{batch.inCells[0][i], batch.inCells[1][i], batch.inCells[2][i]});
        ASSERT_EQ(alone.value, batch.value[i]) << pattern.name();
        ASSERT_EQ(alone.gradient,
                  (Vec3<T>{batch.gradient[0][i], batch.gradient[1][i], batch.gradient[2][i]}));
      }
    }
  }
}

/// The test runs once for each instruction set.
TYPED_TEST(TpmsPatternTest, AreTheSameOnEveryInstructionSet) {
  using T = TypeParam;
  std::vector<T> values;
  RandomPoints<T> random(T(3), 3);
  for (int i = 0; i < 100; ++i) {
    const auto p = random.next();
    for (const auto& pattern : TpmsPattern::all()) {
      const auto sample = pattern.sample(p);
      values.insert(values.end(), {sample.value, sample.gradient.x, sample.gradient.z});
    }
  }
  EXPECT_EQ(xxHash64(std::as_bytes(std::span<const T>(values))),
            sizeof(T) == 4 ? 190778822625823516U : 10499260417253856458U);
}

TYPED_TEST(TpmsPatternTest, RepeatFarAway) {
  using T = TypeParam;
  RandomPoints<T> random(T(0.5), 4);
  for (const auto& pattern : TpmsPattern::all()) {
    for (int i = 0; i < 100; ++i) {
      auto p = random.next();
      for (int axis = 0; axis < 3; ++axis) p[axis] = std::round(1024 * p[axis]) / 1024;
      const auto far = p + Vec3<T>{1 << 10, -(1 << 12), 1 << 11};
      ASSERT_EQ(pattern.value(p), pattern.value(far)) << pattern.name();
    }
  }
}

/// With arguments pi x / u, as some libraries have it, the channels would swap from cell to cell.
TEST(TpmsPatternsTest, SchwarzDHasThePeriodOfItsCell) {
  const auto d = TpmsPattern::schwarzD();
  const Vec3<double> p{0.109375, 0.234375, 0.3125};
  EXPECT_EQ(d.value(p), d.value(p + Vec3<double>{1, 0, 0}));
  EXPECT_EQ(d.value(p), d.value(p + Vec3<double>{0, -1, 3}));
  EXPECT_GT(std::abs(d.value(p)), 0.1);
  EXPECT_NEAR(d.value(p), -d.value(p + Vec3<double>{0.5, 0, 0}), 1e-14);
}

TEST(TpmsPatternsTest, ConstantsBoundWhatTheyAreOf) {
  forPatterns([](const TpmsPattern& pattern, const PlainPattern& plain) {
    const auto at = [&](const Vec3<double>& p) { return pattern.sample(p); };
    const double gap = 0.05 * pattern.lipschitz();
    // |grad F| and its components have the Lipschitz constant H.
    const auto slope =
        greatest([&](const auto& p) { return length(at(p).gradient); }, pattern.curvature(), gap);
    EXPECT_NEAR(slope.lower, plain.lipschitz, 0.05 * plain.lipschitz);
    EXPECT_LE(slope.lower, pattern.lipschitz());
    EXPECT_NEAR(pattern.lipschitz(), plain.lipschitz, 2e-4);
    const auto along = greatest([&](const auto& p) { return maxComponent(abs(at(p).gradient)); },
                                pattern.curvature(), gap);
    EXPECT_LE(along.lower, pattern.slopeAlongAxis());
    EXPECT_NEAR(pattern.slopeAlongAxis(), plain.axisSlope, 2e-4);
    EXPECT_GE(along.lower, 0.95 * pattern.slopeAlongAxis());
    const auto most =
        greatest([&](const auto& p) { return at(p).value; }, pattern.lipschitz(), gap);
    const auto least =
        greatest([&](const auto& p) { return -at(p).value; }, pattern.lipschitz(), gap);
    EXPECT_LE(most.lower, pattern.range().upper + 1e-14);
    EXPECT_GE(most.upper, pattern.range().upper);
    EXPECT_LE(least.lower, -pattern.range().lower + 1e-14);
    EXPECT_GE(least.upper, -pattern.range().lower);
  });
}

TEST(TpmsPatternsTest, NoSecondDerivativeExceedsTheCurvature) {
  forPatterns([](const TpmsPattern& pattern, const PlainPattern&) {
    RandomPoints<double> random(0.5, 8);
    double most = 0;
    for (int i = 0; i < scaled(20000); ++i) {
      const auto p = random.next();
      // Symmetric points are where maxima are.
      const auto symmetric =
          Vec3<double>{std::round(8 * p.x), std::round(8 * p.y), std::round(8 * p.z)};
      const auto at = i % 4 == 0 ? 0.125 * symmetric : p;
      auto direction = normalized(random.next());
      for (int turn = 0; turn < 4; ++turn) {  // to the eigenvector of the greatest eigenvalue
        const double step = 1e-5;
        const auto change = (pattern.sample(at + step * direction).gradient -
                             pattern.sample(at - step * direction).gradient) /
                            (2 * step * kTurn);
        most = std::max(most, length(change));
        if (length(change) > 0) direction = normalized(change);
      }
    }
    EXPECT_LE(most, pattern.curvature() / 1.05 * 1.04);
    EXPECT_GE(most, 0.9 * pattern.curvature() / 1.05);
  });
}

/// |c|, and k: F is the sum of c exp(i k x) over whole numbers k, of which none exceeds 2.
using Wave = std::pair<double, Vec3<double>>;

std::vector<Wave> wavesOf(const PlainPattern& plain) {
  constexpr int kSide = 6;
  std::vector<Wave> waves;
  for (int i = 0; i < 5 * 5 * 5; ++i) {
    const Vec3<double> k{i % 5 - 2.0, i / 5 % 5 - 2.0, i / 25 - 2.0};
    std::complex<double> sum;
    for (int j = 0; j < kSide * kSide * kSide; ++j) {
      const Vec3<double> turns{1.0 * (j % kSide) / kSide, 1.0 * (j / kSide % kSide) / kSide,
                               1.0 * (j / kSide / kSide) / kSide};
      sum += plainValue(plain, turns) * std::polar(1.0, -kTurn * dot(k, turns));
    }
    const double size = std::abs(sum) / (kSide * kSide * kSide);
    if (size > 1e-9) waves.emplace_back(size, k);
  }
  return waves;
}

TEST(TpmsPatternsTest, ThirdDerivativesAreWhatTheWavesAdd) {
  forPatterns([](const TpmsPattern& pattern, const PlainPattern& plain) {
    const auto waves = wavesOf(plain);
    double most = 0;
    constexpr int kSide = 60;  // of each face of a cube of directions
    for (int i = 0; i < 3 * kSide * kSide; ++i) {
      const std::array<double, 3> along{1, 2.0 * (i / 3 % kSide) / (kSide - 1) - 1,
                                        2.0 * (i / 3 / kSide) / (kSide - 1) - 1};
      const auto at = [&](int axis) { return along[static_cast<std::size_t>((i + axis) % 3)]; };
      const auto u = normalized(Vec3<double>{at(0), at(1), at(2)});
      double sum = 0;
      for (const auto& [size, k] : waves) {
        const double rate = std::abs(dot(k, u));
        sum += size * rate * rate * rate;
      }
      most = std::max(most, sum);
    }
    EXPECT_LE(most, pattern.thirdDerivative());
    EXPECT_GE(most, 0.98 * pattern.thirdDerivative());
  });
}

/// By lines along the axes: each crossing stands for the area of its cell of the grid of lines over
/// the normal's component; shared among the three directions, for 1 / (|nx| + |ny| + |nz|) of it.
TEST(TpmsPatternsTest, AreaAndSlopesOfTheSurface) {
  forPatterns([](const TpmsPattern& pattern, const PlainPattern& plain) {
    constexpr int kSide = 160;
    double area = 0;
    double sum = 0;
    double least = 1e9;
    double most = 0;
    for (int axis = 0; axis < 3; ++axis) {
      for (int i = 0; i < kSide * kSide; ++i) {
        Vec3<double> start;
        start[(axis + 1) % 3] = (i % kSide + 0.5) / kSide;
        start[(axis + 2) % 3] = (i / kSide + 0.5) / kSide;  // NOLINT(bugprone-integer-division)
        double before = pattern.value(start);
        for (int k = 1; k <= kSide; ++k) {
          auto p = start;
          p[axis] = 1.0 * k / kSide;
          const double value = pattern.value(p);
          if ((value < 0) != (before < 0)) {
            p[axis] -= value / (value - before) / kSide;
            const auto g = pattern.sample(p).gradient;
            const double patch = length(g) / oneNorm(g) / (kSide * kSide);
            area += patch;
            sum += patch * length(g);
            least = std::min(least, length(g));
            most = std::max(most, length(g));
          }
          before = value;
        }
      }
    }
    EXPECT_NEAR(area, plain.area, 0.01 * plain.area);
    EXPECT_NEAR(sum / area, plain.meanSlope, 0.01 * plain.meanSlope);
    EXPECT_NEAR(sum / area, pattern.meanSlope(), 0.01 * plain.meanSlope);
    EXPECT_NEAR(least, plain.leastSlope, 0.02 * plain.leastSlope);
    EXPECT_LE(pattern.leastSlope(), least);
    EXPECT_GE(pattern.leastSlope(), 0.97 * least);
    EXPECT_NEAR(most, plain.mostSlope, 0.01 * plain.mostSlope);
  });
}

double wallFraction(const TpmsPattern& pattern, double level) {
  constexpr int kSide = 100;
  int inside = 0;
  for (int i = 0; i < kSide * kSide * kSide; ++i) {
    const Vec3<double> p{(i % kSide + 0.31) / kSide, (i / kSide % kSide + 0.47) / kSide,
                         (i / kSide / kSide + 0.59) / kSide};
    inside += std::abs(pattern.value(p)) < level ? 1 : 0;
  }
  return 1.0 * inside / (kSide * kSide * kSide);
}

TEST(TpmsPatternsTest, FractionsOfWalls) {
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double level = 0.2 * (i + 1);
    EXPECT_NEAR(wallFraction(TpmsPattern::gyroid(), level), (std::array{0.129, 0.258, 0.389}[at]),
                0.001);
    EXPECT_NEAR(wallFraction(TpmsPattern::schwarzP(), level), (std::array{0.114, 0.228, 0.343}[at]),
                0.001);
    const double ofD = std::array{0.1, 0.2, 0.4}[at];
    EXPECT_NEAR(wallFraction(TpmsPattern::schwarzD(), ofD), (std::array{0.116, 0.232, 0.466}[at]),
                0.001);
  }
}

/// Whether a channel of cells where it holds reaches around the period, in whatever direction.
template <typename Holds>
bool percolates(const Holds& holds, int side) {
  const auto n = static_cast<std::size_t>(side);
  const std::size_t count = n * n * n;
  std::vector<int> seen(count, 0);
  std::vector<std::array<int, 3>> place(count);  // unwrapped
  const auto index = [&](const std::array<int, 3>& p) {
    const auto wrap = [&](int i) { return static_cast<std::size_t>((i % side + side) % side); };
    return (wrap(p[2]) * n + wrap(p[1])) * n + wrap(p[0]);
  };
  for (int start = 0; start < static_cast<int>(count); ++start) {
    std::array<int, 3> p{start % side, start / side % side, start / side / side};
    if (seen[index(p)] != 0 || !holds(p)) continue;
    std::vector<std::array<int, 3>> pending{p};
    seen[index(p)] = 1;
    place[index(p)] = p;
    while (!pending.empty()) {
      p = pending.back();
      pending.pop_back();
      for (int face = 0; face < 6; ++face) {
        auto q = p;
        q[static_cast<std::size_t>(face / 2)] += face % 2 == 0 ? 1 : -1;
        if (!holds(q)) continue;
        if (seen[index(q)] != 0) {
          if (place[index(q)] != q) return true;
          continue;
        }
        seen[index(q)] = 1;
        place[index(q)] = q;
        pending.push_back(q);
      }
    }
  }
  return false;
}

TEST(TpmsPatternsTest, ChannelsBreakUpAtTheirPinch) {
  constexpr int kSide = 64;
  forPatterns([](const TpmsPattern& pattern, const PlainPattern&) {
    for (const auto channel : {TpmsChannel::A, TpmsChannel::B}) {
      const double side = channel == TpmsChannel::A ? 1 : -1;
      const auto reaches = [&](double level) {
        return percolates(
            [&](const std::array<int, 3>& p) {
              return side * pattern.value(Vec3<double>{1.0 * p[0] / kSide, 1.0 * p[1] / kSide,
                                                       1.0 * p[2] / kSide}) >
                     level;
            },
            kSide);
      };
      const double pinch = pattern.pinch(channel);
      EXPECT_TRUE(reaches(0.9 * pinch)) << static_cast<int>(channel);
      EXPECT_FALSE(reaches(pinch + 1e-5)) << static_cast<int>(channel);
    }
  });
}

}  // namespace
}  // namespace cutwater::test
