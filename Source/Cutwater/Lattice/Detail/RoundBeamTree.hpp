#pragma once

#include <Cutwater/Lattice/Detail/BeamPackets.hpp>

#include <algorithm>

namespace cutwater::detail {

/// Cone-spheres in a tree with packets of 16 in its leaves. It gives the results of LinearBVH, to
/// the bit, in less time.
template <std::floating_point T>
class RoundBeamTree {
 public:
  /// @throws Error if a bounding box is not finite; Error(Limit) beyond 2^32 - 2 beams.
  explicit RoundBeamTree(std::vector<ConeSphereBeam<T>> beams);

  /// The beam with the least value at `point`, which must be finite; the first one where values
  /// tie. Only values not above `limit` count.
  [[nodiscard]] NearestPrimitive<T> nearest(const Vec3<T>& point, T limit) const;

  /// Calls visit(index) for beams in leaves whose boxes meet `box`, until it returns false.
  template <typename Visit>
  void overlapping(const Box<T>& box, const Visit& visit) const {
    const Box<double> query{Vec3<double>(box.lower), Vec3<double>(box.upper)};
    const auto each = [&](std::uint32_t id) { return id == kNone || visit(id); };
    arrays_.tree().overlapping(
        OrientedBox<double>::of(query),
        [&](std::span<const std::uint32_t> slots) { return std::ranges::all_of(slots, each); });
  }

  [[nodiscard]] const std::vector<ConeSphereBeam<T>>& primitives() const { return beams_; }

 private:
  class Search;

  std::vector<ConeSphereBeam<T>> beams_;
  BeamBvhArrays arrays_;
  std::vector<BeamPacket> packets_;
  double size_ = 0;  // of the largest beam
};

extern template class RoundBeamTree<float>;
extern template class RoundBeamTree<double>;

}  // namespace cutwater::detail
