#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Core/Segment.hpp>
#include <Cutwater/Triangles/Search/TriangleTree.hpp>
#include <Cutwater/Triangles/TriangleSurface.hpp>

#include <optional>

namespace cutwater {

/// The winding number of a surface, and of the caps over its holes if it is open, in front of its
/// triangles. From there it is known at any point that has such a triangle nearest, without a way
/// out of the surface.
///
/// Just in front of triangles that are clear it is the same all over them, and behind them it is
/// one more. They have nothing but their neighbours around: each corner has one ring of triangles,
/// turned alike, and neither these nor the triangle itself meet other triangles or caps anywhere,
/// or come within kClearance of them. Let c be the point of such a triangle that is nearest to a
/// point p. What the segment from p to c passes through is no farther than the nearest triangle
/// within rounding, so it is within twice the error of c, and among these neighbours; and it is
/// among the triangles whose side Nearest::agreedSide() tells, like this one: p is on the same side
/// of all of them. Around c the neighbours have two sides, so passages alternate in direction; in
/// one direction only, there is no more than one, and not even that, as it would lead to the other
/// side.
///
/// Of other triangles, it is known at one point in front of them, from which passages are counted.
///
/// A view of an array: a byte for each triangle.
class FrontWindings {
 public:
  /// As sheets may be closer to each other than rounding, in the units of the surface.
  template <std::floating_point T>
  static constexpr double kClearance = 1024 * std::numeric_limits<T>::epsilon();

  /// Winding numbers of up to kMost, either way, have a byte.
  static constexpr int kMost = 63;
  [[nodiscard]] static std::uint8_t byteOf(int winding, bool isClear) {
    return static_cast<std::uint8_t>(2 * (winding + kMost + 1) + (isClear ? 1 : 0));
  }

  FrontWindings() = default;
  explicit FrontWindings(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  /// At a point, if the nearest triangle is clear, and tells.
  template <typename Nearest>
  [[nodiscard]] std::optional<int> beside(const Nearest& nearest) const {
    const auto byte = byteAt(nearest.triangle);
    const int side = byte % 2 != 0 ? nearest.agreedSide() : 0;
    constexpr int kErrors = 8;  // two would do, and rounding
    using T = std::remove_cvref_t<decltype(nearest.error)>;
    if (side == 0 || kErrors * double{nearest.error} > kClearance<T>) return {};
    return windingOf(byte) + (side < 0 ? 1 : 0);
  }
  /// At the point in front of a triangle that is not clear.
  [[nodiscard]] std::optional<int> before(std::uint32_t triangle) const {
    const auto byte = byteAt(triangle);
    return byte == 0 || byte % 2 != 0 ? std::nullopt : std::optional(windingOf(byte));
  }
  /// That point.
  [[nodiscard]] static Vec3<double> pointBefore(const std::array<Vec3<double>, 3>& corners);

 private:
  /// 0: nothing is known.
  [[nodiscard]] std::uint8_t byteAt(std::uint32_t triangle) const {
    return bytes_.empty() || triangle == kNone ? std::uint8_t{0} : bytes_[triangle];
  }
  [[nodiscard]] static int windingOf(std::uint8_t byte) { return byte / 2 - (kMost + 1); }

  std::span<const std::uint8_t> bytes_;
};

/// What findFrontWindings() asks.
template <std::floating_point T>
struct FrontQueries {
  FunctionRef<typename TriangleSurface<T>::Nearest(const Vec3<T>&)> nearest;
  // Of the surface and its caps, exact: the winding number at a point, and by how much it exceeds
  // that at the end of a segment at its start.
  FunctionRef<int(const Vec3<double>&)> winding;
  FunctionRef<int(const Segment<double>&)> windingAlong;
};

/// The array of a FrontWindings. `tree`: of the surface, for its grouping alone. `caps`: over its
/// holes, without if it is closed.
template <std::floating_point T>
[[nodiscard]] std::vector<std::uint8_t> findFrontWindings(const TriangleSurface<T>& surface,
                                                          const TriangleTree& tree,
                                                          const TriangleSurface<double>& caps,
                                                          const FrontQueries<T>& queries);

extern template std::vector<std::uint8_t> findFrontWindings(const TriangleSurface<float>&,
                                                            const TriangleTree&,
                                                            const TriangleSurface<double>&,
                                                            const FrontQueries<float>&);
extern template std::vector<std::uint8_t> findFrontWindings(const TriangleSurface<double>&,
                                                            const TriangleTree&,
                                                            const TriangleSurface<double>&,
                                                            const FrontQueries<double>&);

}  // namespace cutwater
