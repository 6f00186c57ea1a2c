#include <Cutwater/Grid/Detail/OctreeBalance.hpp>

#include <algorithm>
#include <random>
#include <set>

#include <gtest/gtest.h>

namespace cutwater::detail::test {
namespace {

using detail::OctreeCodes;

/// Octrees by their divided cells, balanced by adding one cell after the other.
class PlainOctree {
 public:
  PlainOctree(const OctreeDomain<double>& domain, const std::vector<OctreeCodes>& divided)
      : domain_(domain), divided_(divided.size()) {
    for (std::size_t level = 0; level < divided.size(); ++level) {
      divided_[level].insert(divided[level].begin(), divided[level].end());
    }
  }
  void balance(int sharedAxes) {
    for (bool changed = true; changed;) changed = addOne(sharedAxes);
  }
  [[nodiscard]] OctreeCodes codes(std::size_t level) const {
    return {divided_[level].begin(), divided_[level].end()};
  }

 private:
  /// A cell that is divided makes its neighbours exist: their parents are divided.
  bool addOne(int sharedAxes) {
    for (std::size_t level = 1; level < divided_.size(); ++level) {
      const auto all = domain_.indices(static_cast<int>(level));
      for (const auto code : divided_[level]) {
        const auto c = indexOf(code);
        for (int n = 0; n < 27; ++n) {
          const Index3 d{n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
          if (std::abs(d.i) + std::abs(d.j) + std::abs(d.k) > sharedAxes) continue;
          const Index3 at{c.i + d.i, c.j + d.j, c.k + d.k};
          if (at.i < 0 || at.j < 0 || at.k < 0 || at.i > all.hi.i || at.j > all.hi.j ||
              at.k > all.hi.k) {
            continue;
          }
          if (divided_[level - 1].insert(mortonCode({at.i / 2, at.j / 2, at.k / 2})).second) {
            return true;
          }
        }
      }
    }
    return false;
  }

  const OctreeDomain<double>& domain_;
  std::vector<std::set<MortonCode>> divided_;
};

/// Cells on paths from the roots to some random places.
std::vector<OctreeCodes> randomPaths(const OctreeDomain<double>& domain, int levels, int count,
                                     unsigned seed) {
  std::mt19937 engine(seed);
  std::vector<std::set<MortonCode>> divided(static_cast<std::size_t>(levels));
  for (int n = 0; n < count; ++n) {
    const auto all = domain.indices(levels - 1).hi;
    const auto below = [&](std::int32_t last) {
      return std::uniform_int_distribution<std::int32_t>(0, last)(engine);
    };
    auto code = mortonCode({below(all.i), below(all.j), below(all.k)});
    for (int level = levels; level-- > 0; code /= 8) {
      divided[static_cast<std::size_t>(level)].insert(code);
    }
  }
  std::vector<OctreeCodes> result;
  for (const auto& codes : divided) result.emplace_back(codes.begin(), codes.end());
  return result;
}

TEST(OctreeBalanceTest, AddsTheLeastThatBalances) {
  const OctreeDomain<double> domain({}, 1, {3, 1, 2});
  const std::pair<Balance, int> kinds[] = {
      {Balance::Face, 1}, {Balance::Edge, 2}, {Balance::Corner, 3}};
  for (unsigned seed = 1; seed <= 8; ++seed) {
    const auto divided = randomPaths(domain, 5, 3, seed);
    for (const auto& [balance, sharedAxes] : kinds) {
      auto balanced = divided;
      detail::balanceOctree(domain, balance, balanced);
      PlainOctree plain(domain, divided);
      plain.balance(sharedAxes);
      for (std::size_t level = 0; level < divided.size(); ++level) {
        EXPECT_EQ(balanced[level], plain.codes(level)) << seed << ' ' << sharedAxes << ' ' << level;
      }
    }
  }
}

TEST(OctreeBalanceTest, LeavesAMeshAsItIsWhereNoneIsWanted) {
  const OctreeDomain<double> domain({}, 1, {2, 2, 2});
  const auto divided = randomPaths(domain, 6, 1, 3);
  auto same = divided;
  detail::balanceOctree(domain, Balance::None, same);
  EXPECT_EQ(same, divided);
}

}  // namespace
}  // namespace cutwater::detail::test
