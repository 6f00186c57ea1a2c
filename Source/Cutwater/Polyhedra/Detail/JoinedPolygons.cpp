#include <Cutwater/Polyhedra/Detail/JoinedPolygons.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace cutwater {

namespace {

struct SharedEdge {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
  std::size_t polygon = 0;
};

/// Which polygons share an edge, in opposite directions.
class Neighbours {
 public:
  explicit Neighbours(const std::vector<CornerLoop>& polygons) {
    for (std::size_t n = 0; n < polygons.size(); ++n) {
      const auto& loop = polygons[n];
      for (std::size_t k = 0; k < loop.size(); ++k) {
        edges_.push_back({loop[k], loop[(k + 1) % loop.size()], n});
      }
    }
    std::ranges::sort(edges_, {}, keyOf);
  }
  template <typename Visit>
  void forEach(const CornerLoop& loop, const Visit& visit) const {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const std::array wanted{loop[(k + 1) % loop.size()], loop[k]};
      const auto found = std::ranges::lower_bound(edges_, wanted, {}, keyOf);
      for (auto edge = found; edge != edges_.end() && keyOf(*edge) == wanted; ++edge) {
        visit(edge->polygon);
      }
    }
  }

 private:
  static std::array<std::uint32_t, 2> keyOf(const SharedEdge& edge) { return {edge.from, edge.to}; }

  std::vector<SharedEdge> edges_;
};

/// The path around a face and a polygon beside it; none, unless they share one chain of edges.
std::optional<CornerLoop> pathAround(const CornerLoop& rim, const CornerLoop& polygon) {
  const auto n = polygon.size();
  std::vector<std::size_t> place;  // of each corner in the rim
  for (const auto corner : polygon) {
    place.push_back(static_cast<std::size_t>(std::ranges::find(rim, corner) - rim.begin()));
  }
  const auto isShared = [&](std::size_t k) {
    const auto from = place[k % n];
    const auto to = place[(k + 1) % n];
    return from < rim.size() && to < rim.size() && (to + 1) % rim.size() == from;
  };
  std::optional<std::size_t> start;
  for (std::size_t k = 0; k < n; ++k) {
    if (!isShared(k) || isShared(k + n - 1)) continue;
    if (start) return std::nullopt;
    start = k;
  }
  if (!start) return std::nullopt;
  std::size_t shared = 1;
  while (isShared(*start + shared)) ++shared;
  // The rim goes through the chain the other way round: from the end of the chain in the polygon
  // to its start. In its place it takes the rest of the polygon.
  CornerLoop result;
  for (auto k = *start + shared; k < *start + n; ++k) result.push_back(polygon[k % n]);
  for (auto k = place[*start]; k != place[(*start + shared) % n]; k = (k + 1) % rim.size()) {
    result.push_back(rim[k]);
  }
  return result;
}

/// The rim of both; none, if it were not one loop without a corner twice.
std::optional<CornerLoop> rimOfBoth(const CornerLoop& rim, const CornerLoop& polygon) {
  auto path = pathAround(rim, polygon);
  return path && !hasRepeatedCorner(*path) ? std::move(path) : std::nullopt;
}

}  // namespace

std::vector<CornerLoop> joinedPair(const CornerLoop& polygon, const CornerLoop& other) {
  std::vector<CornerLoop> rims;
  if (const auto path = pathAround(polygon, other)) addSimpleLoops(*path, rims);
  return rims;
}

std::vector<CornerLoop> joinedPolygons(
    const std::vector<CornerLoop>& polygons,
    FunctionRef<bool(std::size_t polygon, std::size_t other)> mayJoin) {
  const Neighbours neighbours(polygons);
  std::vector<char> isTaken(polygons.size(), 0);
  std::vector<CornerLoop> rims;
  for (std::size_t first = 0; first < polygons.size(); ++first) {
    if (isTaken[first] != 0) continue;
    isTaken[first] = 1;
    auto rim = polygons[first];
    std::vector<std::size_t> members{first};
    // Those that cannot join yet may once others have.
    for (bool hasGrown = true; hasGrown;) {
      hasGrown = false;
      for (std::size_t m = 0; m < members.size(); ++m) {
        neighbours.forEach(polygons[members[m]], [&](std::size_t other) {
          if (isTaken[other] != 0 || !mayJoin(members[m], other)) return;
          auto both = rimOfBoth(rim, polygons[other]);
          if (!both) return;
          rim = std::move(*both);
          isTaken[other] = 1;
          members.push_back(other);
          hasGrown = true;
        });
      }
    }
    rims.push_back(std::move(rim));
  }
  return rims;
}

}  // namespace cutwater
