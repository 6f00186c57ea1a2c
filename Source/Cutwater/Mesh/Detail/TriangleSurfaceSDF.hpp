#pragma once

#include <Cutwater/Mesh/Detail/CappedWinding.hpp>
#include <Cutwater/Mesh/SignScheme.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>
#include <Cutwater/Triangles/QueryBox.hpp>
#include <Cutwater/Triangles/SurfaceLocation.hpp>

namespace cutwater {

struct ClippedSegment;

/// What all mesh functions share: the results that follow once the nearest triangle is known. How
/// triangles are found is up to the subclass and does not affect a single bit.
template <std::floating_point T>
class TriangleSurfaceSDF : public SignedDistanceFunction<T> {
 public:
  /// The number of triangles that are searched: polygons are cut into these.
  [[nodiscard]] std::size_t triangleCount() const { return surface_.triangles.size(); }
  /// The corners of a triangle as numbered by closestPoint(), in the mesh's own frame.
  /// @throws Error if there is no such triangle.
  [[nodiscard]] std::array<Vec3<T>, 3> triangle(std::uint32_t id) const;
  /// The box of all triangles, in the mesh's own frame: where to look at a surface that is open, or
  /// meets itself, and has its signs by the nearest feature, as the solid is then unbounded.
  [[nodiscard]] Box<T> surfaceBox() const;
  /// How signs are decided, and what that is based on.
  [[nodiscard]] const SignReport& signReport() const { return signs_; }

 protected:
  /// The arrays, and the result of searching them.
  using Surface = TriangleSurface<T>;
  using Nearest = typename Surface::Nearest;

  TriangleSurfaceSDF() = default;

  // The points and segments below are in the surface's scaled units.

  /// The triangle nearest to `p`, of equally near ones that with the lowest id, and whatever ties
  /// with it.
  [[nodiscard]] virtual Nearest nearest(const Vec3<T>& p) const = 0;
  /// The same if its distance is at most `reach`; otherwise any triangle or none.
  [[nodiscard]] virtual Nearest nearestWithin(const Vec3<T>& p, double /*reach*/) const {
    return nearest(p);
  }
  /// The same for each of at most kBatch points.
  virtual void nearest(std::span<const Vec3<T>> points, std::span<Nearest> nearest) const;
  static constexpr std::size_t kBatch = 256;
  /// See TrianglesAlong.
  virtual void along(const Segment<double>& segment, TriangleVisitor visit) const = 0;
  /// The most certain of the results of QueryBox for the triangles. `place` records where the
  /// triangles are that boxes within this one meet; 0 at first.
  [[nodiscard]] virtual BoxOverlap overlapWith(const OrientedBox<double>& box,
                                               std::uint32_t& place) const = 0;
  /// Passes to `visit` at least all triangles that are no farther from the box than the value it
  /// last returned (at first `limit`), and none once that is 0. Ids end at the first kNone.
  virtual void around(const OrientedBox<double>& box, double limit,
                      TriangleVisitor visit) const = 0;
  // The winding number of a surface that is not closed: whether it exceeds 1/2 at the point, and
  // whether it certainly does so everywhere or nowhere in the box, apart from jumps at triangles.
  [[nodiscard]] virtual bool isSurrounded(const Vec3<T>& p) const = 0;
  [[nodiscard]] virtual bool isDecided(const Box<double>& box) const = 0;
  /// The winding number itself; none if the class takes only closed surfaces.
  [[nodiscard]] virtual const CappedWinding* openWinding() const { return nullptr; }

  /// Called by the subclass's constructor when the block is complete. The solid may reach beyond
  /// the triangles' box by `margin`, in scaled units.
  void setSurface(const Surface& surface, double margin = 0);
  /// Called last, when all else is known: chooses the scheme, unless one is requested.
  void setSigns(const SignReport& signs, SignScheme wanted);
  [[nodiscard]] const Surface& surface() const { return surface_; }
  /// along() as a function object.
  [[nodiscard]] auto search() const {
    return [this](const Segment<double>& segment, TriangleVisitor visit) { along(segment, visit); };
  }
  /// Converts from the mesh's own units; points for which squares would overflow are pulled in.
  [[nodiscard]] Vec3<T> scaled(const Vec3<T>& point) const;
  /// 1 outside, -1 inside, 0 exactly on the surface.
  [[nodiscard]] int side(const Vec3<T>& p, const Nearest& nearest) const;
  [[nodiscard]] bool isInside(const Vec3<T>& p) const;

 private:
  T localSignedDistance(const Vec3<T>& point) const final;
  T localSignedDistanceWithin(const Vec3<T>& point, const Interval<T>& wanted) const final;
  /// Whether a ball about the point extends beyond the mesh's box, both in the mesh's own units: if
  /// it contains no triangle of a closed surface, the point is outside.
  [[nodiscard]] bool leavesBox(const Vec3<T>& point, T radius) const;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const final;
  Vec3<T> localGradient(const Vec3<T>& point) const final;
  SurfacePoint<T> localClosestPoint(const Vec3<T>& point) const final;
  void localClosestPoints(std::span<const Vec3<T>> points,
                          std::span<SurfacePoint<T>> results) const final;
  SurfaceOwner localOwner(const Vec3<T>& point) const final;
  CrossingCount localCrossings(const Segment<T>& segment, CrossingVisitor<T> visit) const final;
  /// The segment, in scaled units. Ends that are far are moved along it towards the surface, not
  /// beyond any crossing.
  [[nodiscard]] ClippedSegment nearPart(const Segment<T>& segment) const;
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const final;
  BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const final;
  bool localFacetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const final;
  [[nodiscard]] SurfaceFacet<T> facet(std::uint32_t id, const QueryBox& box) const;
  void localClasses(std::span<const OrientedBox<T>> boxes, std::span<BoxClass> classes,
                    std::span<BoxHint> hints) const final;
  Guarantee<T> localGuarantee() const final;
  Box<T> localBoundingBox() const final { return box_; }
  Box<T> localClearanceBox() const final {
    return signJumps_ ? Box<T>::everywhere() : box_;  // no triangle is beyond it
  }
  std::string localName() const final;
  // `point` and, in the surface's units, `p` are the same point.
  [[nodiscard]] T valueAt(const Vec3<T>& point, const Vec3<T>& p, const Nearest& nearest) const;
  [[nodiscard]] SurfacePoint<T> closestPointAt(const Vec3<T>& point, const Vec3<T>& p,
                                               const Nearest& nearest) const;
  /// Calls visit(i, p, nearest) for each of the points; searches them in batches.
  template <typename Visit>
  void forNearest(std::span<const Vec3<T>> points, Visit visit) const;

  /// Returns the box in scaled units; nothing if they do not resolve it, as it is too large or too
  /// far.
  [[nodiscard]] std::optional<OrientedBox<double>> scaled(const OrientedBox<T>& box) const;
  /// The class of a box; nothing if no triangle and no jump meets it: then its centre decides.
  [[nodiscard]] std::optional<BoxClass> classUnlessClear(const OrientedBox<T>& box,
                                                         BoxHint* hint) const;
  [[nodiscard]] BoxClass classOfClear(const OrientedBox<T>& box, const Vec3<T>& p,
                                      const Nearest& nearest, BoxHint* hint) const;
  /// A lower bound on the distance from the box to the triangles, which is known to be within
  /// `limit`.
  [[nodiscard]] double gapTo(const OrientedBox<double>& box, double limit) const;
  /// Whether the sign certainly does not change in the box, in scaled units, except at triangles.
  [[nodiscard]] bool isJumpFree(const Box<double>& box) const;
  /// The same for a box in the mesh's own units.
  [[nodiscard]] bool hasNoJump(const Box<T>& box) const;

  Surface surface_;
  SignReport signs_;
  /// Away from triangles: at the sheet of winding number 1/2 that closes a hole or, by the nearest
  /// feature, where an open surface or one that meets itself has another nearest triangle.
  bool signJumps_ = false;
  Box<T> box_;
};

extern template class TriangleSurfaceSDF<float>;
extern template class TriangleSurfaceSDF<double>;

}  // namespace cutwater
