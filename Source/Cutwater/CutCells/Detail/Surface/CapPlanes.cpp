#include <Cutwater/Core/Box.hpp>
#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/CutCells/Detail/Surface/CapPlanes.hpp>
#include <Cutwater/Triangles/ExactPredicates.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>

namespace cutwater {

namespace {

/// The cap of one rim, or of rims with a vertex in common.
struct Cap {
  std::vector<std::uint32_t> triangles;
  Vec3<double> area;     ///< the sum of the triangles', times their normals
  Vec3<double> center;   ///< a point of its plane, if it has one
  double tolerance = 0;  ///< how far its vertices may be from its plane

  [[nodiscard]] double distanceOf(const Vec3<double>& p) const {
    return std::abs(dot(normalized(area), p - center));
  }
};

std::vector<Cap> eachCap(const HoleCaps& caps) {
  detail::DisjointSets sets(caps.positions.size());
  for (const auto& [a, b, c] : caps.triangles) {
    sets.unite(a, b);
    sets.unite(b, c);
  }
  std::map<std::uint32_t, std::size_t> capOf;  // by the set of its vertices
  std::vector<Cap> result;
  for (std::uint32_t id = 0; id < caps.triangles.size(); ++id) {
    const auto [found, isNew] = capOf.try_emplace(sets.find(caps.triangles[id][0]), result.size());
    if (isNew) result.emplace_back();
    result[found->second].triangles.push_back(id);
  }
  for (auto& cap : result) {
    Box<double> box;
    for (const auto id : cap.triangles) {
      const auto& [a, b, c] = caps.triangles[id];
      const auto& p = caps.positions;
      cap.area += 0.5 * cross(p[b] - p[a], p[c] - p[a]);
      cap.center += p[a] + p[b] + p[c];
      box.extend(p[a]).extend(p[b]).extend(p[c]);
    }
    cap.center = cap.center / (3.0 * static_cast<double>(cap.triangles.size()));
    cap.tolerance = std::min(kFlatness, kFlatnessOfCap * box.diagonal());
  }
  return result;
}

/// Whether all of one cap lies in the plane of another, or in its own.
bool liesIn(const Cap& cap, const Cap& plane, const HoleCaps& caps) {
  return std::ranges::all_of(cap.triangles, [&](std::uint32_t id) {
    return std::ranges::all_of(caps.triangles[id], [&](std::uint32_t vertex) {
      return plane.distanceOf(caps.positions[vertex]) <= plane.tolerance;
    });
  });
}

/// The rims of caps in a plane, projected along an axis.
class PlaneRims {
 public:
  PlaneRims(const HoleCaps& caps, std::span<const std::uint32_t> triangles, int axis)
      : positions_(caps.positions), axis_(axis), u_((axis + 1) % 3), v_((axis + 2) % 3) {
    std::vector<std::array<std::uint32_t, 3>> corners;
    for (const auto id : triangles) corners.push_back(caps.triangles[id]);
    edges_ = findOpenEdges(corners, positions_.size());
    std::ranges::sort(edges_, {}, [&](const OpenEdge& edge) { return least(edge, u_); });
  }

  /// Whether no part of the plane is covered more than once.
  [[nodiscard]] bool windOnce() const { return areLoops() && !meet() && coverOnce(); }

 private:
  [[nodiscard]] double at(std::uint32_t vertex, int axis) const { return positions_[vertex][axis]; }
  [[nodiscard]] double least(const OpenEdge& edge, int axis) const {
    return std::min(at(edge.lower, axis), at(edge.upper, axis));
  }
  [[nodiscard]] double most(const OpenEdge& edge, int axis) const {
    return std::max(at(edge.lower, axis), at(edge.upper, axis));
  }
  /// On which side of an edge a point lies.
  [[nodiscard]] int side(const OpenEdge& edge, const Vec3<double>& p) const {
    const auto& a = positions_[edge.lower];
    return crossSign(a, positions_[edge.upper], a, p, axis_);
  }

  [[nodiscard]] bool areLoops() const;
  [[nodiscard]] bool meet() const;
  [[nodiscard]] bool meet(const OpenEdge& one, const OpenEdge& other) const;
  [[nodiscard]] bool coverOnce() const;
  [[nodiscard]] int coverAbove(const OpenEdge& edge) const;
  [[nodiscard]] int step(const OpenEdge& edge) const {
    return at(edge.lower, u_) < at(edge.upper, u_) ? edge.multiplicity : -edge.multiplicity;
  }

  std::span<const Vec3<double>> positions_;
  int axis_;
  int u_;
  int v_;
  std::vector<OpenEdge> edges_;
};

/// Each edge is run along once, and each vertex has two.
bool PlaneRims::areLoops() const {
  std::map<std::uint32_t, int> edgesAt;
  for (const auto& edge : edges_) {
    if (std::abs(edge.multiplicity) != 1) return false;
    ++edgesAt[edge.lower];
    ++edgesAt[edge.upper];
  }
  return std::ranges::all_of(edgesAt, [](const auto& entry) { return entry.second == 2; });
}

/// Whether edges meet anywhere but in the vertices between one and the next.
bool PlaneRims::meet() const {
  for (auto one = edges_.begin(); one != edges_.end(); ++one) {
    const double end = most(*one, u_);
    for (auto other = one + 1; other != edges_.end() && least(*other, u_) <= end; ++other) {
      if (meet(*one, *other)) return true;
    }
  }
  return false;
}

bool PlaneRims::meet(const OpenEdge& one, const OpenEdge& other) const {
  if (least(one, v_) > most(other, v_) || least(other, v_) > most(one, v_)) return false;
  const auto& a = positions_[one.lower];
  const auto& b = positions_[one.upper];
  const auto& c = positions_[other.lower];
  const auto& d = positions_[other.upper];
  for (const bool isLower : {true, false}) {
    for (const bool isOtherLower : {true, false}) {
      const auto vertex = isLower ? one.lower : one.upper;
      if (vertex != (isOtherLower ? other.lower : other.upper)) continue;
      auto first = isLower ? b - a : a - b;
      auto second = isOtherLower ? d - c : c - d;
      first[axis_] = second[axis_] = 0;
      return side(one, isOtherLower ? d : c) == 0 && dot(first, second) > 0;
    }
  }
  return side(one, c) * side(one, d) <= 0 && side(other, a) * side(other, b) <= 0;
}

/// How often the plane is covered beyond the middle of an edge, up the second axis: what the edges
/// beyond add up to.
int PlaneRims::coverAbove(const OpenEdge& edge) const {
  const auto middle = 0.5 * (positions_[edge.lower] + positions_[edge.upper]);
  int sum = 0;
  for (const auto& other : edges_) {
    if (least(other, u_) > middle[u_]) break;
    if (most(other, u_) <= middle[u_] || &other == &edge) continue;
    const int direction = at(other.lower, u_) < at(other.upper, u_) ? 1 : -1;
    if (side(other, middle) * direction < 0) sum += step(other);
  }
  return sum;
}

/// Along a loop that meets no other, what is on either side is the same.
bool PlaneRims::coverOnce() const {
  detail::DisjointSets loops(positions_.size());
  std::map<std::uint32_t, const OpenEdge*> widest;  // of each loop
  for (const auto& edge : edges_) loops.unite(edge.lower, edge.upper);
  const auto width = [&](const OpenEdge& edge) { return most(edge, u_) - least(edge, u_); };
  for (const auto& edge : edges_) {
    auto& best = widest[loops.find(edge.lower)];
    if (best == nullptr || width(edge) > width(*best)) best = &edge;
  }
  return std::ranges::all_of(widest, [&](const auto& entry) {
    const auto& edge = *entry.second;
    const int above = coverAbove(edge);
    return std::abs(above) <= 1 && std::abs(above + step(edge)) <= 1;
  });
}

/// The axis along which a vector is longest.
int longestAxis(const Vec3<double>& v) {
  const auto size = abs(v);
  return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
}

}  // namespace

std::vector<CapGroup> capsByPlane(const HoleCaps& caps) {
  const auto each = eachCap(caps);
  std::vector<std::size_t> order(each.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto size = [&](std::size_t n) { return -lengthSquared(each[n].area); };
  std::ranges::stable_sort(order, {}, size);  // large caps know their planes best

  std::vector<std::size_t> planes;  // a cap in each
  std::vector<CapGroup> groups;
  CapGroup others;
  for (const auto n : order) {
    const auto& cap = each[n];
    if (!(lengthSquared(cap.area) > 0) || !liesIn(cap, cap, caps)) {
      others.triangles.insert(others.triangles.end(), cap.triangles.begin(), cap.triangles.end());
      continue;
    }
    const auto plane =
        std::ranges::find_if(planes, [&](std::size_t p) { return liesIn(cap, each[p], caps); });
    const auto group = static_cast<std::size_t>(plane - planes.begin());
    if (plane == planes.end()) {
      planes.push_back(n);
      groups.push_back({.triangles = {}, .isFlat = true});
    }
    auto& triangles = groups[group].triangles;
    triangles.insert(triangles.end(), cap.triangles.begin(), cap.triangles.end());
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    auto& [triangles, isFlat] = groups[g];
    isFlat = PlaneRims(caps, triangles, longestAxis(each[planes[g]].area)).windOnce();
    if (!isFlat)
      others.triangles.insert(others.triangles.end(), triangles.begin(), triangles.end());
  }
  std::erase_if(groups, [](const CapGroup& group) { return !group.isFlat; });
  if (!others.triangles.empty()) groups.push_back(std::move(others));
  return groups;
}

}  // namespace cutwater
