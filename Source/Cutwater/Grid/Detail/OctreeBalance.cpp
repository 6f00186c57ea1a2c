#include <Cutwater/Grid/Detail/OctreeBalance.hpp>

#include <algorithm>
#include <array>
#include <bit>

namespace cutwater::detail {

namespace {

/// A set of neighbours of a cell and the cell itself: 27 offsets in {-1, 0, 1}^3, as bits.
using Neighbours = std::uint32_t;

constexpr Index3 offsetOf(int neighbour) {
  return {neighbour % 3 - 1, neighbour / 3 % 3 - 1, neighbour / 9 - 1};
}
constexpr int neighbourAt(const Index3& offset) {
  return offset.i + 1 + 3 * (offset.j + 1) + 9 * (offset.k + 1);
}

/// The parent itself and those of its neighbours that hold a neighbour of the given child.
constexpr Neighbours aroundChild(int child, Balance balance) {
  const int most = balance == Balance::Face ? 1 : balance == Balance::Edge ? 2 : 3;
  Neighbours result = 1U << neighbourAt({0, 0, 0});
  for (unsigned axes = 1; axes < 8; ++axes) {
    if (std::popcount(axes) > most) continue;
    const auto towards = [&](unsigned axis) {
      if ((axes >> axis & 1U) == 0) return 0;
      return (static_cast<unsigned>(child) >> axis & 1U) != 0 ? 1 : -1;
    };
    result |= 1U << neighbourAt({towards(0), towards(1), towards(2)});
  }
  return result;
}

/// Cells one level above that must be divided because these are.
OctreeCodes wantedAbove(const OctreeCodes& divided, Balance balance, const IndexBox& above) {
  std::array<Neighbours, 8> around{};
  for (int child = 0; child < 8; ++child) {
    around[static_cast<std::size_t>(child)] = aroundChild(child, balance);
  }
  OctreeCodes wanted;
  for (auto first = divided.begin(); first != divided.end();) {
    const MortonCode parent = *first / 8;
    Neighbours neighbours = 0;
    for (; first != divided.end() && *first / 8 == parent; ++first)
      neighbours |= around[*first % 8];
    const auto center = indexOf(parent);
    for (; neighbours != 0; neighbours &= neighbours - 1) {
      const auto offset = offsetOf(std::countr_zero(neighbours));
      const Index3 index{center.i + offset.i, center.j + offset.j, center.k + offset.k};
      if (above.contains(index)) wanted.push_back(mortonCode(index));
    }
  }
  sortUnique(wanted);
  return wanted;
}

}  // namespace

template <std::floating_point T>
void balanceOctree(const OctreeDomain<T>& domain, Balance balance,
                   std::vector<OctreeCodes>& divided) {
  if (balance == Balance::None) return;
  for (auto level = divided.size(); level-- > 1;) {
    const auto wanted =
        wantedAbove(divided[level], balance, domain.indices(static_cast<int>(level) - 1));
    OctreeCodes all;
    all.reserve(wanted.size() + divided[level - 1].size());
    std::ranges::set_union(divided[level - 1], wanted, std::back_inserter(all));
    divided[level - 1] = std::move(all);
  }
}

template void balanceOctree(const OctreeDomain<float>&, Balance, std::vector<OctreeCodes>&);
template void balanceOctree(const OctreeDomain<double>&, Balance, std::vector<OctreeCodes>&);

}  // namespace cutwater::detail
