#include <Cutwater/CutCells/Detail/Faces/JoinedLoops.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <span>
#include <utility>

namespace cutwater {

namespace {

/// Joins holes to the outline around them.
class HoleJoiner {
 public:
  explicit HoleJoiner(const FaceAxes& axes) : c_(axes.first), d_(axes.second) {}

  using Loop = std::vector<Vec3<double>>;

  [[nodiscard]] Loop joined(std::vector<Loop> loops) const {
    auto outline = std::move(loops.front());
    // From below: what is below a hole's lowest point is joined already.
    std::vector<Loop> holes(std::make_move_iterator(loops.begin() + 1),
                            std::make_move_iterator(loops.end()));
    for (auto& hole : holes) {
      const auto lowest =
          std::ranges::min_element(hole, {}, [this](const Vec3<double>& p) { return p[d_]; });
      std::rotate(hole.begin(), lowest, hole.end());
    }
    std::ranges::sort(holes, {}, [this](const Loop& hole) { return hole.front()[d_]; });
    for (const auto& hole : holes) join(outline, hole);
    return outline;
  }

 private:
  void join(Loop& outline, const Loop& hole) const {
    const auto at = outline.begin() + static_cast<std::ptrdiff_t>(seenFrom(outline, hole.front()));
    Loop way(hole);
    way.push_back(hole.front());
    way.push_back(*at);
    outline.insert(at + 1, way.begin(), way.end());
  }

  /// A corner of the outline below the point that nothing of the outline hides (Eberly,
  /// "Triangulation by ear clipping", 2002).
  [[nodiscard]] std::size_t seenFrom(const Loop& outline, const Vec3<double>& p) const {
    std::size_t best = 0;
    double height = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const auto next = (i + 1) % outline.size();
      const auto& from = outline[i];
      const auto& to = outline[next];
      if ((from[c_] <= p[c_]) == (to[c_] <= p[c_])) continue;
      const double here = from[d_] + (p[c_] - from[c_]) / (to[c_] - from[c_]) * (to[d_] - from[d_]);
      if (here > p[d_] || here <= height) continue;
      height = here;
      best = from[d_] < to[d_] ? i : next;
    }
    // Corners in the triangle of the point, what is right below it, and that corner may hide it:
    // the one that is least to the side is seen.
    const auto& corner = outline[best];
    const auto slope = [&](const Vec3<double>& q) {
      return std::abs(q[c_] - p[c_]) / (p[d_] - q[d_]);
    };
    double least = slope(corner);
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const auto& q = outline[i];
      const bool isOnThatSide = (q[c_] - p[c_]) * (corner[c_] - p[c_]) > 0;
      if (!isOnThatSide || q[d_] >= p[d_] || !(slope(q) < least)) continue;
      // Above the line from the point right below to the corner.
      const double share = (q[c_] - p[c_]) / (corner[c_] - p[c_]);
      if (share > 1 || q[d_] < height + share * (corner[d_] - height)) continue;
      least = slope(q);
      best = i;
    }
    return best;
  }

  int c_;
  int d_;
};

double areaOf(std::span<const Vec3<double>> loop, int axis) {
  double area = 0;
  for (std::size_t i = 2; i < loop.size(); ++i) {
    area += cross(loop[i - 1] - loop[0], loop[i] - loop[0])[axis];
  }
  return area;
}

}  // namespace

std::vector<Vec3<double>> joinedLoops(const FaceAxes& axes,
                                      std::vector<std::vector<Vec3<double>>> loops) {
  if (loops.empty()) return {};
  // The rim is the largest.
  const auto rim = std::ranges::max_element(
      loops, {}, [&](const auto& loop) { return areaOf(loop, axes.across); });
  std::iter_swap(loops.begin(), rim);
  return HoleJoiner(axes).joined(std::move(loops));
}

}  // namespace cutwater
