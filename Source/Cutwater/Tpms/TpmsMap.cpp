#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Tpms/Detail/Constants.hpp>
#include <Cutwater/Tpms/TpmsMap.hpp>

#include <algorithm>

namespace cutwater {

using detail::kOutward;
using detail::kTwoPi;

template <std::floating_point T>
TpmsMap<T>::TpmsMap(T cellSize) : along_{cellSize, cellSize, cellSize} {}

template <std::floating_point T>
TpmsMap<T>::TpmsMap(const Vec3<T>& cellSize) : along_{cellSize.x, cellSize.y, cellSize.z} {}

template <std::floating_point T>
TpmsMap<T>::TpmsMap(std::array<CellSizes<T>, 3> sizes) : along_(std::move(sizes)) {}

template <std::floating_point T>
TpmsMap<T> TpmsMap<T>::cylindrical(const CylindricalCells<T>& cells) {
  constexpr int kMost = 1 << 20;
  require(cells.cellsPerTurn >= 1 && cells.cellsPerTurn <= kMost,
          "TpmsMap: need 1 to 2^20 whole cells per turn",
          Named{"cellsPerTurn", cells.cellsPerTurn});
  require(std::isfinite(cells.turnsPerLength), "TpmsMap: need a finite number of turns per length",
          Named{"turnsPerLength", cells.turnsPerLength});
  TpmsMap result(std::array<CellSizes<T>, 3>{cells.radialSize, T(1), cells.axialSize});
  result.cellsPerTurn_ = cells.cellsPerTurn;
  result.turnsPerLength_ = cells.turnsPerLength;
  return result;
}

template <std::floating_point T>
TpmsMap<T> TpmsMap<T>::deformed(const DeformationField<T>& field) const {
  field.check();
  require(!deformation_, "TpmsMap: is deformed already");
  TpmsMap result = *this;
  result.deformation_ = field;
  return result;
}

template <std::floating_point T>
Vec3<T> TpmsMap<T>::undeformed(const Vec3<T>& p) const {
  if (cellsPerTurn_ == 0) {
    return {along_[0].cellsUpTo(p.x), along_[1].cellsUpTo(p.y), along_[2].cellsUpTo(p.z)};
  }
  const T radius = std::sqrt(p.x * p.x + p.y * p.y);
  const T turns = std::atan2(p.y, p.x) / kTwoPi<T> + turnsPerLength_ * p.z;
  return {along_[0].cellsUpTo(radius), static_cast<T>(cellsPerTurn_) * turns,
          along_[2].cellsUpTo(p.z)};
}

template <std::floating_point T>
Vec3<T> TpmsMap<T>::toCells(const Vec3<T>& p) const {
  return undeformed(deformation_ ? p + deformation_->shiftAt(p) : p);
}

template <std::floating_point T>
T TpmsMap<T>::lipschitzWithin(const Vec3<T>& center, T radius, T lipschitz, T along) const {
  if (!deformation_) return kTwoPi<T> * undeformedRateWithin(center, radius, lipschitz, along);
  // The ball's image lies in a ball about its centre's image, larger by this factor.
  const T stretch = (1 + deformation_->lipschitz()) * kOutward<T>;
  const auto image = center + deformation_->shiftAt(center);
  return kTwoPi<T> * stretch * undeformedRateWithin(image, stretch * radius, lipschitz, along);
}

template <std::floating_point T>
T TpmsMap<T>::undeformedRateWithin(const Vec3<T>& center, T radius, T lipschitz, T along) const {
  const auto most = [&](int axis, T place) {
    return along_[static_cast<std::size_t>(axis)].mostPerLength({place - radius, place + radius});
  };
  if (cellsPerTurn_ == 0) {
    const Vec3<T> rates{most(0, center.x), most(1, center.y), most(2, center.z)};
    return std::min(lipschitz * maxComponent(rates), along * length(rates)) * kOutward<T>;
  }
  const T toAxis = std::sqrt(center.x * center.x + center.y * center.y);
  const T nearest = toAxis - radius;
  if (!(nearest > 0)) return std::numeric_limits<T>::infinity();
  // The largest singular value of the derivatives of (phi, z): [[a, b], [0, c]], in cells.
  const T n = static_cast<T>(cellsPerTurn_);
  const T a = n / (kTwoPi<T> * nearest);
  const T b = n * std::abs(turnsPerLength_);
  const T c = most(2, center.z);
  const T sum = a * a + b * b + c * c;
  const T under =
      std::max((a * a - c * c) * (a * a - c * c) + b * b * (2 * (a * a + c * c) + b * b), T(0));
  const T around = std::sqrt(T(0.5) * (sum + std::sqrt(under)));
  return lipschitz * std::max(most(0, toAxis), around) * kOutward<T>;
}

template <std::floating_point T>
std::optional<Vec3<T>> TpmsMap<T>::constantRates() const {
  if (cellsPerTurn_ != 0 || deformation_) return {};
  for (const auto& sizes : along_) {
    if (!sizes.isConstant()) return {};
  }
  return Vec3<T>{along_[0].perLength().upper, along_[1].perLength().upper,
                 along_[2].perLength().upper};
}

template <std::floating_point T>
T TpmsMap<T>::ulps() const {
  T ratio = 1;
  for (const auto& sizes : along_) {
    ratio = std::max(ratio, sizes.perLength().upper / sizes.perLength().lower);
  }
  return 4 * ratio * (deformation_ ? 2 * (1 + deformation_->lipschitz()) : T(1));
}

template <std::floating_point T>
T TpmsMap<T>::size() const {
  T size = deformation_ ? 8 * deformation_->amplitude : T(0);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (axis == 1 && cellsPerTurn_ != 0) continue;
    size = std::max(size, along_[axis].reach() + 1 / along_[axis].perLength().lower);
  }
  return size;
}

template class TpmsMap<float>;
template class TpmsMap<double>;

}  // namespace cutwater
