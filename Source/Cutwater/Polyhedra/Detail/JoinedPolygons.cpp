#include <Cutwater/Polyhedra/Detail/JoinedPolygons.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>

namespace cutwater {

namespace {

/// The path around a face and a polygon beside it; none, unless they share one chain of edges.
std::optional<CornerLoop> pathAround(const CornerLoop& rim, const CornerLoop& polygon) {
  const auto n = polygon.size();
  std::vector<std::size_t> place;  // of each corner in the rim
  for (const auto corner : polygon) {
    place.push_back(static_cast<std::size_t>(std::ranges::find(rim, corner) - rim.begin()));
  }
  const auto chain = onlyStretch(n, [&](std::size_t k) {
    const auto from = place[k % n];
    const auto to = place[(k + 1) % n];
    return from < rim.size() && to < rim.size() && (to + 1) % rim.size() == from;
  });
  if (!chain) return std::nullopt;
  const auto [start, end] = *chain;
  // The rim goes through the chain the other way round: from the end of the chain in the polygon
  // to its start. In its place it takes the rest of the polygon.
  CornerLoop result;
  for (auto k = end; k < start + n; ++k) result.push_back(polygon[k % n]);
  for (auto k = place[start]; k != place[end % n]; k = (k + 1) % rim.size()) {
    result.push_back(rim[k]);
  }
  return result;
}

/// Polygons whose corners are numbered anew, from 0, in the same order.
class NumberedPolygons {
 public:
  explicit NumberedPolygons(const std::vector<CornerLoop>& polygons) {
    for (const auto& loop : polygons) corners_.insert(corners_.end(), loop.begin(), loop.end());
    names_ = corners_;
    std::ranges::sort(names_);
    names_.erase(std::unique(names_.begin(), names_.end()), names_.end());
    for (auto& corner : corners_) {
      const auto found = std::ranges::lower_bound(names_, corner);
      corner = static_cast<std::uint32_t>(found - names_.begin());
    }
    for (const auto& loop : polygons) first_.push_back(first_.back() + loop.size());
  }

  [[nodiscard]] std::size_t count() const { return first_.size() - 1; }
  [[nodiscard]] std::span<const std::uint32_t> of(std::size_t polygon) const {
    return std::span(corners_).subspan(first_[polygon], first_[polygon + 1] - first_[polygon]);
  }
  /// What each corner was, by its new number.
  [[nodiscard]] const std::vector<std::uint32_t>& names() const { return names_; }

 private:
  std::vector<std::uint32_t> corners_;
  std::vector<std::size_t> first_{0};
  std::vector<std::uint32_t> names_;
};

/// Which polygons share an edge, in opposite directions.
class Neighbours {
 public:
  explicit Neighbours(const NumberedPolygons& polygons) {
    for (std::size_t n = 0; n < polygons.count(); ++n) {
      const auto loop = polygons.of(n);
      for (std::size_t k = 0; k < loop.size(); ++k) {
        edges_.push_back({loop[k], loop[k + 1 < loop.size() ? k + 1 : 0], n});
      }
    }
    std::ranges::sort(edges_, {}, keyOf);
  }
  template <typename Visit>
  void forEach(std::span<const std::uint32_t> loop, const Visit& visit) const {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const std::array wanted{loop[k + 1 < loop.size() ? k + 1 : 0], loop[k]};
      const auto found = std::ranges::lower_bound(edges_, wanted, {}, keyOf);
      for (auto edge = found; edge != edges_.end() && keyOf(*edge) == wanted; ++edge) {
        visit(edge->polygon);
      }
    }
  }

 private:
  struct SharedEdge {
    std::uint32_t from;
    std::uint32_t to;
    std::size_t polygon;
  };
  static std::array<std::uint32_t, 2> keyOf(const SharedEdge& edge) { return {edge.from, edge.to}; }

  std::vector<SharedEdge> edges_;
};

/// A loop without a corner twice, to which polygons are joined. Keeps its memory from one to the
/// next.
class GrowingRim {
 public:
  explicit GrowingRim(std::size_t corners) : next_(corners, kNone) {}

  void begin(std::span<const std::uint32_t> loop) {
    for (std::size_t k = 0; k < loop.size(); ++k) next_[loop[k]] = loop[(k + 1) % loop.size()];
    head_ = loop.front();
  }
  /// Whether a polygon shares one chain of edges with the rim, and no other corner: it is joined
  /// then.
  bool join(std::span<const std::uint32_t> polygon) {
    const auto n = polygon.size();
    const auto isShared = [&](std::size_t k) {
      return next_[polygon[(k + 1) % n]] == polygon[k % n];
    };
    const auto chain = onlyStretch(n, isShared);
    if (!chain) return false;
    const auto [start, end] = *chain;
    for (auto k = end + 1; k < start + n; ++k) {
      if (next_[polygon[k % n]] != kNone) return false;
    }
    for (auto k = start + 1; k < end; ++k) next_[polygon[k % n]] = kNone;
    for (auto k = end; k < start + n; ++k) next_[polygon[k % n]] = polygon[(k + 1) % n];
    head_ = polygon[end % n];
    return true;
  }
  /// The rim in the names of its corners. The next one can begin then.
  CornerLoop take(const std::vector<std::uint32_t>& names) {
    CornerLoop rim;
    for (auto corner = head_; next_[corner] != kNone;) {
      rim.push_back(names[corner]);
      corner = std::exchange(next_[corner], kNone);
    }
    return rim;
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffff;

  std::vector<std::uint32_t> next_;  // of each corner; kNone, if it is not in the rim
  std::uint32_t head_ = kNone;
};

}  // namespace

std::vector<CornerLoop> joinedPair(const CornerLoop& polygon, const CornerLoop& other) {
  std::vector<CornerLoop> rims;
  if (const auto path = pathAround(polygon, other)) addSimpleLoops(*path, rims);
  return rims;
}

std::vector<CornerLoop> joinedPolygons(
    const std::vector<CornerLoop>& polygons,
    FunctionRef<bool(std::size_t polygon, std::size_t other)> mayJoin) {
  if (polygons.size() == 1) return polygons;
  const NumberedPolygons numbered(polygons);
  const Neighbours neighbours(numbered);
  GrowingRim rim(numbered.names().size());
  std::vector<char> isTaken(polygons.size(), 0);
  std::vector<CornerLoop> rims;
  for (std::size_t n = 0; n < polygons.size(); ++n) {
    if (!hasRepeatedCorner(polygons[n])) continue;
    rims.push_back(polygons[n]);
    isTaken[n] = 1;
  }
  for (std::size_t first = 0; first < polygons.size(); ++first) {
    if (isTaken[first] != 0) continue;
    isTaken[first] = 1;
    rim.begin(numbered.of(first));
    std::vector<std::size_t> members{first};
    // Those that cannot join yet may once others have.
    for (bool hasGrown = true; hasGrown;) {
      hasGrown = false;
      for (std::size_t m = 0; m < members.size(); ++m) {
        neighbours.forEach(numbered.of(members[m]), [&](std::size_t other) {
          if (isTaken[other] != 0 || !mayJoin(members[m], other)) return;
          if (!rim.join(numbered.of(other))) return;
          isTaken[other] = 1;
          members.push_back(other);
          hasGrown = true;
        });
      }
    }
    rims.push_back(rim.take(numbered.names()));
  }
  return rims;
}

}  // namespace cutwater
