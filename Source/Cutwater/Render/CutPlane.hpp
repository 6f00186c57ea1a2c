#pragma once

#include <Cutwater/Render/Camera.hpp>

#include <limits>
#include <span>
#include <vector>

namespace cutwater {

/// A plane that takes away a part of what is shown: where dot(normal, p) > offset.
struct CutPlane {
  Vec3<double> normal;  ///< unit
  double offset;

  /// The side that stays.
  enum class Keep : std::uint8_t { Lower, Upper };

  /// Keeps what has the lower or the upper values of coordinate `axis` (0, 1 or 2).
  /// @throws Error unless the axis is 0, 1 or 2 and the value finite.
  static CutPlane across(int axis, double value, Keep keep = Keep::Lower);
  /// Through a point; takes away what lies in the direction of `removed`, of any length.
  /// @throws Error unless both are finite and `removed` not zero.
  static CutPlane through(const Vec3<double>& point, const Vec3<double>& removed);

  /// How far the point is beyond the plane; negative in the part that is kept.
  [[nodiscard]] double beyond(const Vec3<double>& p) const { return dot(normal, p) - offset; }
};

namespace detail {

/// The part of a ray that may see something.
struct RayRange {
  double begin;
  double end;                 ///< less than `begin` if there is none
  std::uint32_t cut = kNone;  ///< the plane through which it comes in, if it is one that cuts

  [[nodiscard]] bool empty() const { return !(begin < end); }
};

/// What cut planes leave of a box.
class KeptRegion {
 public:
  /// `cutsAtBox`: the sides of the box cut, too.
  KeptRegion(const Box<double>& box, std::span<const CutPlane> cuts, bool cutsAtBox);

  [[nodiscard]] const Box<double>& box() const { return box_; }
  /// The box without what planes across the coordinate axes take away.
  [[nodiscard]] Box<double> rest() const;
  [[nodiscard]] RayRange clip(const Ray& ray, double nearest) const;
  [[nodiscard]] const Vec3<double>& normal(std::uint32_t cut) const { return cuts_[cut].normal; }
  /// A bound of the distance to what is kept: 0 within.
  [[nodiscard]] double clearance(const Vec3<double>& p) const;

 private:
  Box<double> box_;
  std::vector<CutPlane> cuts_;
  std::vector<CutPlane> sides_;  // that only end what is to be looked at
};

}  // namespace detail

}  // namespace cutwater
