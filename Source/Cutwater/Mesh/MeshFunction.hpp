#pragma once

#include <Cutwater/Mesh/SignScheme.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <memory>

namespace cutwater {

/// What a MeshSDF searches: its triangles in a tree.
template <std::floating_point T>
class MeshIndex;
/// What a DcelSDF searches: its triangles, one after the other.
template <std::floating_point T>
class DcelIndex;

/// What MeshSDF and DcelSDF have in common, down to the last bit: only the index by which they find
/// triangles differs. Copies share it.
template <std::floating_point T, typename Index>
class MeshFunction : public SignedDistanceFunction<T> {
 public:
  /// The number of triangles that are searched: polygons are cut into these.
  [[nodiscard]] std::size_t triangleCount() const;
  /// The corners of a triangle as numbered by closestPoint(), in the mesh's own frame.
  /// @throws Error if there is no such triangle.
  [[nodiscard]] std::array<Vec3<T>, 3> triangle(std::uint32_t id) const;
  /// The box of all triangles, in the mesh's own frame: where to look at a surface, or to close it
  /// on a plane, if it is open. boundingBox() is that of the solid, which is larger then: the sheet
  /// that closes a hole by the winding number may bulge out of it, and where an open surface, or
  /// one that meets itself, has its signs by the nearest feature, the solid is unbounded.
  [[nodiscard]] Box<T> surfaceBox() const;
  /// How signs are decided, and what that is based on.
  [[nodiscard]] const SignReport& signReport() const;

 protected:
  /// Shares the index, which never changes.
  explicit MeshFunction(std::shared_ptr<const Index> index) : index_(std::move(index)) {}

  /// The triangles and the means to find them.
  [[nodiscard]] const Index& index() const { return *index_; }

 private:
  T localSignedDistance(const Vec3<T>& point) const final;
  T localSignedDistanceWithin(const Vec3<T>& point, const Interval<T>& wanted) const final;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const final;
  bool localGainsFromNeighbours() const final { return true; }
  bool localSignedDistancesWithin(std::span<const Vec3<T>> points, T limit,
                                  std::span<T> distances) const final;
  Vec3<T> localGradient(const Vec3<T>& point) const final;
  SurfacePoint<T> localClosestPoint(const Vec3<T>& point) const final;
  void localClosestPoints(std::span<const Vec3<T>> points,
                          std::span<SurfacePoint<T>> results) const final;
  SurfaceOwner localOwner(const Vec3<T>& point) const final;
  CrossingCount localCrossings(const Segment<T>& segment, CrossingVisitor<T> visit) const final;
  void localFirstHits(std::span<const Segment<T>> segments,
                      std::span<FirstHit<T>> hits) const final;
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const final;
  BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const final;
  void localClasses(std::span<const OrientedBox<T>> boxes, std::span<BoxClass> classes,
                    std::span<BoxHint> hints) const final;
  bool localFacetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const final;
  std::optional<T> localLipschitzIn(const OrientedBox<T>& box) const final;
  Guarantee<T> localGuarantee() const final;
  Box<T> localBoundingBox() const final;
  Box<T> localClearanceBox() const final;
  std::vector<std::string> localPatchNames() const final;
  std::string localName() const final;
  /// The class of a box by what is known of any function, as a function object.
  [[nodiscard]] auto defaultClass() const;

  std::shared_ptr<const Index> index_;
};

extern template class MeshFunction<float, MeshIndex<float>>;
extern template class MeshFunction<double, MeshIndex<double>>;
extern template class MeshFunction<float, DcelIndex<float>>;
extern template class MeshFunction<double, DcelIndex<double>>;

}  // namespace cutwater
