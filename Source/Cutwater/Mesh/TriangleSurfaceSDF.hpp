#pragma once

#include <Cutwater/Mesh/QueryBox.hpp>
#include <Cutwater/Mesh/SignScheme.hpp>
#include <Cutwater/Mesh/SurfaceLocation.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

namespace cutwater {

/// What all mesh functions share: the answers that follow once the nearest triangle is known. How
/// triangles are found is the subclass' business, and changes no bit.
template <std::floating_point T>
class TriangleSurfaceSDF : public SignedDistanceFunction<T> {
 public:
  /// Of triangles that are searched: polygons are cut into these.
  [[nodiscard]] std::size_t triangleCount() const { return surface_.triangles.size(); }
  /// Corners of a triangle as closestPoint() counts them, in the mesh's own frame.
  /// @throws Error if there is no such triangle.
  [[nodiscard]] std::array<Vec3<T>, 3> triangle(std::uint32_t id) const;
  /// How signs are decided, and what that rests on.
  [[nodiscard]] const SignReport& signReport() const { return signs_; }

 protected:
  /// The arrays, and what a search of them finds.
  using Surface = TriangleSurface<T>;
  using Nearest = typename Surface::Nearest;

  TriangleSurfaceSDF() = default;

  // The points and segments below are in the surface's scaled units.

  /// The triangle nearest to `p`, of equals the one with the lowest id, and whatever ties with it.
  [[nodiscard]] virtual Nearest nearest(const Vec3<T>& p) const = 0;
  /// The same if its distance is at most `reach`; if not, any triangle or none.
  [[nodiscard]] virtual Nearest nearestWithin(const Vec3<T>& p, double /*reach*/) const {
    return nearest(p);
  }
  /// The same for each of at most kBatch points.
  virtual void nearest(std::span<const Vec3<T>> points, std::span<Nearest> nearest) const;
  static constexpr std::size_t kBatch = 256;
  /// See TrianglesAlong.
  virtual void along(const Segment<double>& segment, TriangleVisitor visit) const = 0;
  /// What QueryBox tells about the triangles, the most certain of it. `place`: what is known of
  /// where triangles are that boxes within this one meet; 0 at first.
  [[nodiscard]] virtual BoxOverlap overlapWith(const OrientedBox<double>& box,
                                               std::uint32_t& place) const = 0;
  /// Shows at least all triangles that are no farther from the box than what visit(ids) returns,
  /// and `limit` at first; none any more once that is 0. Ids end at the first kNone.
  virtual void around(const OrientedBox<double>& box, double limit,
                      TriangleVisitor visit) const = 0;
  // The winding number of a surface that is not closed: whether it exceeds 1/2 at the point, and
  // whether it certainly does so in all or none of the box, but for the sides of triangles.
  [[nodiscard]] virtual bool isSurrounded(const Vec3<T>& p) const = 0;
  [[nodiscard]] virtual bool isDecided(const Box<double>& box) const = 0;

  /// Called by the subclass' constructor when the block is complete. The solid may reach beyond the
  /// triangles' box by `margin`, in scaled units.
  void setSurface(const Surface& surface, double margin = 0);
  /// Called last, when all is known: chooses the scheme, unless one is wanted.
  void setSigns(const SignReport& signs, SignScheme wanted);
  [[nodiscard]] const Surface& surface() const { return surface_; }
  /// along() as a function.
  [[nodiscard]] auto search() const {
    return [this](const Segment<double>& segment, TriangleVisitor visit) { along(segment, visit); };
  }
  /// From a point in the mesh's own units; pulled in where squares would overflow.
  [[nodiscard]] Vec3<T> scaled(const Vec3<T>& point) const;
  /// 1 outside, -1 inside, 0 exactly on the surface.
  [[nodiscard]] int side(const Vec3<T>& p, const Nearest& nearest) const;
  [[nodiscard]] bool isInside(const Vec3<T>& p) const;

 private:
  [[nodiscard]] T localSignedDistance(const Vec3<T>& point) const final;
  [[nodiscard]] T localSignedDistanceWithin(const Vec3<T>& point,
                                            const Interval<T>& wanted) const final;
  /// Whether a ball about the point leaves the mesh's box, both in the mesh's own units: if it
  /// holds no triangle of a closed surface, the point is outside.
  [[nodiscard]] bool leavesBox(const Vec3<T>& point, T radius) const;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const final;
  [[nodiscard]] Vec3<T> localGradient(const Vec3<T>& point) const final;
  [[nodiscard]] SurfacePoint<T> localClosestPoint(const Vec3<T>& point) const final;
  void localClosestPoints(std::span<const Vec3<T>> points,
                          std::span<SurfacePoint<T>> results) const final;
  [[nodiscard]] SurfaceOwner localOwner(const Vec3<T>& point) const final;
  CrossingCount localCrossings(const Segment<T>& segment, CrossingVisitor<T> visit) const final;
  [[nodiscard]] Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const final;
  [[nodiscard]] BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const final;
  bool localFacetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const final;
  [[nodiscard]] SurfaceFacet<T> facet(std::uint32_t id, const QueryBox& box) const;
  void localClasses(std::span<const OrientedBox<T>> boxes, std::span<BoxClass> classes,
                    std::span<BoxHint> hints) const final;
  [[nodiscard]] Guarantee<T> localGuarantee() const final;
  [[nodiscard]] Box<T> localBoundingBox() const final { return box_; }
  [[nodiscard]] Box<T> localClearanceBox() const final {
    return signs_.isClosed() ? box_ : Box<T>::everywhere();  // no triangle is beyond it
  }
  [[nodiscard]] std::string localName() const final;
  // `point` and, in the surface's units, `p` are the same.
  [[nodiscard]] T valueAt(const Vec3<T>& point, const Vec3<T>& p, const Nearest& nearest) const;
  [[nodiscard]] SurfacePoint<T> closestPointAt(const Vec3<T>& point, const Vec3<T>& p,
                                               const Nearest& nearest) const;
  /// Calls visit(i, p, nearest) for each of the points, searched for in batches.
  template <typename Visit>
  void forNearest(std::span<const Vec3<T>> points, Visit visit) const;

  /// In scaled units; nothing if it is too large or too far for these to resolve it.
  [[nodiscard]] std::optional<OrientedBox<double>> scaled(const OrientedBox<T>& box) const;
  /// The class of a box, unless no triangle meets it, and no jump: then it is that of its centre.
  [[nodiscard]] std::optional<BoxClass> classUnlessClear(const OrientedBox<T>& box,
                                                         BoxHint* hint) const;
  [[nodiscard]] BoxClass classOfClear(const OrientedBox<T>& box, const Vec3<T>& p,
                                      const Nearest& nearest, BoxHint* hint) const;
  /// How far the triangles are from the box at least; known to be within `limit`.
  [[nodiscard]] double gapTo(const OrientedBox<double>& box, double limit) const;
  /// Whether the sign certainly changes nowhere in the box, in scaled units, but at triangles.
  [[nodiscard]] bool isJumpFree(const Box<double>& box) const;
  /// The same for a box in the mesh's own units.
  [[nodiscard]] bool hasNoJump(const Box<T>& box) const;

  Surface surface_;
  SignReport signs_;
  Box<T> box_;
};

extern template class TriangleSurfaceSDF<float>;
extern template class TriangleSurfaceSDF<double>;

}  // namespace cutwater
