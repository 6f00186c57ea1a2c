#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/CellMappings.hpp>
#include <Cutwater/Lattice/HexahedralCells.hpp>

#include <algorithm>

#include <gtest/gtest.h>

#include "Support/Random.hpp"
#include "Support/Refusal.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

using Corners = std::array<Vec3<double>, 8>;

HexahedralCells unitCells(const HexahedralCells::Counts& count) {
  return {count, BoxMapping({{0, 0, 0}, {1.0 * count[0], 1.0 * count[1], 1.0 * count[2]}})};
}

/// Bent, sheared and of uneven cells, but nowhere flat.
Vec3<double> bent(const Vec3<double>& u) {
  return {4 * u.x + u.y * u.y, 3 * u.y + 0.5 * std::sin(3 * u.x), 2 * u.z + u.x * u.y};
}

TEST(HexahedralCellsTest, HasTheImagesOfItsCornersAndIsTrilinearBetween) {
  const HexahedralCells cells({4, 3, 2}, bent);
  for (int i = 0; i <= 4; ++i) {
    for (int j = 0; j <= 3; ++j) {
      for (int k = 0; k <= 2; ++k) {
        const auto wanted = bent({i / 4.0, j / 3.0, k / 2.0});
        EXPECT_EQ(cells.corner(i, j, k), wanted);
        EXPECT_EQ(cells.at({1.0 * i, 1.0 * j, 1.0 * k}), wanted);
      }
    }
  }
  // The textbook's sum over corners.
  RandomPoints<double> random(0.5);
  for (int n = 0; n < 200; ++n) {
    const auto u = random.next() + Vec3<double>{0.5, 0.5, 0.5};
    Vec3<double> wanted;
    for (int i = 0; i < 8; ++i) {
      const auto share = [&](int bit, double x) { return (i >> bit & 1) != 0 ? x : 1 - x; };
      wanted += share(0, u.x) * share(1, u.y) * share(2, u.z) *
                cells.corner(2 + (i & 1), 1 + (i >> 1 & 1), i >> 2 & 1);
    }
    EXPECT_LT(length(cells.at(u + Vec3<double>{2, 1, 0}) - wanted), 1e-14);
  }
}

TEST(HexahedralCellsTest, BeyondTheEndsTheLastCellGoesOn) {
  const auto cells = unitCells({2, 2, 2});
  EXPECT_LT(length(cells.at({-0.25, 2.5, 1.125}) - Vec3<double>{-0.25, 2.5, 1.125}), 1e-15);
  const HexahedralCells ring({1, 6, 1},
                             PipeMapping({.innerRadius = 1, .outerRadius = 2, .length = 1}));
  EXPECT_LT(length(ring.at({0.5, 6.25, 0.5}) - ring.at({0.5, 0.25, 0.5})), 1e-15);
  EXPECT_LT(length(ring.at({0.5, -0.25, 0.5}) - ring.at({0.5, 5.75, 0.5})), 1e-15);
  EXPECT_EQ(&ring.corner(0, 6, 0), &ring.corner(0, 0, 0));  // the seam has its corners once
}

TEST(HexahedralCellsTest, NoiseIsAHashOfIndicesAndSeed) {
  // Computed by a program of its own, from the definition.
  const auto noisy = unitCells({3, 3, 3}).withNoise({.amplitude = 0.125, .seed = 42});
  const Vec3<double> moved = noisy.corner(1, 2, 3) - Vec3<double>{1, 2, 3};
  EXPECT_LT(length(moved - 0.125 * Vec3<double>{-0.7066255080410322, 0.20364938042590341,
                                                -0.21659181410073947}),
            1e-15);
  // Whatever other corners there are.
  const auto larger = unitCells({5, 4, 3}).withNoise({.amplitude = 0.125, .seed = 42});
  const auto other = unitCells({3, 3, 3}).withNoise({.amplitude = 0.125, .seed = 43});
  Vec3<double> sum;
  double farthest = 0;
  for (int i = 0; i <= 3; ++i) {
    for (int j = 0; j <= 3; ++j) {
      for (int k = 0; k <= 3; ++k) {
        EXPECT_EQ(noisy.corner(i, j, k), larger.corner(i, j, k));
        EXPECT_NE(noisy.corner(i, j, k), other.corner(i, j, k));
        const auto way = noisy.corner(i, j, k) - Vec3<double>{1.0 * i, 1.0 * j, 1.0 * k};
        EXPECT_LE(length(way), 0.125 + 1e-15);
        farthest = std::max(farthest, length(way));
        sum += way;
      }
    }
  }
  EXPECT_GT(farthest, 0.115);
  EXPECT_LT(length(sum / 64), 0.03);
}

TEST(HexahedralCellsTest, NoiseLeavesSeamsClosedAndBoundariesIfAsked) {
  const HexahedralCells ring({2, 12, 3},
                             PipeMapping({.innerRadius = 1, .outerRadius = 2, .length = 1}));
  const auto noisy = ring.withNoise({.amplitude = 0.1, .seed = 7, .keepsBoundary = true});
  for (int j = 0; j <= 12; ++j) {
    for (int k = 0; k <= 3; ++k) {
      EXPECT_EQ(noisy.corner(0, j, k), ring.corner(0, j, k));
      EXPECT_EQ(noisy.corner(2, j, k), ring.corner(2, j, k));
      const bool isInside = k == 1 || k == 2;
      EXPECT_EQ(noisy.corner(1, j, k) != ring.corner(1, j, k), isInside);
    }
  }
  EXPECT_EQ(noisy.at({1, 12, 1}), noisy.at({1, 0, 1}));
}

TEST(HexahedralCellsTest, NoiseMayBeRelativeToTheShortestEdge) {
  // Cells grow along x: edges of 1/16, 3/16, 5/16, 7/16.
  const HexahedralCells cells({4, 1, 1}, [](const Vec3<double>& u) {
    return Vec3<double>{u.x * u.x, u.y, u.z};
  });
  const auto noisy =
      cells.withNoise({.amplitude = 0.25, .seed = 1, .unit = NoiseUnit::ShortestEdge});
  const auto byLength = cells.withNoise({.amplitude = 0.25 / 16, .seed = 1});
  for (int i = 0; i <= 4; ++i) {
    const double shortest = std::max(1, 2 * i - 1);
    const auto way = noisy.corner(i, 0, 0) - cells.corner(i, 0, 0);
    const auto unit = byLength.corner(i, 0, 0) - cells.corner(i, 0, 0);
    EXPECT_LT(length(way - shortest * unit), 1e-15) << i;
  }
}

TEST(HexahedralCellsTest, CubesBearTheAmplitudeThatTheoryTells) {
  const auto cells = unitCells({3, 3, 3});
  int refused = 0;
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    EXPECT_NO_THROW((void)cells.withNoise({.amplitude = 0.288, .seed = seed}));
    try {
      (void)cells.withNoise({.amplitude = 0.75, .seed = seed});
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 190);
}

/// The least determinant of the Jacobian on a grid of n^3 points, by differences of the corners.
double leastDeterminant(const Corners& c, int n) {
  double least = 1e300;
  for (int i = 0; i < n * n * n; ++i) {
    const Vec3<double> u =
        Vec3<double>{1.0 * (i % n), 1.0 * (i / n % n), 1.0 * (i / n / n)} / (n - 1.0);
    std::array<Vec3<double>, 3> columns;
    for (std::size_t corner = 0; corner < 8; ++corner) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double weight = 1;
        for (std::size_t other = 0; other < 3; ++other) {
          const bool isUpper = (corner >> other & 1U) != 0;
          const double x = u[static_cast<int>(other)];
          weight *= other == axis ? (isUpper ? 1.0 : -1.0) : isUpper ? x : 1 - x;
        }
        columns[axis] += weight * c[corner];
      }
    }
    least = std::min(least, dot(columns[0], cross(columns[1], columns[2])));
  }
  return least;
}

TEST(HexahedralCellsTest, TurnedCellsAreFoundWhereverTheyTurn) {
  RandomPoints<double> random(1, 3);
  int turnedInside = 0;
  int accepted = 0;
  int undecided = 0;
  for (int n = 0; n < scaled(4000); ++n) {
    Corners corners;
    for (int i = 0; i < 8; ++i) {
      corners[static_cast<std::size_t>(i)] =
          Box<double>{{0, 0, 0}, {1, 1, 1}}.corner(i) + (0.3 + 0.2 * (n % 3)) * random.next();
    }
    const bool isPositive = detail::hasPositiveJacobian(corners, 1);
    const double least = leastDeterminant(corners, 9);
    const bool isPositiveAtCorners = leastDeterminant(corners, 2) > 0;
    EXPECT_TRUE(!isPositive || least > 0);
    // (Between points of a coarse grid it may still turn.)
    if (!isPositive && least > 0.01 && leastDeterminant(corners, 65) > 0.01) ++undecided;
    accepted += isPositive ? 1 : 0;
    turnedInside += isPositiveAtCorners && least <= 0 ? 1 : 0;
    auto mirrored = corners;
    for (auto& corner : mirrored) corner.z = -corner.z;
    EXPECT_EQ(detail::hasPositiveJacobian(mirrored, -1), isPositive);
  }
  EXPECT_GT(turnedInside, 5);  // what signs at corners do not see
  EXPECT_GT(accepted, 500);
  EXPECT_EQ(undecided, 0);
}

TEST(HexahedralCellsTest, LeftHandedMappingsWillDo) {
  const HexahedralCells cells({2, 2, 2}, [](const Vec3<double>& u) {
    return Vec3<double>{u.y, u.x, u.z};
  });
  EXPECT_EQ(cells.at({1, 2, 0}), (Vec3<double>{1, 0.5, 0}));
}

TEST(HexahedralCellsTest, RefusesWhatAreNoCells) {
  const BoxMapping box({{0, 0, 0}, {1, 1, 1}});
  EXPECT_EQ(refusal([&] {
              return HexahedralCells({2, 0, 2}, box);
            }),
            "HexahedralCells: need a cell along each axis, and 3 along a closed one (axis = 1, "
            "count = 0)");
  EXPECT_EQ(refusal([] {
              return HexahedralCells({2, 2, 2}, PipeMapping({1, 2, 1}));
            }).substr(0, 43),
            "HexahedralCells: need a cell along each axi");
  EXPECT_EQ(
      refusal([&] {
        return HexahedralCells({2, 2, 4}, box, {false, false, true});
      }),
      "HexahedralCells: need a mapping that is the same at 0 and 1 of a closed axis (axis = 2)");
  EXPECT_EQ(refusal([] {
              return HexahedralCells({2, 1, 1}, [](const Vec3<double>& u) {
                return Vec3<double>{1 / (u.x - 0.5), u.y, u.z};
              });
            }),
            "HexahedralCells: need a mapping to finite points (u = (0.5, 0, 0))");
  EXPECT_EQ(
      refusal([] {
        return HexahedralCells({4, 1, 1}, [](const Vec3<double>& u) {
          return Vec3<double>{std::abs(u.x - 0.5), u.y, u.z};
        });
      }),
      "HexahedralCells: need cells that are neither flat nor turned inside out (cell = (2, 0, "
      "0))");
  EXPECT_NE(refusal([] {
              return HexahedralCells({1, 1, 1}, [](const Vec3<double>& u) {
                return Vec3<double>{u.x, u.y, 0};
              });
            }),
            "");
  const auto cells = unitCells({2, 2, 2});
  for (const double bad :
       {-0.1, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(refusal([&] {
                  return cells.withNoise({.amplitude = bad});
                }).starts_with("HexahedralCells: need an amplitude of noise"));
  }
  try {
    const HexahedralCells tooMany({4096, 4096, 4096}, box);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::Limit);
  }
}

}  // namespace
}  // namespace cutwater::test
