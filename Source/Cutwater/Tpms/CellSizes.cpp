#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Tpms/CellSizes.hpp>

#include <algorithm>

namespace cutwater {

namespace {

template <std::floating_point T>
void requireSize(T size) {
  require(size > 0 && std::isfinite(size) && std::isfinite(1 / size),
          "CellSizes: need 0 < size < infinity", Named{"size", size});
}

}  // namespace

template <std::floating_point T>
CellSizes<T>::CellSizes(T size) {
  requireSize(size);
  knots_.push_back({0, 1 / size, 0, 0});
  perLength_ = {1 / size, 1 / size};
}

template <std::floating_point T>
CellSizes<T>::CellSizes(const std::vector<CellSizeAt<T>>& sizes) {
  require(!sizes.empty(), "CellSizes: need a size");
  for (const auto& [place, size] : sizes) {
    requireSize(size);
    require(std::isfinite(place) && (knots_.empty() || place > knots_.back().place),
            "CellSizes: need finite places in ascending order", Named{"place", place});
    Knot knot{place, 1 / size, 0, 0};
    if (knots_.empty()) {
      perLength_ = {knot.perLength, knot.perLength};
    } else {
      auto& last = knots_.back();
      const T length = place - last.place;
      last.slope = (knot.perLength - last.perLength) / length;
      knot.cells = last.cells + length * T(0.5) * (last.perLength + knot.perLength);
      perLength_.lower = std::min(perLength_.lower, knot.perLength);
      perLength_.upper = std::max(perLength_.upper, knot.perLength);
    }
    knots_.push_back(knot);
  }
}

template <std::floating_point T>
auto CellSizes<T>::knotBefore(T x) const -> const Knot& {
  const auto after = std::upper_bound(knots_.begin() + 1, knots_.end(), x,
                                      [](T place, const Knot& knot) { return place < knot.place; });
  return *(after - 1);
}

template <std::floating_point T>
T CellSizes<T>::cellsUpTo(T x) const {
  if (isConstant()) return (x - knots_[0].place) * knots_[0].perLength;
  const auto& knot = knotBefore(x);
  const T beyond = x - knot.place;
  const T slope = beyond < 0 ? T(0) : knot.slope;
  return knot.cells + beyond * (knot.perLength + T(0.5) * slope * beyond);
}

template <std::floating_point T>
T CellSizes<T>::perLengthAt(T x) const {
  const auto& knot = knotBefore(x);
  return x < knot.place ? knot.perLength : knot.perLength + knot.slope * (x - knot.place);
}

template <std::floating_point T>
T CellSizes<T>::mostPerLength(const Interval<T>& places) const {
  constexpr T kOutward = 1 + 8 * std::numeric_limits<T>::epsilon();
  if (isConstant()) return perLength_.upper;
  // Linear between knots, so the most is at a knot or an end.
  T most = std::max(perLengthAt(places.lower), perLengthAt(places.upper));
  for (const auto& knot : knots_) {
    if (places.contains(knot.place)) most = std::max(most, knot.perLength);
  }
  return std::min(most, perLength_.upper) * kOutward;
}

template <std::floating_point T>
T CellSizes<T>::reach() const {
  return std::max(std::abs(knots_.front().place), std::abs(knots_.back().place));
}

template class CellSizes<float>;
template class CellSizes<double>;

}  // namespace cutwater
