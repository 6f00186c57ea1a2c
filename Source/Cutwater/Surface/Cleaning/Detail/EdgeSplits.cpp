#include <Cutwater/Surface/Cleaning/Detail/EdgeSplits.hpp>
#include <Cutwater/Surface/Cleaning/Detail/SoupEdits.hpp>

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace cutwater::detail {
namespace {

/// One side of a triangle, from its first corner to its last, with the points in between.
using Side = std::span<const std::uint32_t>;

/// Cuts the triangle from the middle point on its fullest side to the opposite corner, and then
/// cuts the halves likewise: the corner of each part is off the side, so the part has area.
void cut(const std::array<Side, 3>& sides, std::uint32_t patch, PolygonSoup& result) {
  const auto fullest = std::ranges::max_element(sides, {}, &Side::size) - sides.begin();
  const auto i = static_cast<std::size_t>(fullest);
  const Side side = sides[i];
  const Side next = sides[(i + 1) % 3];
  const Side last = sides[(i + 2) % 3];
  if (side.size() == 2) {
    result.addPolygon(std::array{sides[0].front(), sides[1].front(), sides[2].front()}, patch);
    return;
  }
  const std::size_t middle = side.size() / 2;
  const std::array outward{side[middle], last.front()};
  const std::array back{last.front(), side[middle]};
  cut({side.first(middle + 1), outward, last}, patch, result);
  cut({side.subspan(middle), next, back}, patch, result);
}

}  // namespace

void EdgeSplits::add(std::uint32_t from, std::uint32_t to, std::uint32_t point, double along) {
  const bool upward = from < to;
  splits_.push_back({std::min(from, to), std::max(from, to), upward ? along : -along, point});
}

void EdgeSplits::prepare(std::size_t points) {
  // Both faces of an edge may have added the same point, at places that differ by rounding.
  const auto withPoint = [](const Split& s) { return std::tuple(s.lower, s.upper, s.point); };
  std::ranges::sort(splits_, {}, [&](const Split& s) {
    return std::tuple_cat(withPoint(s), std::tuple(s.along));
  });
  const auto same = [&](const Split& a, const Split& b) { return withPoint(a) == withPoint(b); };
  splits_.erase(std::unique(splits_.begin(), splits_.end(), same), splits_.end());
  std::ranges::sort(splits_, {},
                    [](const Split& s) { return std::tuple(s.lower, s.upper, s.along, s.point); });
  isLower_.assign(points, false);
  for (const auto& split : splits_) isLower_[split.lower] = true;
}

std::span<const EdgeSplits::Split> EdgeSplits::of(std::uint32_t lower, std::uint32_t upper) const {
  const auto ends = [](const Split& s) { return std::pair(s.lower, s.upper); };
  const std::pair edge(lower, upper);
  const auto first = std::ranges::lower_bound(splits_, edge, {}, ends);
  const auto last = std::ranges::upper_bound(splits_, edge, {}, ends);
  return {first, last};
}

void EdgeSplits::appendInner(std::uint32_t from, std::uint32_t to,
                             std::vector<std::uint32_t>& chain) const {
  if (!isLower_[std::min(from, to)]) return;
  const auto first = static_cast<std::ptrdiff_t>(chain.size());
  for (const auto& split : of(std::min(from, to), std::max(from, to))) chain.push_back(split.point);
  if (from > to) std::reverse(chain.begin() + first, chain.end());
}

PolygonSoup EdgeSplits::appliedTo(const PolygonSoup& soup, const std::vector<bool>& whole) {
  prepare(soup.points.size());
  std::vector<std::uint32_t> chain;
  std::array<std::size_t, 4> starts{};
  return rebuilt(soup, [&](std::size_t i, Side corners, PolygonSoup& result) {
    chain.clear();
    for (std::size_t k = 0; k < corners.size(); ++k) {
      starts[std::min<std::size_t>(k, 3)] = chain.size();
      chain.push_back(corners[k]);
      appendInner(corners[k], corners[(k + 1) % corners.size()], chain);
    }
    const auto patch = soup.patches[i];
    if (chain.size() == corners.size() || corners.size() > 3 || whole[i]) {
      result.addPolygon(chain, patch);
      return;
    }
    chain.push_back(corners[0]);
    const Side all(chain);
    starts[3] = chain.size() - 1;
    const auto side = [&](std::size_t k) {
      return all.subspan(starts[k], starts[k + 1] - starts[k] + 1);
    };
    cut({side(0), side(1), side(2)}, patch, result);
  });
}

}  // namespace cutwater::detail
