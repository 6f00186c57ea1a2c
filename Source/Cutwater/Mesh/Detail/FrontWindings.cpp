#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/Core/OrientedBox.hpp>
#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Mesh/Detail/FrontWindings.hpp>
#include <Cutwater/Surface/Detail/ContactSearch.hpp>
#include <Cutwater/Triangles/TriangleIntersection.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace cutwater {

namespace {

/// A flat box around a triangle with this unit normal, and what is within `slack` of it.
OrientedBox<double> boxAround(const std::array<Vec3<double>, 3>& corners,
                              const Vec3<double>& normal, double slack) {
  const auto& [a, b, c] = corners;
  const auto along = normalized(b - a);
  const std::array directions{along, cross(normal, along)};
  OrientedBox<double> box{.center = a, .halfAxis = {}, .slack = slack};
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const auto [lower, upper] =
        std::minmax({0.0, dot(directions[i], b - a), dot(directions[i], c - a)});
    box.center += 0.5 * (lower + upper) * directions[i];
    box.halfAxis[i] = 0.5 * (upper - lower) * directions[i];
  }
  return box;
}

/// See findCloseTriangles(); caps count as other triangles.
template <std::floating_point T>
std::vector<std::uint8_t> closeTriangles(const TriangleSurface<T>& surface,
                                         const TriangleTree& tree,
                                         const TriangleSurface<double>& caps) {
  constexpr double kClearance = FrontWindings::kClearance<T>;
  const std::vector<Vec3<double>> positions(surface.positions.begin(), surface.positions.end());
  auto isClose = findCloseTriangles(positions, surface.triangles, tree, kClearance);
  parallelFor(caps.triangles.size(), {.progress = {}}, [&](std::size_t i, std::size_t) {
    const auto cap = caps.corners(static_cast<std::uint32_t>(i));
    const auto normal = normalized(cross(cap[1] - cap[0], cap[2] - cap[0]));
    if (normal == Vec3<double>{}) return;  // it bounds nothing
    tree.overlapping(boxAround(cap, normal, 2 * kClearance),
                     [&](std::span<const std::uint32_t> slots) {
                       for (const auto t : slots) {
                         if (t == kNone) break;
                         // Many caps may lie on many triangles.
                         const std::atomic_ref<std::uint8_t> mark(isClose[t]);
                         if (mark.load(std::memory_order_relaxed) != 0) continue;
                         if (areFartherApart(cap, surface.corners(t), kClearance)) continue;
                         mark.store(1, std::memory_order_relaxed);
                       }
                       return true;
                     });
  });
  return isClose;
}

/// The triangles at each vertex.
template <std::floating_point T>
class Rings {
 public:
  explicit Rings(const TriangleSurface<T>& surface) : surface_(surface) {
    counts_.resize(surface.positions.size());
    anyAt_.assign(surface.positions.size(), kNone);
    for (std::uint32_t t = 0; t < surface.triangles.size(); ++t) {
      for (const auto v : surface.triangles[t]) {
        ++counts_[v];
        anyAt_[v] = t;
      }
    }
  }

  /// Whether the triangles at a vertex are one ring around it, turned alike, and none of them
  /// `isClose`.
  [[nodiscard]] bool isClear(std::uint32_t vertex, std::span<const std::uint8_t> isClose) const {
    auto t = anyAt_[vertex];
    for (std::uint32_t n = 0; t != kNone && isClose[t] == 0; ++n) {
      if (n > 0 && t == anyAt_[vertex]) return n == counts_[vertex];
      if (n == counts_[vertex]) return false;
      t = next(t, vertex);
    }
    return false;
  }

 private:
  /// Across the edge that begins at the vertex; none unless it ends there in the other triangle.
  [[nodiscard]] std::uint32_t next(std::uint32_t t, std::uint32_t vertex) const {
    const auto own = edgeFrom(t, vertex);
    const auto across = surface_.neighbours[t][own];
    if (across == kNone) return kNone;
    const auto end = surface_.triangles[t][(own + 1) % 3];
    const auto& other = surface_.triangles[across];
    const auto back = edgeFrom(across, end);
    return back < 3 && other[(back + 1) % 3] == vertex ? across : kNone;
  }
  /// The edge of a triangle that begins at a vertex; 3 if it has none.
  [[nodiscard]] std::size_t edgeFrom(std::uint32_t t, std::uint32_t vertex) const {
    const auto& corners = surface_.triangles[t];
    return static_cast<std::size_t>(std::ranges::find(corners, vertex) - corners.begin());
  }

  const TriangleSurface<T>& surface_;
  std::vector<std::uint32_t> counts_;
  std::vector<std::uint32_t> anyAt_;
};

/// Per triangle, not 0 if it has nothing but its neighbours around: see FrontWindings.
template <std::floating_point T>
std::vector<std::uint8_t> clearTriangles(const TriangleSurface<T>& surface,
                                         const TriangleTree& tree,
                                         const TriangleSurface<double>& caps) {
  const auto isClose = closeTriangles(surface, tree, caps);
  const Rings<T> rings(surface);
  std::vector<std::uint8_t> isClearVertex(surface.positions.size());
  for (std::uint32_t v = 0; v < isClearVertex.size(); ++v) {
    isClearVertex[v] = rings.isClear(v, isClose) ? 1 : 0;
  }
  std::vector<std::uint8_t> isClear(surface.triangles.size());
  for (std::uint32_t t = 0; t < isClear.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    isClear[t] = isClearVertex[a] & isClearVertex[b] & isClearVertex[c];
  }
  return isClear;
}

/// For each set of clear triangles that neighbours join, the one with the largest inscribed circle.
struct Parts {
  std::vector<std::uint32_t> rootOf;    ///< per triangle that is clear
  std::vector<std::uint32_t> roundest;  ///< per root; kNone for others
};

/// Twice the radius of the inscribed circle of a triangle.
double widthOf(const std::array<Vec3<double>, 3>& corners) {
  const auto& [a, b, c] = corners;
  const double around = length(b - a) + length(c - b) + length(a - c);
  return around > 0 ? 2 * length(cross(b - a, c - a)) / around : 0;
}

template <std::floating_point T>
Parts partsOf(const TriangleSurface<T>& surface, std::span<const std::uint8_t> isClear) {
  const auto count = static_cast<std::uint32_t>(isClear.size());
  detail::DisjointSets sets(count);
  for (std::uint32_t t = 0; t < count; ++t) {
    if (isClear[t] == 0) continue;
    for (const auto across : surface.neighbours[t]) {
      if (across != kNone && isClear[across] != 0) sets.unite(t, across);
    }
  }
  Parts parts{std::vector<std::uint32_t>(count), std::vector<std::uint32_t>(count, kNone)};
  std::vector<double> widths(count);
  for (std::uint32_t t = 0; t < count; ++t) {
    if (isClear[t] == 0) continue;
    const auto root = parts.rootOf[t] = sets.find(t);
    const double width = widthOf(surface.corners(t));
    if (width > widths[root]) widths[root] = width, parts.roundest[root] = t;
  }
  return parts;
}

/// The winding number just in front of a clear triangle. Both sides are looked at: at points that
/// have it nearest.
template <std::floating_point T>
std::optional<int> frontWinding(const TriangleSurface<T>& surface, std::uint32_t t,
                                const FrontQueries<T>& queries) {
  const auto corners = surface.corners(t);
  const auto& [a, b, c] = corners;
  const auto normal = normalized(cross(b - a, c - a));
  const auto middle = (1.0 / 3) * (a + b + c);
  const auto windingAt = [&](double height) -> std::optional<int> {
    const Vec3<T> p(middle + height * normal);
    const auto found = queries.nearest(p);
    if (found.triangle != t || found.agreedSide() != (height > 0 ? 1 : -1)) return {};
    return queries.winding(Vec3<double>(p));
  };
  constexpr int kAttempts = 5;
  double height = 0.125 * widthOf(corners);
  for (int i = 0; i < kAttempts; ++i, height *= 0x1p-5) {
    const auto front = windingAt(height);
    const auto behind = windingAt(-height);
    if (front && behind) return *behind == *front + 1 ? front : std::nullopt;
  }
  return {};
}

bool isWithinBytes(int winding) {
  return std::abs(winding) <= FrontWindings::kMost;
}

/// Sets the bytes of clear triangles.
template <std::floating_point T>
void setClear(const TriangleSurface<T>& surface, std::span<const std::uint8_t> isClear,
              const FrontQueries<T>& queries, std::span<std::uint8_t> bytes) {
  const auto parts = partsOf(surface, isClear);
  std::vector<std::uint8_t> byteOf(isClear.size());  // per root
  const ParallelOptions inRanges{.grain = 64, .progress = {}};
  parallelFor(byteOf.size(), inRanges, [&](std::size_t begin, std::size_t end) {
    for (auto root = begin; root < end; ++root) {
      if (parts.roundest[root] == kNone) continue;
      const auto found = frontWinding(surface, parts.roundest[root], queries);
      if (found && isWithinBytes(*found)) byteOf[root] = FrontWindings::byteOf(*found, true);
    }
  });
  for (std::uint32_t t = 0; t < isClear.size(); ++t) {
    if (isClear[t] != 0) bytes[t] = byteOf[parts.rootOf[t]];
  }
}

/// Sets the bytes of others. Those of a run, in the order of the tree, are reached from each other.
template <std::floating_point T>
void setOthers(const TriangleSurface<T>& surface, const TriangleTree& tree,
               std::span<const std::uint8_t> isClear, const FrontQueries<T>& queries,
               std::span<std::uint8_t> bytes) {
  std::vector<std::uint32_t> others;
  for (const auto t : tree.slots()) {
    if (t != kNone && isClear[t] == 0) others.push_back(t);
  }
  const ParallelOptions inRuns{.grain = 1024, .progress = {}};
  parallelFor(others.size(), inRuns, [&](std::size_t begin, std::size_t end) {
    Vec3<double> last;
    int winding = 0;
    for (auto i = begin; i < end; ++i) {
      const auto p = FrontWindings::pointBefore(surface.corners(others[i]));
      winding = i == begin ? queries.winding(p) : winding + queries.windingAlong({p, last});
      last = p;
      if (isWithinBytes(winding)) bytes[others[i]] = FrontWindings::byteOf(winding, false);
    }
  });
}

}  // namespace

Vec3<double> FrontWindings::pointBefore(const std::array<Vec3<double>, 3>& corners) {
  const auto& [a, b, c] = corners;
  const Vec3<double> u = b - a;
  const Vec3<double> v = c - a;
  const double size = std::max(maxComponent(abs(u)), maxComponent(abs(v)));
  const auto middle = a + (1.0 / 3) * (u + v);
  return size > 0 ? middle + (0.125 / size) * cross(u, v) : middle;
}

template <std::floating_point T>
std::vector<std::uint8_t> findFrontWindings(const TriangleSurface<T>& surface,
                                            const TriangleTree& tree,
                                            const TriangleSurface<double>& caps,
                                            const FrontQueries<T>& queries) {
  const auto isClear = clearTriangles(surface, tree, caps);
  std::vector<std::uint8_t> bytes(isClear.size());
  setClear(surface, isClear, queries, std::span(bytes));
  setOthers(surface, tree, isClear, queries, std::span(bytes));
  return bytes;
}

template std::vector<std::uint8_t> findFrontWindings(const TriangleSurface<float>&,
                                                     const TriangleTree&,
                                                     const TriangleSurface<double>&,
                                                     const FrontQueries<float>&);
template std::vector<std::uint8_t> findFrontWindings(const TriangleSurface<double>&,
                                                     const TriangleTree&,
                                                     const TriangleSurface<double>&,
                                                     const FrontQueries<double>&);

}  // namespace cutwater
