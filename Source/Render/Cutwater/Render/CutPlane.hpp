#pragma once

#include <Cutwater/Render/Camera.hpp>

#include <limits>
#include <span>
#include <vector>

namespace cutwater {

/// A plane that removes a part of the scene: where dot(normal, p) > offset.
struct CutPlane {
  Vec3<double> normal;  ///< unit
  double offset;

  /// The side that is kept.
  enum class Keep : std::uint8_t { Lower, Upper };

  /// Keeps the part with the lower or the upper values of coordinate `axis` (0, 1 or 2).
  /// @throws Error unless the axis is 0, 1 or 2 and the value finite.
  static CutPlane across(int axis, double value, Keep keep = Keep::Lower);
  /// A plane through a point that removes the side towards which `removed`, of any length, points.
  /// @throws Error unless both are finite and `removed` not zero.
  static CutPlane through(const Vec3<double>& point, const Vec3<double>& removed);

  /// Distance of the point beyond the plane; negative in the part that is kept.
  [[nodiscard]] double beyond(const Vec3<double>& p) const { return dot(normal, p) - offset; }
};

namespace detail {

/// The part of a ray on which anything may be seen.
struct RayRange {
  double begin;
  double end;                 ///< less than `begin` if the part is empty
  std::uint32_t cut = kNone;  ///< the cut plane through which the ray enters, if any

  [[nodiscard]] bool empty() const { return !(begin < end); }
};

/// The part of a box that cut planes leave.
class KeptRegion {
 public:
  /// `cutsAtBox`: the sides of the box are cut planes, too.
  KeptRegion(const Box<double>& box, std::span<const CutPlane> cuts, bool cutsAtBox);

  [[nodiscard]] const Box<double>& box() const { return box_; }
  /// The box without the parts that planes across the coordinate axes remove.
  [[nodiscard]] Box<double> rest() const;
  [[nodiscard]] RayRange clip(const Ray& ray, double nearest) const;
  [[nodiscard]] const Vec3<double>& normal(std::uint32_t cut) const { return cuts_[cut].normal; }
  /// A lower bound on the distance to the kept part: 0 within it.
  [[nodiscard]] double clearance(const Vec3<double>& p) const;

 private:
  Box<double> box_;
  std::vector<CutPlane> cuts_;
  std::vector<CutPlane> sides_;  // they only bound the region to search
};

}  // namespace detail

}  // namespace cutwater
