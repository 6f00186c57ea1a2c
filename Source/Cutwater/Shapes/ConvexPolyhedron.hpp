#pragma once

#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <vector>

namespace cutwater {

/// All points p with normal . (p - point) <= 0. The normal points outwards and has any length.
template <std::floating_point T>
struct HalfSpace {
  Vec3<T> point;
  Vec3<T> normal;
};

/// A convex solid: the intersection of half-spaces.
///
/// Exact: inside, the nearest plane decides. Outside, the nearest surface point lies on a face
/// whose plane the point is in front of. It is the foot of the perpendicular on that plane, or lies
/// on a side of the face that the foot is beyond. Faces are found once, in twice the precision;
/// half-spaces without a face then cost nothing. A query takes time linear in the number of faces:
/// use a MeshSDF for thousands.
/// @throws Error unless all are finite, no normal is zero, and the intersection has an interior and
/// reaches no farther than 2^30 times the largest coordinate of the points.
template <std::floating_point T>
class ConvexPolyhedron final : public SignedDistanceFunction<T> {
 public:
  explicit ConvexPolyhedron(const std::vector<HalfSpace<T>>& halfSpaces);

  /// The number of faces, at most that of half-spaces.
  [[nodiscard]] std::size_t faceCount() const { return faces_.size(); }

 private:
  std::string localName() const override { return "Convex polyhedron"; }
  T localSignedDistance(const Vec3<T>& p) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  bool localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const override;
  Guarantee<T> localGuarantee() const override;
  std::optional<T> localConcavity(const OrientedBox<T>&) const override { return T(0); }
  Box<T> localBoundingBox() const override;

  struct Face {
    Vec3<T> normal;
    std::uint32_t first;  // of its sides; `last` is one past the end
    std::uint32_t last;
  };
  struct Side {
    Vec3<T> start;
    Vec3<T> along;    // unit vectors in the face's plane: along the side, counterclockwise,
    Vec3<T> outward;  // and out of the face
    T length;
  };
  /// Height above the plane of the face, positive outside.
  [[nodiscard]] T height(const Face& face, const Vec3<T>& p) const;
  /// The vector from the face's nearest point to p, for a point in front of the face.
  [[nodiscard]] Vec3<T> fromFace(const Face& face, const Vec3<T>& p) const;
  [[nodiscard]] Vec3<T> fromSurface(const Vec3<T>& p) const;

  std::vector<Face> faces_;
  std::vector<Side> sides_;
  Box<T> box_;
  T size_ = 0;
};

extern template class ConvexPolyhedron<float>;
extern template class ConvexPolyhedron<double>;

}  // namespace cutwater
