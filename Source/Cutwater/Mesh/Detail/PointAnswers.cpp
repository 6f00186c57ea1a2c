#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Mesh/Detail/DcelIndex.hpp>
#include <Cutwater/Mesh/Detail/MeshIndex.hpp>
#include <Cutwater/Mesh/Detail/PointAnswers.hpp>
#include <Cutwater/Triangles/ExactPredicates.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

/// The least depth of a point inside a closed surface, so that a point whose distance rounds to 0
/// keeps its sign: far below any error, but still not 0 after division by a surface's scale.
template <std::floating_point T>
constexpr T kLeastDepth = T(sizeof(T) == sizeof(float) ? 0x1p-63 : 0x1p-511);

}  // namespace

template <std::floating_point T, typename Index>
Vec3<T> PointAnswers<T, Index>::pulledIn(const Vec3<T>& point) {
  return kFarthest * (point / maxComponent(abs(point)));
}

template <std::floating_point T, typename Index>
Vec3<T> PointAnswers<T, Index>::scale(std::span<const Vec3<T>> points, std::span<Vec3<T>> p) const {
  Vec3<T> most;
  for (std::size_t i = 0; i < points.size(); ++i) {
    p[i] = surface().scale * points[i];
    most = max(most, abs(p[i]));
  }
  if (maxComponent(most) <= kFarthest) return most;
  for (std::size_t i = 0; i < points.size(); ++i) p[i] = scaled(points[i]);
  return {kFarthest, kFarthest, kFarthest};
}

template <std::floating_point T, typename Index>
int PointAnswers<T, Index>::disputedSide(const Vec3<T>& p, const Nearest& nearest) const {
  const bool byNearest = signs().scheme == SignScheme::NearestFeature;
  // The distance of a point beside the surface may round to 0.
  if (!signs().isClosed() && nearest.distanceSquared == 0 &&
      (byNearest || isOnTriangle(Vec3<double>(p), surface().corners(nearest.triangle)))) {
    return 0;
  }
  if (byNearest) {
    if (const int agreed = nearest.agreedSide(); agreed != 0) return agreed;
    if (!signs().isClosed()) return surface().pseudonormalSide(p, nearest);
  }
  if (!signs().isClosed()) return index_.isSurrounded(p, nearest) ? -1 : 1;
  if (const auto beside = index_.windingBeside(p, nearest)) return *beside >= 1 ? -1 : 1;
  const auto location = locate(surface(), Vec3<double>(p), index_.trianglesAlong());
  return location.onSurface ? 0 : location.isInside() ? -1 : 1;
}

template <std::floating_point T, typename Index>
bool PointAnswers<T, Index>::isInside(const Vec3<T>& p) const {
  return side(p, index_.nearest(p)) < 0;
}

/// Where signs are those of winding numbers, and change at triangles alone in a box around some
/// points, they are the same at two points that are closer to each other than to these: no triangle
/// is between them.
template <std::floating_point T, typename Index>
class PointAnswers<T, Index>::Sides {
 public:
  Sides(const PointAnswers& answers, std::span<const Vec3<T>> p)
      : answers_(answers), p_(p), signs_(answers.signs().scheme == SignScheme::WindingNumber) {}

  /// That of point i, which is after those asked for before.
  int of(std::size_t i, const Nearest& nearest) {
    if (signs_ && i >= end_) begin(i);
    if (!least_) return answers_.side(p_[i], nearest);
    const Vec3<double> q(p_[i]);
    const double room = std::sqrt(double{nearest.distanceSquared}) - 2 * double{nearest.error};
    constexpr double kOutward = 1 + 0x1p-48;
    const bool isSame = room > 0 && room_ > 0 && kOutward * length(q - last_) < room + room_;
    if (!isSame) side_ = sideAmong(p_[i], nearest);
    last_ = q;
    room_ = room;
    return side_;
  }

 private:
  /// Points are looked at in long runs, and in short ones where these tell nothing.
  static constexpr std::size_t kLong = 64;
  static constexpr std::size_t kShort = 8;

  void begin(std::size_t i) {
    room_ = 0;
    if (i / kLong != tried_) {
      tried_ = i / kLong;
      look(i, kLong);
      if (least_) return;
    }
    look(i, kShort);
  }
  /// At the run of this length that point i is in.
  void look(std::size_t i, std::size_t length) {
    const auto first = i - i % length;
    end_ = std::min(first + length, p_.size());
    least_ = leastInside(p_.subspan(first, end_ - first));
  }
  [[nodiscard]] std::optional<int> leastInside(std::span<const Vec3<T>> points) const {
    Box<double> box;
    for (const auto& q : points) box.extend(Vec3<double>(q));
    constexpr double kWide = 0.25;  // they tell little of each other
    return box.diagonal() < kWide ? answers_.index_.leastInside(box) : std::nullopt;
  }
  [[nodiscard]] int sideAmong(const Vec3<T>& p, const Nearest& nearest) const {
    if (nearest.distanceSquared > 0) {
      if (const auto beside = answers_.index_.windingBeside(p, nearest)) {
        return *beside >= *least_ ? -1 : 1;
      }
    }
    return answers_.side(p, nearest);
  }

  const PointAnswers& answers_;
  std::span<const Vec3<T>> p_;
  bool signs_;                           // by winding numbers
  std::size_t end_ = 0;                  // of the run
  std::size_t tried_ = ~std::size_t{0};  // the last long run
  std::optional<int> least_;             // of winding numbers inside, in a box around the points
  Vec3<double> last_;                    // the last point,
  double room_ = 0;                      // how far it is from any triangle; 0: there is none
  int side_ = 1;                         // and its side
};

template <std::floating_point T, typename Index>
T PointAnswers<T, Index>::valueAt(const Vec3<T>& point, const Vec3<T>& p, const Nearest& nearest,
                                  int side) const {
  const bool isFar = maxComponent(abs(p)) >= kFarthest;
  if (isFar) return static_cast<T>(side) * std::hypot(point.x, point.y, point.z);
  const T magnitude = std::sqrt(nearest.distanceSquared);
  const T value =
      side < 0 ? -std::max(magnitude, kLeastDepth<T>) : static_cast<T>(side) * magnitude;
  return value / surface().scale;
}

template <std::floating_point T, typename Index>
bool PointAnswers<T, Index>::leavesBox(const Vec3<T>& point, T radius) const {
  const Vec3<T> gap = max(index_.solidBox().lower - point, point - index_.solidBox().upper);
  return maxComponent(gap) + radius >
         4 * surface().error(surface().scale * point) / surface().scale;
}

template <std::floating_point T, typename Index>
T PointAnswers<T, Index>::signedDistanceWithin(const Vec3<T>& point,
                                               const Interval<T>& wanted) const {
  constexpr T kInf = std::numeric_limits<T>::infinity();
  const T radius = std::max(wanted.upper, T(0));
  const Vec3<T> p = scaled(point);
  if (!(radius < kInf) || index_.signJumps() || maxComponent(abs(p)) >= kFarthest ||
      !leavesBox(point, radius)) {
    return signedDistance(point);
  }
  const T reach = surface().scale * radius + 4 * surface().error(p);
  const auto found = index_.nearestWithin(p, double{reach});
  return found.distanceSquared <= reach * reach ? valueAt(point, p, found) : kInf;
}

template <std::floating_point T, typename Index>
template <typename Visit>
void PointAnswers<T, Index>::forNearest(std::span<const Vec3<T>> points, Visit visit) const {
  Scratch<Vec3<T>, kBatch> p;
  Scratch<Nearest, kBatch> nearest;
  for (std::size_t begin = 0; begin < points.size(); begin += kBatch) {
    const auto count = std::min(kBatch, points.size() - begin);
    static_cast<void>(scale(points.subspan(begin, count), p.first(count)));
    index_.nearest(p.first(count), nearest.first(count));
    Sides sides(*this, p.first(count));
    for (std::size_t i = 0; i < count; ++i) {
      visit(begin + i, p[i], nearest[i],
            valueAt(points[begin + i], p[i], nearest[i], sides.of(i, nearest[i])));
    }
  }
}

template <std::floating_point T, typename Index>
void PointAnswers<T, Index>::signedDistances(std::span<const Vec3<T>> points,
                                             std::span<T> distances) const {
  forNearest(points,
             [&](std::size_t i, const Vec3<T>&, const Nearest&, T value) { distances[i] = value; });
}

template <std::floating_point T, typename Index>
bool PointAnswers<T, Index>::signedDistancesWithin(std::span<const Vec3<T>> points, T limit,
                                                   std::span<T> distances) const {
  Scratch<Vec3<T>, kBatch> p;
  Scratch<Nearest, kBatch> nearest;
  for (std::size_t begin = 0; begin < points.size(); begin += kBatch) {
    const auto count = std::min(kBatch, points.size() - begin);
    const Vec3<T> farthest = scale(points.subspan(begin, count), p.first(count));
    const T reach = surface().scale * limit + 4 * surface().error(farthest);
    index_.nearestWithin(p.first(count), nearest.first(count), double{reach});
    Sides sides(*this, p.first(count));
    for (std::size_t i = 0; i < count; ++i) {
      const bool isNear =
          nearest[i].triangle != kNone && nearest[i].distanceSquared <= reach * reach;
      distances[begin + i] =
          isNear ? valueAt(points[begin + i], p[i], nearest[i], sides.of(i, nearest[i]))
                 : std::numeric_limits<T>::quiet_NaN();
    }
  }
  return true;
}

template <std::floating_point T, typename Index>
void PointAnswers<T, Index>::closestPoints(std::span<const Vec3<T>> points,
                                           std::span<SurfacePoint<T>> results) const {
  forNearest(points, [&](std::size_t i, const Vec3<T>& p, const Nearest& nearest, T value) {
    results[i] = closestPointAt(p, nearest, value);
  });
}

template <std::floating_point T, typename Index>
SurfacePoint<T> PointAnswers<T, Index>::closestPointAt(const Vec3<T>& p, const Nearest& nearest,
                                                       T value) const {
  auto result = surface().surfacePoint(p, nearest);
  result.distance = value;
  // Where shells overlap, the nearest triangle need not be part of the solid's surface; and a place
  // where the sign jumps may be nearer than any.
  result.exact = signs().isSound() && nearest.triangle != kNone;
  if (index_.signJumps()) result.tolerance = std::numeric_limits<T>::infinity();
  return result;
}

template <std::floating_point T, typename Index>
Vec3<T> PointAnswers<T, Index>::gradient(const Vec3<T>& point) const {
  const auto hit = closestPoint(point);
  const Vec3<T> away = hit.distance < 0 ? hit.point - point : point - hit.point;
  const T rounding = 2 * surface().error(scaled(point)) / surface().scale;
  // On the surface the direction is lost to rounding; its limit is the pseudonormal.
  return std::abs(hit.distance) > 64 * rounding ? normalized(away) : hit.normal;
}

template <std::floating_point T, typename Index>
Guarantee<T> PointAnswers<T, Index>::guarantee() const {
  auto result = Guarantee<T>::exact(surface().size / surface().scale);
  if (signs().isSound()) return result;
  // The distance to the nearest triangle, whether or not it is on the surface of the union.
  result.outside = result.inside = Quality::LowerBound;
  if (!index_.signJumps()) return result;
  result.outside = result.inside = Quality::SignOnly;
  result.lipschitz.reset();
  result.continuous = false;
  return result;
}

template class PointAnswers<float, MeshIndex<float>>;
template class PointAnswers<double, MeshIndex<double>>;
template class PointAnswers<float, DcelIndex<float>>;
template class PointAnswers<double, DcelIndex<double>>;

}  // namespace cutwater
