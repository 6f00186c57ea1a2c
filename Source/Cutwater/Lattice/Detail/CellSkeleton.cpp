#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Lattice/Detail/CellSkeleton.hpp>

namespace cutwater::detail {

namespace {

template <std::floating_point T>
const Repeats<T>& checked(const Repeats<T>& cells) {
  // Well within these limits, squares of lengths neither overflow nor underflow.
  constexpr bool kIsFloat = sizeof(T) == sizeof(float);
  constexpr T kLargest = kIsFloat ? T(1e15) : T(1e100);
  for (int axis = 0; axis < 3; ++axis) {
    const T size = cells.period[axis];
    require(1 / kLargest <= size && size <= kLargest,
            kIsFloat ? "lattice: need sizes of cells from 1e-15 to 1e15"
                     : "lattice: need sizes of cells from 1e-100 to 1e100",
            Named{"axis", axis}, Named{"size", size});
  }
  constexpr std::uint32_t kMost = 1U << 20;  // cells can still be told apart in single precision
  for (const auto count : cells.count) {
    if (count <= kMost) continue;
    throw Error(ErrorKind::Limit, "lattice: need at most 2^20 cells along an axis");
  }
  return cells;
}

}  // namespace

template <std::floating_point T>
CellSkeleton<T>::CellSkeleton(const UnitCell& cell, const Repeats<T>& cells)
    : cells_(checked(cells)),
      isEndless_(cells.count == std::array<std::uint32_t, 3>{}),
      searched_(cell, cells),
      clearance_(clearance(cell)) {
  const auto fold = cell.foldAt(Vec3<double>(cells.period));
  std::uint32_t most = 2;
  for (const auto count : cells.count) most = std::max(most, count);
  const T rounding = 16 * std::numeric_limits<T>::epsilon() * static_cast<T>(most);
  if (fold != CellFold::None && (isEndless() || clearance_ > rounding)) {
    folded_.emplace(cell, fold, cells.period);
  }
}

template <std::floating_point T>
T CellSkeleton<T>::clearance(const UnitCell& cell) {
  double least = 0.5;
  for (const auto& strut : cell.struts()) {
    const auto middle = strut.middle();
    for (int axis = 0; axis < 3; ++axis) {
      const double x = std::abs(middle[axis]);
      if (x > UnitCell::kSame) least = std::min({least, x, 1 - x});
    }
  }
  return static_cast<T>(0.5 * least);
}

template <std::floating_point T>
bool CellSkeleton<T>::contains(const Vec3<T>& middle) const {
  for (int axis = 0; axis < 3; ++axis) {
    const auto count = cells_.count[static_cast<std::size_t>(axis)];
    const T x = middle[axis] / cells_.period[axis];
    if (count > 0 && !(-clearance_ < x && x < static_cast<T>(count) + clearance_)) return false;
  }
  return true;
}

template <std::floating_point T>
T CellSkeleton<T>::distance(const Vec3<T>& p) const {
  return folded_ && isEndless() ? folded_->distance(p) : nearest(p).distance;
}

template <std::floating_point T>
void CellSkeleton<T>::distances(std::span<const Vec3<T>> points, std::span<T> distances) const {
  if (folded_ && isEndless()) {
    folded_->distances(points, distances);
  } else {
    for (std::size_t i = 0; i < points.size(); ++i) distances[i] = nearest(points[i]).distance;
  }
}

template <std::floating_point T>
SkeletonPoint<T> CellSkeleton<T>::nearest(const Vec3<T>& p) const {
  if (folded_) {
    const auto found = folded_->nearest(p);
    if (isEndless() || contains(found.middle)) return found;
  }
  return searched_.nearest(p);
}

template class CellSkeleton<float>;
template class CellSkeleton<double>;

}  // namespace cutwater::detail
