#include <Cutwater/Lattice/Detail/CellMirrors.hpp>
#include <Cutwater/Lattice/Detail/FoldedCells.hpp>

#include <type_traits>

namespace cutwater::detail {

namespace {

/// A point in the chamber, and how it got there: point[i] was a size along the axis from[i].
template <typename T>
struct Folded {
  Vec3<T> point;
  Vec3<T> origin;  // the image of the chamber's origin, in units of the period
  Vec3<T> side{1, 1, 1};
  std::array<int, 3> from{0, 1, 2};

  /// Converts a direction in the chamber to one outside it.
  [[nodiscard]] CUTWATER_INLINE Vec3<T> unfolded(const Vec3<T>& inside) const {
    Vec3<T> out;
    for (int i = 0; i < 3; ++i) {
      const int axis = from[static_cast<std::size_t>(i)];
      out[axis] = side[axis] * inside[i];
    }
    return out;
  }
};

/// The nearest whole number; the even one if two are. Numbers so large that neighbours are more
/// than 1/4 apart count as whole.
template <typename T>
CUTWATER_INLINE inline T rounded(T x) {
  // Adding it shifts out all digits after the point.
  constexpr T kShift = T(1.5) / std::numeric_limits<T>::epsilon();
  constexpr T kLargest = T(0.25) / std::numeric_limits<T>::epsilon();
  const T whole = (x + kShift) - kShift;
  return (x < 0 ? -x : x) < kLargest ? whole : x;
}

template <typename T>
CUTWATER_INLINE inline bool isOdd(T whole) {
  const T half = T(0.5) * whole;
  return half != rounded(half);
}

/// The difference of each coordinate; never infinity minus infinity.
template <typename T>
CUTWATER_INLINE inline Vec3<T> difference(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.x == b.x ? T(0) : a.x - b.x, a.y == b.y ? T(0) : a.y - b.y,
          a.z == b.z ? T(0) : a.z - b.z};
}

/// A point of a lattice, and another point relative to it.
template <typename T>
struct Place {
  Vec3<T> origin;
  Vec3<T> rest;
};

template <typename T>
CUTWATER_INLINE inline Place<T> fromNearestWhole(const Vec3<T>& u) {
  const Vec3<T> whole{rounded(u.x), rounded(u.y), rounded(u.z)};
  return {whole, difference(u, whole)};
}

/// u, relative to the nearest point of the face-centred lattice, i.e. of whole numbers with an even
/// sum, in units of 1/2. If the nearest whole numbers have an odd sum, the one that was rounded
/// most is rounded the other way (Conway and Sloane 1982, "Fast quantizing and decoding algorithms
/// for lattice quantizers and codes": D_n).
template <typename T>
CUTWATER_INLINE inline Place<T> fromNearestFaceCentred(const Vec3<T>& u) {
  auto [whole, rest] = fromNearestWhole(T(2) * u);
  const bool isWrong = isOdd(whole.x) != (isOdd(whole.y) != isOdd(whole.z));
  const auto size = abs(rest);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  for (int i = 0; i < 3; ++i) {
    const T step = isWrong && i == axis ? (rest[i] < 0 ? T(-1) : T(1)) : T(0);
    whole[i] += step;
    rest[i] -= step;
  }
  return {T(0.5) * whole, T(0.5) * rest};
}

/// Without branches, which processors could not predict.
template <typename T>
CUTWATER_INLINE inline void sort(Folded<T>& folded, int i, int j) {
  auto& p = folded.point;
  auto& from = folded.from;
  const T a = p[i];
  const T b = p[j];
  const int fromA = from[static_cast<std::size_t>(i)];
  const int fromB = from[static_cast<std::size_t>(j)];
  p[i] = std::max(a, b);
  p[j] = std::min(a, b);
  from[static_cast<std::size_t>(i)] = a < b ? fromB : fromA;
  from[static_cast<std::size_t>(j)] = a < b ? fromA : fromB;
}

template <CellFold kFold, typename T>
CUTWATER_INLINE inline Folded<T> folded(const Vec3<T>& p, const Vec3<T>& period,
                                        const Vec3<T>& perPeriod) {
  constexpr bool kIsFcc = kFold == CellFold::Fcc;
  const Vec3<T> u = times(p, perPeriod);
  Folded<T> result;
  const auto place = kIsFcc ? fromNearestFaceCentred(u) : fromNearestWhole(u);
  const Vec3<T> rest = times(place.rest, period);
  result.origin = place.origin;
  for (int axis = 0; axis < 3; ++axis) result.side[axis] = rest[axis] < 0 ? T(-1) : T(1);
  result.point = abs(rest);
  if constexpr (kFold != CellFold::Octant) sort(result, 0, 1);
  if constexpr (kFold == CellFold::Sort || kIsFcc) {
    sort(result, 1, 2);
    sort(result, 0, 1);
  }
  if constexpr (kIsFcc) {
    // Only even numbers of signs change; the last coordinate, which is the least, keeps its own.
    const T parity = result.side.x * result.side.y * result.side.z;
    result.point.z *= parity;
    result.side[result.from[2]] *= parity;
  }
  return result;
}

template <CellFold kFold>
using FoldType = std::integral_constant<CellFold, kFold>;

}  // namespace

template <std::floating_point T>
FoldedCells<T>::FoldedCells(const UnitCell& cell, CellFold fold, const Vec3<T>& period)
    : fold_(fold), period_(period), perPeriod_{1 / period.x, 1 / period.y, 1 / period.z} {
  const Vec3<double> size(period);
  for (const auto& [part, strut, middle] : strutsInChamber(cell.struts(), fold)) {
    struts_.push_back({StrutAxis<T>(times(size, part.a), times(size, part.b)), strut,
                       Vec3<T>(times(size, middle))});
  }
}

template <std::floating_point T>
inline auto FoldedCells<T>::leastInChamber(const Vec3<T>& p) const -> Found {
  Found best{std::numeric_limits<T>::infinity(), &struts_.front()};
  for (const auto& strut : struts_) {
    const T squared = lengthSquared(strut.axis.awayFrom(p));
    if (squared < best.squared) best = {squared, &strut};
  }
  return best;
}

template <std::floating_point T>
template <typename Answer>
auto FoldedCells<T>::withFold(Answer&& answer) const {
  switch (fold_) {
    case CellFold::SortXY:
      return answer(FoldType<CellFold::SortXY>());
    case CellFold::Sort:
      return answer(FoldType<CellFold::Sort>());
    case CellFold::Fcc:
      return answer(FoldType<CellFold::Fcc>());
    default:
      return answer(FoldType<CellFold::Octant>());
  }
}

template <std::floating_point T>
T FoldedCells<T>::distance(const Vec3<T>& p) const {
  return withFold([&](auto fold) {
    return std::sqrt(leastInChamber(folded<fold()>(p, period_, perPeriod_).point).squared);
  });
}

template <std::floating_point T>
void FoldedCells<T>::distances(std::span<const Vec3<T>> points, std::span<T> distances) const {
  withFold([&](auto fold) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto inside = folded<fold()>(points[i], period_, perPeriod_).point;
      distances[i] = std::sqrt(leastInChamber(inside).squared);
    }
  });
}

template <std::floating_point T>
SkeletonPoint<T> FoldedCells<T>::nearest(const Vec3<T>& p) const {
  return withFold([&](auto fold) -> SkeletonPoint<T> {
    const auto inside = folded<fold()>(p, period_, perPeriod_);
    const auto found = leastInChamber(inside.point);
    const auto& [axis, strut, middle] = *found.strut;
    return {std::sqrt(found.squared), inside.unfolded(axis.awayFrom(inside.point)), strut,
            times(inside.origin, period_) + inside.unfolded(middle)};
  });
}

template class FoldedCells<float>;
template class FoldedCells<double>;

}  // namespace cutwater::detail
