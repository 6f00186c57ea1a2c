#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/CutCells/Detail/Surface/SheetKinds.hpp>
#include <Cutwater/Triangles/ExactPredicates.hpp>
#include <Cutwater/Triangles/TriangleIntersection.hpp>

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

namespace cutwater {

namespace {

class KindFinder {
 public:
  explicit KindFinder(const SheetInput& input)
      : in_(input), kinds_(input.surface.closedCount(), SheetKind::Wall) {}

  std::vector<SheetKind> run() {
    if (in_.meetings == MeetingsOf::Shells) {
      findShells();
      if (boxes_.size() > 1) noteMeetings();
      if (std::ranges::count(kinds_, SheetKind::Meeting) == 0) return {};
    } else {
      noteMeetings();
      noteCrowdedEdges();
      decideParts();
    }
    decideGaps();
    return std::move(kinds_);
  }

 private:
  [[nodiscard]] std::array<Vec3<double>, 3> placesOf(std::uint32_t triangle) const {
    const auto& [a, b, c] = in_.corners[triangle];
    return {in_.positions[a], in_.positions[b], in_.positions[c]};
  }
  [[nodiscard]] Box<double> boxOf(std::uint32_t triangle) const {
    Box<double> box;
    for (const auto& p : placesOf(triangle)) box.extend(p);
    return box;
  }
  [[nodiscard]] bool meetsAny(std::uint32_t triangle) const {
    const auto box = boxOf(triangle);
    if (!box.overlaps(in_.where) || !hasArea(placesOf(triangle))) return false;
    if (!shellOf_.empty() && !isInOthers(shellOf_[triangle], box)) return false;
    return std::ranges::any_of(in_.trianglesIn(box), [&](std::uint32_t other) {
      return other < in_.corners.size() && mayMeet(triangle, other) && hasArea(placesOf(other)) &&
             intersect(in_.positions, in_.corners[triangle], in_.corners[other]);
    });
  }
  [[nodiscard]] bool mayMeet(std::uint32_t one, std::uint32_t other) const {
    return shellOf_.empty() ? one != other : shellOf_[one] != shellOf_[other];
  }

  /// Triangles of the mesh that are connected across edges, and gaps between copies of vertices.
  void findShells() {
    const auto count = static_cast<std::uint32_t>(kinds_.size());
    detail::DisjointSets sets(count);
    forEdges([&](std::uint32_t one, std::uint32_t other) { sets.unite(one, other); });
    shellOf_.assign(count, kNoTriangle);
    for (std::uint32_t i = 0; i < count; ++i) {
      auto& shell = shellOf_[sets.find(i)];
      if (shell == kNoTriangle) {
        shell = static_cast<std::uint32_t>(boxes_.size());
        boxes_.emplace_back();
      }
      shellOf_[i] = shell;
      for (const auto& vertex : in_.surface.triangle(i)) boxes_[shell].extend(vertex.position);
    }
    order_.resize(boxes_.size());
    std::iota(order_.begin(), order_.end(), 0U);
    std::ranges::sort(order_, {}, [this](std::uint32_t shell) { return boxes_[shell].lower.x; });
    for (const auto& box : boxes_) longest_ = std::max(longest_, box.size().x);
  }
  /// Whether a box is in that of another shell than its own, or touches it.
  [[nodiscard]] bool isInOthers(std::uint32_t own, const Box<double>& box) const {
    const auto lower = [this](std::uint32_t shell) { return boxes_[shell].lower.x; };
    auto shell = std::ranges::lower_bound(order_, box.lower.x - longest_, {}, lower);
    for (; shell != order_.end() && lower(*shell) <= box.upper.x; ++shell) {
      if (*shell != own && boxes_[*shell].overlaps(box)) return true;
    }
    return false;
  }
  void noteMeetings() {
    parallelFor(in_.corners.size(), {}, [&](std::size_t begin, std::size_t end) {
      for (auto i = static_cast<std::uint32_t>(begin); i < end; ++i) {
        if (meetsAny(i)) kinds_[i] = SheetKind::Meeting;
      }
    });
  }
  void noteCrowdedEdges() {
    std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>> sides;
    for (std::uint32_t i = 0; i < in_.corners.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto ends = std::minmax(in_.corners[i][k], in_.corners[i][(k + 1) % 3]);
        sides.push_back({{ends.first, ends.second}, i});
      }
    }
    std::ranges::sort(sides);
    for (std::size_t first = 0; first < sides.size();) {
      auto last = first;
      while (last < sides.size() && sides[last].first == sides[first].first) ++last;
      for (auto i = first; i < last && last - first > 2; ++i) {
        kinds_[sides[i].second] = SheetKind::Meeting;
      }
      first = last;
    }
  }

  /// Calls visit(one, other) for the triangles at each edge.
  template <typename Visit>
  void forEdges(Visit&& visit) const {
    std::vector<std::uint32_t> atEdge(3 * kinds_.size(), kNoTriangle);
    for (std::uint32_t i = 0; i < kinds_.size(); ++i) {
      for (const auto edge : in_.surface.edges(i)) {
        const auto other = std::exchange(atEdge[edge], i);
        if (other != kNoTriangle) visit(other, i);
      }
    }
  }
  /// Whether it is one that closes the gap between copies of vertices.
  [[nodiscard]] bool isGap(std::uint32_t triangle) const { return triangle >= in_.corners.size(); }

  /// Triangles of the mesh that are connected across edges where kinds are wanted, without those
  /// that meet others, are of one kind.
  void decideParts() {
    const auto count = static_cast<std::uint32_t>(in_.corners.size());
    detail::DisjointSets sets(count);
    const auto isPart = [&](std::uint32_t i) {
      return !isGap(i) && kinds_[i] != SheetKind::Meeting && boxOf(i).overlaps(in_.where);
    };
    forEdges([&](std::uint32_t one, std::uint32_t other) {
      if (isPart(one) && isPart(other)) sets.unite(one, other);
    });
    std::vector<std::uint32_t> largest(count, kNoTriangle);
    std::vector<double> areas(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      const auto root = sets.find(i);
      const double area = length(normalOf(i));
      if (area > areas[root]) areas[root] = area, largest[root] = i;
    }
    std::vector<SheetKind> ofPart(count, SheetKind::Meeting);  // where there is no room
    for (std::uint32_t i = 0; i < count; ++i) {
      if (!sets.isRoot(i) || largest[i] == kNoTriangle || !isPart(i)) continue;
      const auto winding = windingInFront(largest[i]);
      if (winding) ofPart[i] = *winding == 0 ? SheetKind::Wall : SheetKind::Buried;
    }
    for (std::uint32_t i = 0; i < count; ++i) {
      if (isPart(i)) kinds_[i] = ofPart[sets.find(i)];
    }
  }
  /// Gaps are of the kind of all triangles of the mesh around them, if these are of one.
  void decideGaps() {
    detail::DisjointSets sets(kinds_.size());
    forEdges([&](std::uint32_t one, std::uint32_t other) {
      if (isGap(one) && isGap(other)) sets.unite(one, other);
    });
    constexpr std::array kAll{SheetKind::Wall, SheetKind::Buried, SheetKind::Meeting};
    std::vector<std::array<bool, kAll.size()>> around(kinds_.size());
    forEdges([&](std::uint32_t one, std::uint32_t other) {
      if (isGap(one)) std::swap(one, other);
      if (isGap(one) || !isGap(other)) return;
      around[sets.find(other)][static_cast<std::size_t>(kinds_[one])] = true;
    });
    for (auto i = static_cast<std::uint32_t>(in_.corners.size()); i < kinds_.size(); ++i) {
      kinds_[i] = SheetKind::Meeting;
      for (const auto kind : kAll) {
        auto only = std::array<bool, kAll.size()>{};
        only[static_cast<std::size_t>(kind)] = true;
        if (around[sets.find(i)] == only) kinds_[i] = kind;
      }
    }
  }
  [[nodiscard]] Vec3<double> normalOf(std::uint32_t triangle) const {
    const auto [a, b, c] = in_.surface.positionsOf(triangle);
    return cross(b - a, c - a);
  }
  /// The winding number just in front of a triangle that meets no others, on the side to which its
  /// normal points; behind it, it is one more. None if the triangle is so thin that its middle is
  /// beside it.
  ///
  /// Others may be nearer to it than rounding: which of them are below its middle is asked of the
  /// triangles, not of the middle's height.
  [[nodiscard]] std::optional<int> windingInFront(std::uint32_t triangle) const {
    const auto corners = in_.surface.positionsOf(triangle);
    const auto& [a, b, c] = corners;
    const int axis = nearestAxis(normalOf(triangle));
    const int up = crossSign(a, b, a, c, axis);
    if (up == 0) return {};
    auto middle = (a + b + c) / 3.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& from = corners[i];
      if (crossSign(from, corners[(i + 1) % 3], from, middle, axis) != up) return {};
    }
    Box<double> line{middle, middle};
    line.lower[axis] = -Box<double>::kInf;
    line.upper[axis] = Box<double>::kInf;
    int winding = in_.windingOutside;
    for (const auto other : in_.trianglesIn(line)) {
      if (other == triangle || in_.surface.isBaffle(other)) continue;
      const auto places = in_.surface.positionsOf(other);
      middle[axis] = 1 + std::max({places[0][axis], places[1][axis], places[2][axis]});
      const int rise = riseBelowNode(in_.surface.triangle(other), middle, axis);
      if (rise != 0 && orderAlong(corners, places, axis) < 0) winding += rise;
    }
    // So it is below the triangle: behind one that faces up.
    return up > 0 ? winding - 1 : winding;
  }

  static constexpr std::uint32_t kNoTriangle = 0xffffffff;

  const SheetInput& in_;
  std::vector<SheetKind> kinds_;
  // Of shells, if only these may touch:
  std::vector<std::uint32_t> shellOf_;  // by triangle
  std::vector<Box<double>> boxes_;
  std::vector<std::uint32_t> order_;  // along x
  double longest_ = 0;                // of their lengths along x
};

}  // namespace

std::vector<SheetKind> findSheetKinds(const SheetInput& input) {
  return KindFinder(input).run();
}

}  // namespace cutwater
