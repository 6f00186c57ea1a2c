#pragma once

#include <Cutwater/Lattice/BeamGraph.hpp>
#include <Cutwater/Shapes/Detail/Profiles.hpp>

namespace cutwater::detail {

/// Signed distance in the half-plane of a frustum with caps: see BeamCap.
///
/// A half ball meets the frustum in a disc that is not part of the surface, so distances are those
/// to the remaining sides: exact. A whole ball is united with these by the least value: exact
/// outside, and a lower bound inside where the ball bulges out of the frustum.
template <std::floating_point T>
class CappedFrustumProfile {
 public:
  CappedFrustumProfile(const FrustumProfile<T>& frustum, const std::array<BeamCap, 2>& caps)
      : frustum_(frustum), caps_(caps) {}

  [[nodiscard]] T distance(const ProfilePoint<T>& p) const { return nearestSide(p).distance; }
  [[nodiscard]] ProfilePoint<T> gradient(const ProfilePoint<T>& p) const;
  /// Box around the body of revolution, as computed.
  [[nodiscard]] Box<T> box(const RotationAxis<T>& axis) const;
  [[nodiscard]] T largestRadius() const { return frustum_.largestRadius(); }

 private:
  enum class Side { Flank, RimA, RimB, FlatA, FlatB, RoundA, RoundB };
  struct Nearest {
    T distance;
    Side side;
  };
  [[nodiscard]] Nearest nearestSide(const ProfilePoint<T>& p) const;
  /// The nearest side, without whole balls; its distance is unsigned.
  [[nodiscard]] Nearest nearestBoundary(const ProfilePoint<T>& p) const;
  [[nodiscard]] bool isInside(const ProfilePoint<T>& p) const;

  [[nodiscard]] ProfilePoint<T> fromB(const ProfilePoint<T>& p) const {
    return {p.radial, p.axial - frustum_.height()};
  }
  [[nodiscard]] bool isRoundA() const { return caps_[0] != BeamCap::Butt; }
  [[nodiscard]] bool isRoundB() const { return caps_[1] != BeamCap::Butt; }

  FrustumProfile<T> frustum_;
  std::array<BeamCap, 2> caps_;
};

extern template class CappedFrustumProfile<float>;
extern template class CappedFrustumProfile<double>;

}  // namespace cutwater::detail
