#include <Cutwater/CutCells/Detail/Faces/MergedPoints.hpp>
#include <Cutwater/CutCells/Detail/Faces/SheetTree.hpp>
#include <Cutwater/CutCells/Detail/Pieces/WallJoining.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace cutwater {

namespace {

using Polygon = std::vector<Vec3<double>>;

/// Distances below this are rounding.
constexpr double kFlat = 4 * MergedPoints::kSame;

bool areInOnePlane(const Polygon& one, const Polygon& other) {
  const auto a = twiceArea(one);
  const auto b = twiceArea(other);
  if (!(dot(a, b) > 0)) return false;
  const bool isFirst = lengthSquared(a) > lengthSquared(b);
  const auto normal = (isFirst ? a : b) / length(isFirst ? a : b);
  const auto& larger = isFirst ? one : other;
  return std::ranges::all_of(isFirst ? other : one, [&](const Vec3<double>& p) {
    return std::abs(dot(normal, p - larger[0])) <= kFlat;
  });
}

/// How a polygon with this normal goes on at a corner: 1: to the left, 0: straight, -1: to the
/// right.
int turnAt(const Vec3<double>& before, const Vec3<double>& at, const Vec3<double>& after,
           const Vec3<double>& normal) {
  const double sine = dot(cross(at - before, after - at), normal);
  const double limit = MergedPoints::kSame * std::max(length(at - before), length(after - at));
  if (sine > limit) return 1;
  return sine < -limit ? -1 : 0;
}

/// The union of two polygons at an edge that is the first of `one`, and of `other` against its
/// order; empty if it is not convex.
Polygon joined(const Polygon& one, const Polygon& other) {
  Polygon all(one.begin() + 1, one.end());
  all.push_back(one[0]);
  all.insert(all.end(), other.begin() + 2, other.end());
  const auto area = twiceArea(one) + twiceArea(other);
  const auto normal = area / length(area);
  // From the edge's end around `one` to its begin, then around `other`: these two are the joints.
  std::array<std::size_t, 2> joints{one.size() - 1, 0};
  for (const auto joint : joints) {
    const auto& before = all[(joint + all.size() - 1) % all.size()];
    const auto& after = all[(joint + 1) % all.size()];
    const int turn = turnAt(before, all[joint], after, normal);
    const bool goesOn = turn > 0 || dot(all[joint] - before, after - all[joint]) > 0;
    if (turn < 0 || !goesOn) return {};
    if (turn == 0 && all.size() > 3) all.erase(all.begin() + static_cast<std::ptrdiff_t>(joint));
  }
  return all;
}

class Joiner {
 public:
  explicit Joiner(std::vector<Polygon>& polygons) : polygons_(polygons) {
    for (std::size_t n = 0; n < polygons.size(); ++n) note(n);
  }

  void run() {
    for (std::size_t n = 0; n < polygons_.size(); ++n) {
      while (joinsAnother(n)) {
      }
    }
    std::erase_if(polygons_, [](const Polygon& polygon) { return polygon.empty(); });
  }

 private:
  using Key = std::array<double, 6>;
  static Key keyOf(const Vec3<double>& from, const Vec3<double>& to) {
    return {from.x, from.y, from.z, to.x, to.y, to.z};
  }
  void note(std::size_t n) {
    const auto& polygon = polygons_[n];
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      ofEdge_[keyOf(polygon[k], polygon[(k + 1) % polygon.size()])] = n;
    }
  }
  /// Takes a neighbour in, if there is one.
  bool joinsAnother(std::size_t n) {
    auto& polygon = polygons_[n];
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const auto& from = polygon[k];
      const auto& to = polygon[(k + 1) % polygon.size()];
      const auto found = ofEdge_.find(keyOf(to, from));
      if (found == ofEdge_.end() || found->second == n) continue;
      auto& other = polygons_[found->second];
      const auto at = edgeAt(other, to, from);
      if (at == other.size() || !areInOnePlane(polygon, other)) continue;
      auto all = joined(rotated(polygon, k), rotated(other, at));
      if (all.empty()) continue;
      polygon = std::move(all);
      other.clear();
      note(n);
      return true;
    }
    return false;
  }
  /// The polygon's edge; beyond all if it has not got it any more.
  static std::size_t edgeAt(const Polygon& polygon, const Vec3<double>& from,
                            const Vec3<double>& to) {
    std::size_t k = 0;
    while (k < polygon.size() && !(polygon[k] == from && polygon[(k + 1) % polygon.size()] == to)) {
      ++k;
    }
    return k;
  }
  static Polygon rotated(const Polygon& polygon, std::size_t first) {
    Polygon result(polygon.begin() + static_cast<std::ptrdiff_t>(first), polygon.end());
    result.insert(result.end(), polygon.begin(),
                  polygon.begin() + static_cast<std::ptrdiff_t>(first));
    return result;
  }

  std::vector<Polygon>& polygons_;
  std::map<Key, std::size_t> ofEdge_;
};

}  // namespace

void joinConvex(std::vector<std::vector<Vec3<double>>>& polygons) {
  Joiner(polygons).run();
}

}  // namespace cutwater
