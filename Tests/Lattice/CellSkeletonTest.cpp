#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/Detail/CellSkeleton.hpp>

#include "ExplicitLattice.hpp"
#include "Support/Precisions.hpp"
#include "Support/Random.hpp"
#include "Support/Scale.hpp"

namespace cutwater::test {
namespace {

using detail::CellSkeleton;
using detail::FoldedCells;
using detail::SearchedCells;

/// Of numbers of about 1.
template <typename T>
constexpr T kUlp = std::numeric_limits<T>::epsilon();

template <typename T>
class CellSkeletonTest : public ::testing::Test {
 protected:
  /// Calls check(cell, struts of 5^3 explicit cells around [0, 1]^3) for every cell.
  template <typename Check>
  static void forCells(Check check) {
    for (const auto& cell : UnitCell::all()) {
      SCOPED_TRACE(cell.name());
      const auto around = explicitStruts(cell.struts(), -2, 2);
      check(cell, std::span<const CellStrut>(around));
    }
  }
  /// Points of the cell [0, 1]^3, every fourth one of symmetry.
  template <typename Check>
  static void forPoints(int count, Check check) {
    RandomPoints<T> random(T(0.5), /*seed=*/5);
    for (int i = 0; i < scaled(count); ++i) {
      auto p = random.next() + Vec3<T>{T(0.5), T(0.5), T(0.5)};
      for (int axis = 0; axis < 3 && i % 4 == 0; ++axis) p[axis] = std::round(8 * p[axis]) / 8;
      check(p);
    }
  }
};
TYPED_TEST_SUITE(CellSkeletonTest, Precisions);

TYPED_TEST(CellSkeletonTest, BothEvaluatorsAreTheExplicitStruts) {
  using T = TypeParam;
  const Vec3<T> size{1, 1, 1};
  T worstFolded = 0;
  T worstSearched = 0;
  this->forCells([&](const UnitCell& cell, std::span<const CellStrut> around) {
    const SearchedCells<T> searched(cell, {.period = size});
    std::optional<FoldedCells<T>> folded;
    const auto fold = cell.foldAt(Vec3<double>(size));
    if (fold != CellFold::None) folded.emplace(cell, fold, size);
    this->forPoints(400, [&](const Vec3<T>& p) {
      const T wanted = distanceTo(around, Vec3<double>{1, 1, 1}, p);
      worstSearched = std::max(worstSearched, std::abs(searched.nearest(p).distance - wanted));
      if (!folded) return;
      worstFolded = std::max(worstFolded, std::abs(folded->distance(p) - wanted));
      EXPECT_EQ(folded->nearest(p).distance, folded->distance(p));
    });
  });
  EXPECT_LE(worstFolded, 2 * kUlp<T>);
  EXPECT_LE(worstSearched, 2 * kUlp<T>);
}

TYPED_TEST(CellSkeletonTest, EveryFoldThatACellHasIsRight) {
  using T = TypeParam;
  using enum CellFold;
  this->forCells([&](const UnitCell& cell, std::span<const CellStrut> around) {
    for (const auto& choice :
         {std::pair{Octant, Vec3<T>{1, T(1.5), 2}}, std::pair{SortXY, Vec3<T>{1, 1, T(0.5)}},
          std::pair{Sort, Vec3<T>{1, 1, 1}}, std::pair{Fcc, Vec3<T>{1, 1, 1}}}) {
      const auto fold = choice.first;
      const auto size = choice.second;
      if (!cell.has(fold)) continue;
      const FoldedCells<T> folded(cell, fold, size);
      this->forPoints(100, [&](const Vec3<T>& u) {
        const Vec3<T> p = detail::times(u, size);
        EXPECT_NEAR(folded.distance(p), distanceTo(around, Vec3<double>(size), p), 8 * kUlp<T>);
      });
    }
  });
}

TYPED_TEST(CellSkeletonTest, NothingIsFoldedAwayThatIsNotThere) {
  using T = TypeParam;
  // A strut that is almost its own mirror image, and struts that end a little beyond a mirror.
  std::vector<CellStrut> crossing;
  for (int i = 0; i < 8; ++i) {
    const auto image = [&](Vec3<double> p) {
      for (int axis = 0; axis < 3; ++axis) p[axis] = (i >> axis & 1) != 0 ? 1 - p[axis] : p[axis];
      return p;
    };
    crossing.push_back({image({0.125, 0.25, 0.25}), image({0.5 + 8e-10, 0.375, 0.25})});
  }
  const std::vector<CellStrut> nearly{{{0.3, 0.5, 0.5}, {0.7 - 8e-10, 0.5, 0.5}}};
  EXPECT_TRUE(UnitCell("crossing", crossing).has(CellFold::Octant));
  for (const auto& struts : {crossing, nearly}) {
    const UnitCell cell("mine", struts);
    const CellSkeleton<T> skeleton(cell, {.period = {1, 1, 1}});
    const auto around = explicitStruts(cell.struts(), -2, 2);
    for (const Vec3<double> at : {Vec3<double>{0.8, 0.5, 0.5},
                                  {0.5 - 2e-9, 0.375 + 2e-9, 0.25},
                                  {0.5, 0.375 + 2e-9, 0.25}}) {
      const Vec3<T> p(at);
      EXPECT_NEAR(skeleton.distance(p), distanceTo(around, Vec3<double>{1, 1, 1}, p), 2 * kUlp<T>);
    }
  }
}

TYPED_TEST(CellSkeletonTest, AnyPeriodWillDo) {
  using T = TypeParam;
  const Vec3<T> size{T(0.3), T(0.7), T(1.1)};
  this->forCells([&](const UnitCell& cell, std::span<const CellStrut> around) {
    const CellSkeleton<T> skeleton(cell, {.period = size});
    this->forPoints(100, [&](const Vec3<T>& u) {
      const Vec3<T> p = detail::times(u, size);
      const T wanted = distanceTo(around, Vec3<double>(size), p);
      EXPECT_NEAR(skeleton.distance(p), wanted, 16 * kUlp<T>);
      const Vec3<T> far = detail::times(u + Vec3<T>{-300, 50, 1000}, size);
      EXPECT_NEAR(skeleton.distance(far), wanted, 16 * 1100 * kUlp<T>);
    });
  });
}

TYPED_TEST(CellSkeletonTest, TellsTheNearestPointAndItsStrut) {
  using T = TypeParam;
  this->forCells([&](const UnitCell& cell, std::span<const CellStrut> around) {
    for (const std::uint32_t count : {0U, 2U}) {
      const CellSkeleton<T> skeleton(cell, {{1, 1, 1}, {count, count, count}});
      this->forPoints(100, [&](const Vec3<T>& p) {
        const auto found = skeleton.nearest(p);
        EXPECT_EQ(found.distance, skeleton.distance(p));
        EXPECT_NEAR(length(found.away), found.distance, 4 * kUlp<T>);
        const Vec3<T> foot = p - found.away;
        EXPECT_NEAR(skeleton.distance(foot), 0, 8 * kUlp<T>) << p;
        // The strut with this middle is there, and is the nearest.
        const auto isIt = [&](const CellStrut& s) {
          return length(Vec3<T>(s.middle()) - found.middle) < T(1e-5);
        };
        T least = 1;
        for (const auto& strut : around) {
          if (isIt(strut)) least = std::min(least, distanceTo(strut, {1, 1, 1}, p));
        }
        EXPECT_NEAR(least, found.distance, 4 * kUlp<T>) << p << found.middle;
        ASSERT_LT(found.strut, cell.struts().size());
      });
    }
  });
}

/// The struts of a finite array: those of closed cells.
std::vector<CellStrut> closedCells(const UnitCell& cell, const std::array<int, 3>& count) {
  std::vector<CellStrut> all;
  for (const auto& strut : explicitStruts(cell.closedStruts(), 0, 3)) {
    const auto m = strut.middle();
    if (m.x < count[0] + 1e-6 && m.y < count[1] + 1e-6 && m.z < count[2] + 1e-6) {
      all.push_back(strut);
    }
  }
  return all;
}

TYPED_TEST(CellSkeletonTest, FiniteArraysAreTheClosedCells) {
  using T = TypeParam;
  const Vec3<T> size{1, T(0.75), T(1.25)};
  for (const auto& cell : UnitCell::all()) {
    SCOPED_TRACE(cell.name());
    const auto all = closedCells(cell, {3, 1, 2});
    for (const auto& period : {Vec3<T>{1, 1, 1}, size}) {
      const CellSkeleton<T> skeleton(cell, {period, {3, 1, 2}});
      const SearchedCells<T> searched(cell, {period, {3, 1, 2}});
      const auto expectSame = [&](const Vec3<T>& p) {
        const T wanted = distanceTo(std::span<const CellStrut>(all), Vec3<double>(period), p);
        const T allowed = 4 * kUlp<T> * (3 + length(p));
        EXPECT_NEAR(skeleton.distance(p), wanted, allowed) << p;
        EXPECT_NEAR(searched.nearest(p).distance, wanted, allowed) << p;
        T batch = 0;
        skeleton.distances({&p, 1}, {&batch, 1});
        EXPECT_EQ(batch, skeleton.distance(p));
      };
      this->forPoints(60, [&](const Vec3<T>& u) {
        const Vec3<T> p = detail::times(u, Vec3<T>{3, 1, 2});
        expectSame(p);
        expectSame(T(2) * p - Vec3<T>{1, 1, 1});
        expectSame(T(-50) * p + Vec3<T>{50, 0, 30});
      });
    }
  }
}

TYPED_TEST(CellSkeletonTest, ArraysMayBeEndlessAlongSomeAxes) {
  using T = TypeParam;
  for (const auto& cell : {UnitCell::octet(), UnitCell::srs(), UnitCell::diamond()}) {
    const auto all = explicitStruts(cell.closedStruts(), -4, 4);
    std::vector<CellStrut> sheet;
    for (const auto& s : all) {
      if (const double z = s.middle().z; - 1e-6 < z && z < 2 + 1e-6) sheet.push_back(s);
    }
    const CellSkeleton<T> skeleton(cell, {{1, 1, 1}, {0, 0, 2}});
    EXPECT_EQ(skeleton.box().upper.x, Box<T>::kInf);
    EXPECT_LE(skeleton.box().upper.z, T(2.5));
    this->forPoints(60, [&](const Vec3<T>& u) {
      const Vec3<T> p{u.x, u.y, 4 * u.z - 1};
      EXPECT_NEAR(skeleton.distance(p), distanceTo(std::span<const CellStrut>(sheet), {1, 1, 1}, p),
                  16 * kUlp<T>);
    });
  }
}

// --- What a naive implementation would do
// ---------------------------------------------------------

/// What the closed cube holds of a strut; empty if it only touches.
std::vector<CellStrut> clippedToCube(std::span<const CellStrut> around) {
  std::vector<CellStrut> parts;
  for (const auto& [a, b] : around) {
    double first = 0;
    double last = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const double d = b[axis] - a[axis];
      if (d == 0 && (a[axis] < 0 || a[axis] > 1)) last = -1;
      if (d == 0) continue;
      const double low = (0 - a[axis]) / d;
      const double high = (1 - a[axis]) / d;
      first = std::max(first, std::min(low, high));
      last = std::min(last, std::max(low, high));
    }
    if (last > first) parts.push_back({a + first * (b - a), a + last * (b - a)});
  }
  return parts;
}

TYPED_TEST(CellSkeletonTest, TheCoordinateModuloTheCellAloneIsWrongWithoutMirrors) {
  using T = TypeParam;
  const std::map<std::string, double> known{{"diamond", 0.7071}, {"srs", 0.4330}};
  this->forCells([&](const UnitCell& cell, std::span<const CellStrut> around) {
    const auto closed = clippedToCube(around);
    const CellSkeleton<T> skeleton(cell, {.period = {1, 1, 1}});
    T worst = 0;
    const auto compare = [&](const Vec3<T>& p) {
      const T naive = distanceTo(std::span<const CellStrut>(closed), {1, 1, 1}, p);
      worst = std::max(worst, naive - skeleton.distance(p));
    };
    this->forPoints(2000, compare);
    for (int i = 0; i < 8; ++i) compare(Box<T>{{0, 0, 0}, {1, 1, 1}}.corner(i));
    const auto wrong = known.find(cell.name());
    EXPECT_NEAR(worst, wrong != known.end() ? wrong->second : 0.0, 5e-5) << "too large by";
  });
}

TYPED_TEST(CellSkeletonTest, FarAwayQueriesStayFinite) {
  using T = TypeParam;
  for (const auto& cell : UnitCell::all()) {
    const CellSkeleton<T> endless(cell, {.period = {1, 1, 1}});
    const CellSkeleton<T> block(cell, {{1, 1, 1}, {1000, 1000, 1000}});
    for (const T far : {T(1e4), T(1e7), T(1e12), T(1e16)}) {
      const Vec3<T> p{far, -far, T(0.3) * far};
      EXPECT_LT(endless.distance(p), far) << cell.name() << p;
      EXPECT_NEAR(block.distance(p) / distanceTo(CellStrut{{999, 0, 500}, {1000, 0, 500}},
                                                 {1, 1, 1}, Vec3<double>(p)),
                  1, 2e3 / far + 4 * kUlp<T>);
    }
    constexpr T kMost = std::numeric_limits<T>::max();
    EXPECT_TRUE(std::isfinite(endless.distance({kMost, kMost, -kMost})) ||
                cell.foldAt({1, 1, 1}) == CellFold::None);
    EXPECT_FALSE(std::isnan(block.distance({kMost, kMost, -kMost})));
  }
}

TYPED_TEST(CellSkeletonTest, RefusesImpossibleSizes) {
  using T = TypeParam;
  const auto cell = UnitCell::octet();
  for (const T bad : {T(0), T(-1), std::numeric_limits<T>::infinity(), T(1e-30),
                      std::numeric_limits<T>::quiet_NaN()}) {
    if (bad == T(1e-30) && sizeof(T) == 8) continue;
    EXPECT_THROW(CellSkeleton<T>(cell, {.period = {1, bad, 1}}), Error) << bad;
  }
  EXPECT_THROW(CellSkeleton<T>(cell, {{1, 1, 1}, {1, 1U << 21, 1}}), Error);
}

}  // namespace
}  // namespace cutwater::test
