#include <Cutwater/Core/Detail/DoubleDouble.hpp>
#include <Cutwater/Surface/Detail/EarClipping.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace cutwater::detail {
namespace {

struct Point2 {
  double x, y;
  bool operator==(const Point2&) const = default;
};

/// Projects along the largest component of the normal, with turns as seen from the side it points
/// to.
std::vector<Point2> projected(std::span<const Vec3<double>> corners, const Vec3<double>& normal) {
  const Vec3<double> size = abs(normal);
  const int axis = size.x > size.y && size.x > size.z ? 0 : size.y > size.z ? 1 : 2;
  const bool flip = normal[axis] < 0;
  const int u = (axis + (flip ? 2 : 1)) % 3;
  const int v = (axis + (flip ? 1 : 2)) % 3;
  std::vector<Point2> points;
  points.reserve(corners.size());
  for (const auto& p : corners) points.push_back({p[u], p[v]});
  return points;
}

/// > 0 if a, b, c turn left, < 0 if right, 0 if they are collinear. Decided in double where its
/// rounding allows, else in twice the precision.
double turn(const Point2& a, const Point2& b, const Point2& c) {
  constexpr double kFilter = 4 * std::numeric_limits<double>::epsilon();
  constexpr double kRounding = 0x1p-98;
  const double left = (b.x - a.x) * (c.y - a.y);
  const double right = (b.y - a.y) * (c.x - a.x);
  const double size = std::abs(left) + std::abs(right);
  if (std::abs(left - right) > kFilter * size) return left - right;
  using D = DoubleDouble;
  const D precise = D::difference(b.x, a.x) * D::difference(c.y, a.y) -
                    D::difference(b.y, a.y) * D::difference(c.x, a.x);
  return std::abs(precise.high) > kRounding * size ? precise.high : 0;
}

class EarClipper {
 public:
  EarClipper(std::span<const Vec3<double>> corners, const Vec3<double>& normal)
      : corners_(corners), points_(projected(corners, normal)), links_(corners.size()) {
    const auto n = static_cast<std::uint32_t>(corners.size());
    for (std::uint32_t i = 0; i < n; ++i) links_[i] = {(i + n - 1) % n, (i + 1) % n};
    for (std::uint32_t i = 0; i < n; ++i) {
      if (turnAt(i) <= 0) mayBlock_.push_back(i);
      enqueue(i);
    }
    std::sort(mayBlock_.begin(), mayBlock_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return points_[a].x < points_[b].x || (points_[a].x == points_[b].x && a < b);
    });
  }

  void run(std::vector<PlaceTriangle>& triangles) {
    for (std::size_t left = corners_.size(); left > 3; --left) triangles.push_back(clipBest());
    while (links_[queue_.top().corner].removed) queue_.pop();
    triangles.push_back(triangleAt(queue_.top().corner));
  }

 private:
  struct Link {
    std::uint32_t previous = 0;
    std::uint32_t next = 0;
    std::uint32_t version = 0;  ///< counts changes of the neighbours
    bool removed = false;
  };
  /// The kinds of corners to clip, in order of preference. Only simple polygons make do with the
  /// first; the others ensure that clipping always terminates.
  enum class Kind { Convex, Flat, Blocked, Reflex };
  struct Candidate {
    Kind kind;
    double quality;
    std::uint32_t corner;
    std::uint32_t version;

    /// Whether the other candidate is clipped first.
    bool operator<(const Candidate& other) const {
      if (kind != other.kind) return kind > other.kind;
      if (quality != other.quality) return quality < other.quality;
      return corner > other.corner;
    }
  };

  [[nodiscard]] PlaceTriangle triangleAt(std::uint32_t i) const {
    return {links_[i].previous, i, links_[i].next};
  }
  [[nodiscard]] double turnAt(std::uint32_t i) const {
    return turn(points_[links_[i].previous], points_[i], points_[links_[i].next]);
  }

  void enqueue(std::uint32_t i) {
    const double side = turnAt(i);
    const auto [a, b, c] = triangleAt(i);
    queue_.push({side > 0    ? Kind::Convex
                 : side == 0 ? Kind::Flat
                             : Kind::Reflex,
                 triangleQuality(corners_[a], corners_[b], corners_[c]), i, links_[i].version});
  }

  PlaceTriangle clipBest() {
    for (;;) {
      Candidate best = queue_.top();
      queue_.pop();
      if (links_[best.corner].removed || links_[best.corner].version != best.version) continue;
      if (best.kind == Kind::Convex && isBlocked(best.corner)) {
        best.kind = Kind::Blocked;
        queue_.push(best);
        continue;
      }
      return clip(best.corner);
    }
  }

  PlaceTriangle clip(std::uint32_t i) {
    const auto triangle = triangleAt(i);
    links_[i].removed = true;
    links_[triangle[0]].next = triangle[2];
    links_[triangle[2]].previous = triangle[0];
    for (const std::uint32_t neighbour : {triangle[0], triangle[2]}) {
      ++links_[neighbour].version;
      enqueue(neighbour);
    }
    return triangle;
  }

  /// Whether another corner lies in the triangle or on its border. Only corners that are not convex
  /// need a test, and only those in the triangle's range of x.
  [[nodiscard]] bool isBlocked(std::uint32_t i) const {
    const auto [ia, ib, ic] = triangleAt(i);
    const Point2 a = points_[ia];
    const Point2 b = points_[ib];
    const Point2 c = points_[ic];
    const double last = std::max({a.x, b.x, c.x});
    auto at =
        std::lower_bound(mayBlock_.begin(), mayBlock_.end(), std::min({a.x, b.x, c.x}),
                         [&](std::uint32_t corner, double x) { return points_[corner].x < x; });
    for (; at != mayBlock_.end() && points_[*at].x <= last; ++at) {
      const Point2 p = points_[*at];
      if (links_[*at].removed || p == a || p == b || p == c) continue;
      if (turn(a, b, p) < 0 || turn(b, c, p) < 0 || turn(c, a, p) < 0) continue;
      if (turnAt(*at) <= 0) return true;
    }
    return false;
  }

  std::span<const Vec3<double>> corners_;
  std::vector<Point2> points_;
  std::vector<Link> links_;
  std::vector<std::uint32_t> mayBlock_;  ///< corners not convex at first, by x
  std::priority_queue<Candidate> queue_;
};

}  // namespace

void clipEars(std::span<const Vec3<double>> corners, const Vec3<double>& normal,
              std::vector<PlaceTriangle>& triangles) {
  EarClipper(corners, normal).run(triangles);
}

double triangleQuality(const Vec3<double>& a, const Vec3<double>& b, const Vec3<double>& c) {
  constexpr double kTwoSqrt3 = 3.4641016151377544;
  const double squares = lengthSquared(b - a) + lengthSquared(c - b) + lengthSquared(a - c);
  return squares > 0 ? kTwoSqrt3 * length(cross(b - a, c - a)) / squares : 0;
}

}  // namespace cutwater::detail
