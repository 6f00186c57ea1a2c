#include <Cutwater/Lattice/Detail/CappedFrustumProfile.hpp>

namespace cutwater::detail {

template <std::floating_point T>
auto CappedFrustumProfile<T>::nearestBoundary(const ProfilePoint<T>& p) const -> Nearest {
  const auto& f = frustum_;
  Nearest best{std::abs(f.flankDistance(p)), Side::Flank};
  const auto offer = [&](T distance, Side side) {
    if (distance < best.distance) best = {distance, side};
  };
  if (!f.hasFootOnFlank(p)) {
    best = {length(ProfilePoint<T>{p.radial - f.radiusA(), p.axial}), Side::RimA};
    offer(length(ProfilePoint<T>{p.radial - f.radiusB(), fromB(p).axial}), Side::RimB);
  }
  // Seen from the other side, the nearest point of a half circle is its end: a rim.
  if (!isRoundA()) {
    offer(length(f.fromDiscA(p)), Side::FlatA);
  } else if (p.axial < 0) {
    offer(std::abs(length(p) - f.radiusA()), Side::RoundA);
  }
  if (!isRoundB()) {
    offer(length(f.fromDiscB(p)), Side::FlatB);
  } else if (p.axial > f.height()) {
    offer(std::abs(length(fromB(p)) - f.radiusB()), Side::RoundB);
  }
  return best;
}

template <std::floating_point T>
bool CappedFrustumProfile<T>::isInside(const ProfilePoint<T>& p) const {
  if (p.axial < 0) return isRoundA() && length(p) < frustum_.radiusA();
  if (p.axial > frustum_.height()) return isRoundB() && length(fromB(p)) < frustum_.radiusB();
  return frustum_.flankDistance(p) < 0;
}

template <std::floating_point T>
auto CappedFrustumProfile<T>::nearestSide(const ProfilePoint<T>& p) const -> Nearest {
  auto best = nearestBoundary(p);
  if (isInside(p)) best.distance = -best.distance;
  const auto unite = [&](T distance, Side side) {
    if (distance < best.distance) best = {distance, side};
  };
  if (caps_[0] == BeamCap::Sphere) unite(length(p) - frustum_.radiusA(), Side::RoundA);
  if (caps_[1] == BeamCap::Sphere) unite(length(fromB(p)) - frustum_.radiusB(), Side::RoundB);
  return best;
}

template <std::floating_point T>
ProfilePoint<T> CappedFrustumProfile<T>::gradient(const ProfilePoint<T>& p) const {
  const auto [distance, side] = nearestSide(p);
  // Away from the nearest point, or towards it from inside.
  const auto awayFrom = [side = distance < 0 ? T(-1) : T(1)](const ProfilePoint<T>& from) {
    const auto unit = normalized(from);
    return ProfilePoint<T>{side * unit.radial, side * unit.axial};
  };
  switch (side) {
    case Side::Flank:
      return frustum_.flankNormal();
    case Side::RimA:
      return awayFrom({p.radial - frustum_.radiusA(), p.axial});
    case Side::RimB:
      return awayFrom({p.radial - frustum_.radiusB(), fromB(p).axial});
    case Side::FlatA:
      return p.radial <= frustum_.radiusA() ? ProfilePoint<T>{0, -1}
                                            : awayFrom(frustum_.fromDiscA(p));
    case Side::FlatB:
      return p.radial <= frustum_.radiusB() ? ProfilePoint<T>{0, 1}
                                            : awayFrom(frustum_.fromDiscB(p));
    case Side::RoundA:
      return normalized(p);
    default:
      return normalized(fromB(p));
  }
}

template <std::floating_point T>
Box<T> CappedFrustumProfile<T>::box(const RotationAxis<T>& axis) const {
  auto box = frustum_.box(axis);
  if (isRoundA()) box.extend(axis.ballBox(0, frustum_.radiusA()));
  if (isRoundB()) box.extend(axis.ballBox(frustum_.height(), frustum_.radiusB()));
  return box;
}

template class CappedFrustumProfile<float>;
template class CappedFrustumProfile<double>;

}  // namespace cutwater::detail
