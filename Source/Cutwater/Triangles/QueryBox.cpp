#include <Cutwater/Triangles/QueryBox.hpp>
#include <Cutwater/Triangles/TriangleDistance.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

/// Orthonormal axes along the half axes; arbitrary where these are too short to determine them.
std::array<Vec3<double>, 3> axesAlong(const std::array<Vec3<double>, 3>& halfAxes) {
  std::array<std::size_t, 3> order{0, 1, 2};  // longest first: its direction is the most accurate
  std::ranges::sort(order, std::greater<>{},
                    [&](std::size_t i) { return lengthSquared(halfAxes[i]); });
  std::array<Vec3<double>, 3> axes;
  const auto direction = [](const Vec3<double>& v, const Vec3<double>& otherwise) {
    const auto unit = normalized(v);
    return unit == Vec3<double>{} ? otherwise : unit;
  };
  auto& first = axes[order[0]];
  first = direction(halfAxes[order[0]], {1, 0, 0});
  const Vec3<double> leastAlong =
      std::abs(first.x) < 0.6 ? Vec3<double>{1, 0, 0} : Vec3<double>{0, 1, 0};
  const auto across = [&](const Vec3<double>& v) { return v - dot(v, first) * first; };
  auto& second = axes[order[1]];
  second = direction(across(halfAxes[order[1]]), normalized(across(leastAlong)));
  // Repeated, to remove what rounding left along the first axis.
  second = normalized(across(second));
  axes[order[2]] = cross(first, second);
  return axes;
}

/// The directions across an edge and each of the box's axes.
std::array<Vec3<double>, 3> acrossEdges(const Vec3<double>& e) {
  return {{{0, -e.z, e.y}, {e.z, 0, -e.x}, {-e.y, e.x, 0}}};
}

/// A convex polygon to be clipped; a triangle and six planes give at most nine corners.
class Polygon {
 public:
  explicit Polygon(const QueryBox::Corners& triangle) : count_(3) {
    std::ranges::copy(triangle, corners_.begin());
  }

  /// Keeps the part where sign * coordinate <= limit. (Sutherland and Hodgman 1974.)
  void clip(int axis, double sign, double limit) {
    std::array<Vec3<double>, 9> kept;
    std::size_t found = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const auto& a = corners_[i];
      const auto& b = corners_[i + 1 < count_ ? i + 1 : 0];
      const double overA = sign * a[axis] - limit;
      const double overB = sign * b[axis] - limit;
      if (overA <= 0) kept[found++] = a;
      if ((overA <= 0) != (overB <= 0)) kept[found++] = a + overA / (overA - overB) * (b - a);
    }
    corners_ = kept;
    count_ = found;
  }
  [[nodiscard]] bool empty() const { return count_ == 0; }

 private:
  std::array<Vec3<double>, 9> corners_;
  std::size_t count_;
};

}  // namespace

QueryBox::QueryBox(const OrientedBox<double>& box)
    : center_(box.center), axes_(axesAlong(box.halfAxis)) {
  double size = oneNorm(center_);
  for (const auto& half : box.halfAxis) size += oneNorm(half);
  // Rounding of differences, products and sums of coordinates up to about 1, and of the box's own.
  rounding_ = 0x1p-48 * (1 + size);
  for (int i = 0; i < 3; ++i) {
    const auto& axis = axes_[static_cast<std::size_t>(i)];
    double reach = 0;
    for (const auto& half : box.halfAxis) reach += std::abs(dot(half, axis));
    // Half axes that are not quite orthogonal extend the box on one side and shrink it on the
    // other.
    const double own = std::abs(dot(box.halfAxis[static_cast<std::size_t>(i)], axis));
    half_[i] = reach + box.slack + rounding_;
    innerHalf_[i] = own - (reach - own) - box.slack - 4 * rounding_;
  }
}

Vec3<double> QueryBox::toBox(const Vec3<double>& p) const {
  const Vec3<double> d = p - center_;
  return {dot(axes_[0], d), dot(axes_[1], d), dot(axes_[2], d)};
}

auto QueryBox::toBox(const Corners& triangle) const -> Corners {
  return {toBox(triangle[0]), toBox(triangle[1]), toBox(triangle[2])};
}

BoxOverlap QueryBox::overlapWith(const Corners& triangle, BoxOverlap before) const {
  if (before == BoxOverlap::Certain) return before;
  const auto corners = toBox(triangle);
  if (before == BoxOverlap::None && isApart(corners)) return before;
  return meets(corners) ? BoxOverlap::Certain : BoxOverlap::Possible;
}

double QueryBox::separation(const Vec3<double>& axis, const Corners& triangle) const {
  const double a = dot(axis, triangle[0]);
  const double b = dot(axis, triangle[1]);
  const double c = dot(axis, triangle[2]);
  const double reach = dot(abs(axis), half_) + rounding_ * oneNorm(axis);
  return std::max(std::min({a, b, c}), -std::max({a, b, c})) - reach;
}

bool QueryBox::isApart(const Corners& triangle) const {
  const auto& [a, b, c] = triangle;
  const Vec3<double> lower = min(a, min(b, c)) - half_;
  const Vec3<double> upper = max(a, max(b, c)) + half_;
  if (maxComponent(lower) > rounding_ || maxComponent(-upper) > rounding_) return true;
  const std::array<Vec3<double>, 3> edges{b - a, c - b, a - c};
  if (separation(cross(edges[0], edges[2]), triangle) > 0) return true;
  return std::ranges::any_of(edges, [&](const Vec3<double>& e) {
    return std::ranges::any_of(
        acrossEdges(e), [&](const Vec3<double>& axis) { return separation(axis, triangle) > 0; });
  });
}

bool QueryBox::meets(const Corners& triangle) const {
  if (!hasInside()) return false;
  const auto& [a, b, c] = triangle;
  const Vec3<double> apart = max(min(a, min(b, c)) - innerHalf_, -innerHalf_ - max(a, max(b, c)));
  if (maxComponent(apart) > 0) return false;
  Polygon polygon(triangle);
  for (int axis = 0; axis < 3; ++axis) {
    polygon.clip(axis, 1, innerHalf_[axis]);
    polygon.clip(axis, -1, innerHalf_[axis]);
    if (polygon.empty()) return false;
  }
  return true;
}

double QueryBox::gap(const Corners& triangle, double enough) const {
  const auto certain = [this](double g) { return g * (1 - 0x1p-40) - 4 * rounding_; };
  const auto& [a, b, c] = triangle;
  const Vec3<double> apart = max(min(a, min(b, c)) - half_, -max(a, max(b, c)) - half_);
  double best = length(max(apart, {}));
  if (certain(best) >= enough) return certain(best);

  // Any direction gives a bound; that of the gap gives the gap itself.
  const auto ask = [&](const Vec3<double>& direction) {
    const double size = length(direction);
    if (size > 0) best = std::max(best, separation(direction, triangle) / size);
  };
  ask(cross(b - a, c - a));
  for (const auto& e : {b - a, c - b, a - c}) {
    for (const auto& axis : acrossEdges(e)) ask(axis);
  }
  for (const auto& corner : triangle) ask(corner - max(-half_, min(half_, corner)));
  if (certain(best) >= enough) return certain(best);

  // Otherwise an edge is nearest to a corner of the box; alternating projections onto the two lead
  // there.
  constexpr int kMostSteps = 16;
  const Triangle<double> t{a, b, c, isSliver(a, b, c)};
  Vec3<double> inBox;
  for (int step = 0; step < kMostSteps; ++step) {
    const auto weights = closestBarycentric(inBox, t, triangleDistance(inBox, t).part);
    const Vec3<double> onTriangle = weights.x * t.a + weights.y * t.b + weights.z * t.c;
    inBox = max(-half_, min(half_, onTriangle));
    const Vec3<double> w = onTriangle - inBox;
    const double distance = length(w);
    if (distance == 0) break;
    ask(w);
    if (best >= distance * (1 - 0x1p-10) || certain(best) >= enough) break;
  }
  return std::max(0.0, certain(best));
}

}  // namespace cutwater
