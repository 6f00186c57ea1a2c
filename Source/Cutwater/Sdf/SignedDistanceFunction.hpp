#pragma once

#include <Cutwater/Core/Interval.hpp>
#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Core/RigidTransform.hpp>
#include <Cutwater/Core/Segment.hpp>
#include <Cutwater/Sdf/BoxQuery.hpp>
#include <Cutwater/Sdf/Guarantee.hpp>
#include <Cutwater/Sdf/SurfacePoint.hpp>

#include <span>
#include <string>
#include <vector>

namespace cutwater {

/// A solid defined by its signed distance: negative inside, positive outside; 0 counts as outside.
///
/// A shape is written once, in its own frame, by overriding localSignedDistance(). This class
/// places it in the world with translate() and rotate(), which every public query takes into
/// account. All queries are const and thread-safe; those about a point or a box never allocate and
/// never throw.
///
/// A query at a point that is not finite returns NaN. For a box that is empty or not finite,
/// queries return Unknown and (-inf, inf).
template <std::floating_point T>
class SignedDistanceFunction {
 public:
  using Scalar = T;  ///< float or double

  virtual ~SignedDistanceFunction() = default;

  /// Signed distance from a point in the world, in its units; guarantee() states what it means.
  [[nodiscard]] T signedDistance(const Vec3<T>& point) const;

  /// The same for many points, in parallel; the results are the same to the bit. Where that is
  /// faster, 131072 points and more are taken in an order of their own, by which neighbours are
  /// close to each other; this allocates memory, eight bytes a point and some megabytes.
  /// @throws Error if the spans differ in size.
  void signedDistances(std::span<const Vec3<T>> points, std::span<T> distances,
                       const ParallelOptions& options = {}) const;

  /// The same, on the calling thread, for values from -limit to limit only, `limit` >= 0; others
  /// may be NaN. Returns false and computes nothing if this solid has no faster way to find these;
  /// whether it has one does not depend on the points, of which there may be none. Neighbours in
  /// the span should be close to each other in space.
  /// @throws Error if the spans differ in size.
  bool signedDistancesWithin(std::span<const Vec3<T>> points, T limit,
                             std::span<T> distances) const;

  /// Outward unit normal by centred differences of half-width `delta`. Zero where these vanish,
  /// e.g. at the centre of a sphere, and for a delta that is not positive.
  [[nodiscard]] Vec3<T> normal(const Vec3<T>& point, T delta) const;

  /// Gradient of the value, analytic where the shape provides it. Zero where it is not defined.
  [[nodiscard]] Vec3<T> gradient(const Vec3<T>& point) const;

  /// A point of the surface nearest to `point`, exact or to the tolerance it states.
  [[nodiscard]] SurfacePoint<T> closestPoint(const Vec3<T>& point) const;

  /// The same for many points, in parallel and in any order; the results are the same to the bit.
  /// @throws Error if the spans differ in size.
  void closestPoints(std::span<const Vec3<T>> points, std::span<SurfacePoint<T>> results,
                     const ParallelOptions& options = {}) const;

  /// Object, patch and face that a point on the surface belongs to.
  [[nodiscard]] SurfaceOwner owner(const Vec3<T>& surfacePoint) const;

  /// Visits every crossing of the segment with the surface, in order. The number found is odd if
  /// and only if the values at the two ends differ in sign. A segment that is not finite has none.
  CrossingCount crossings(const Segment<T>& segment, CrossingVisitor<T> visit) const;

  /// All crossings of many segments, in parallel; the same to the bit. Unlike the queries above,
  /// allocates memory: for the result, and as much again.
  [[nodiscard]] CrossingLists<T> crossings(std::span<const Segment<T>> segments,
                                           const ParallelOptions& options = {}) const;

  /// The first crossing of each of many segments, in parallel: the same to the bit as the first one
  /// that crossings() visits. A mesh does not look at what lies behind it.
  /// @throws Error if the spans differ in size.
  void firstHits(std::span<const Segment<T>> segments, std::span<FirstHit<T>> hits,
                 const ParallelOptions& options = {}) const;

  /// Encloses the function's value, both exact and as computed, at every point of the box.
  [[nodiscard]] Interval<T> bounds(const Box<T>& box, BoxHint* hint = nullptr) const;

  /// Encloses the distance to the surface at every point of the box, e.g. to select a band around
  /// the surface. Never negative; [0, infinity) where the guarantee promises only the sign or does
  /// not apply, and without an upper bound where values are lower bounds.
  [[nodiscard]] Interval<T> distanceBounds(const Box<T>& box, BoxHint* hint = nullptr) const;

  /// Classifies the box; Inside, Outside and Cut are certain.
  [[nodiscard]] BoxClass classify(const Box<T>& box, BoxHint* hint = nullptr) const;

  /// The same for many boxes in parallel, with the same answers. Neighbours in the span should be
  /// close to each other in space. Pass either no hints or one for each box.
  /// @throws Error if the spans differ in size.
  void classify(std::span<const Box<T>> boxes, std::span<BoxClass> classes,
                std::span<BoxHint> hints = {}, const ParallelOptions& options = {}) const;

  /// Visits the surface in the box until visit(facet) returns false. Where the surface consists of
  /// flat pieces, visits all that meet the box, and perhaps some that do not or that lie within
  /// another operand; elsewhere, samples of it. Visits nothing for a box that is empty or not
  /// finite. Returns whether all pieces were visited, and no samples.
  bool facetsIn(const Box<T>& box, FacetVisitor<T> visit) const;

  /// What values mean, in world coordinates.
  [[nodiscard]] Guarantee<T> guarantee() const;

  /// A number k such that values at points p and q of a box differ by at most k |p - q|, also where
  /// guarantee() knows of none everywhere: a surface that is open has one away from its holes. None
  /// if none is known.
  [[nodiscard]] std::optional<T> lipschitzIn(const Box<T>& box) const;

  /// Encloses the solid {value <= 0}; may be infinite or empty.
  [[nodiscard]] Box<T> boundingBox() const;

  /// A box outside which every value is at least the distance to the box, up to rounding; infinite
  /// if none is known. Where values outside are exact distances, this is boundingBox(). Where they
  /// are only lower bounds it may be larger: for a block with a hole, that of the block.
  [[nodiscard]] Box<T> clearanceBox() const;

  /// Names of the patches, by the index that closestPoint() and crossings() report.
  [[nodiscard]] std::vector<std::string> patchNames() const { return localPatchNames(); }

  /// The expression: one line for every shape and operator with its guarantee, operands below:
  ///
  ///     Union: outside exact, inside lower bound, Lipschitz 1; in (-1, -1, -1) .. (3, 1, 1)
  ///       Sphere: exact, Lipschitz 1; in (-1, -1, -1) .. (1, 1, 1)
  ///       Torus, moved by (2, 0, 0) and turned: exact, Lipschitz 1; in (0.9, -1, -1) .. (3, 1, 1)
  ///
  /// Lists only the first 16 operands of each operator.
  [[nodiscard]] std::string describe() const;

  /// Move the object, in the order of the calls: see RigidTransform, also for errors.
  void translate(const Vec3<T>& offset) { placement_.translate(offset); }
  void rotate(T degrees, int axis) { placement_.rotate(degrees, axis); }
  void rotate(T degrees, const Vec3<T>& axis, const Vec3<T>& through = {}) {
    placement_.rotate(degrees, axis, through);
  }
  [[nodiscard]] const RigidTransform<T>& placement() const { return placement_; }
  void setPlacement(const RigidTransform<T>& placement) { placement_ = placement; }

  /// From the world to the shape's own frame. Already applied when a local function is called.
  [[nodiscard]] Vec3<T> transformPoint(const Vec3<T>& point) const {
    return placement_.toLocal(point);
  }

 protected:
  // Copying is for subclasses only: through the base it would slice.
  SignedDistanceFunction() = default;
  SignedDistanceFunction(const SignedDistanceFunction&) = default;
  SignedDistanceFunction(SignedDistanceFunction&&) noexcept = default;
  SignedDistanceFunction& operator=(const SignedDistanceFunction&) = default;
  SignedDistanceFunction& operator=(SignedDistanceFunction&&) noexcept = default;

  /// The one function that a shape must define. The point is finite and in the shape's own frame.
  [[nodiscard]] virtual T localSignedDistance(const Vec3<T>& point) const = 0;

  // Everything below has a default that follows from localSignedDistance() and localGuarantee().
  // Arguments and results are in the shape's own frame.

  /// The value, to the bit, if it is within `wanted`; otherwise any number beyond the same end of
  /// `wanted`. Override it where that costs less than the value: most of many operands need only be
  /// known to be farther away than the nearest.
  [[nodiscard]] virtual T localSignedDistanceWithin(const Vec3<T>& point,
                                                    const Interval<T>& /*wanted*/) const {
    return localSignedDistance(point);
  }

  /// Whether points that are close to each other are faster than others in the functions below. By
  /// default, if that is so for an operand.
  [[nodiscard]] virtual bool localGainsFromNeighbours() const;
  /// Values for a few hundred points at most; runs inside a parallel region.
  virtual void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const;
  /// As signedDistancesWithin(), for a few hundred points at most. The default returns false.
  virtual bool localSignedDistancesWithin(std::span<const Vec3<T>> points, T limit,
                                          std::span<T> distances) const;
  [[nodiscard]] virtual Vec3<T> localGradient(const Vec3<T>& point) const;
  [[nodiscard]] virtual SurfacePoint<T> localClosestPoint(const Vec3<T>& point) const;
  /// Closest points for a few hundred points at most; runs inside a parallel region.
  virtual void localClosestPoints(std::span<const Vec3<T>> points,
                                  std::span<SurfacePoint<T>> results) const;
  /// The owner of the surface at a surface point.
  [[nodiscard]] virtual SurfaceOwner localOwner(const Vec3<T>&) const { return {}; }
  virtual CrossingCount localCrossings(const Segment<T>& segment, CrossingVisitor<T> visit) const;
  /// All crossings of a few dozen finite segments at most, those of each in order; runs inside a
  /// parallel region. The default calls localCrossings() for one after the other. Where that is not
  /// overridden and localSignedDistances() is faster than one value after the other, an override
  /// may call crossingsByValues(), which has the same results.
  virtual void localCrossingsOfEach(std::span<const Segment<T>> segments,
                                    std::span<CrossingCount> counts,
                                    CrossingsVisitor<T> visit) const;
  void crossingsByValues(std::span<const Segment<T>> segments, std::span<CrossingCount> counts,
                         CrossingsVisitor<T> visit) const;
  /// First hits of a few dozen finite segments at most; runs inside a parallel region.
  virtual void localFirstHits(std::span<const Segment<T>> segments,
                              std::span<FirstHit<T>> hits) const;
  /// An override may be tighter than the default, but must not be looser. Likewise, an override of
  /// localClassify() must decide every box that the default decides. A union of many operands uses
  /// the defaults alone where a box is far from an operand.
  [[nodiscard]] virtual Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const;
  [[nodiscard]] virtual BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const;
  virtual bool localFacetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const;
  /// See Solid::surfacesIn(): a shape with edges visits solids that have none, as a cuboid the
  /// planes of its faces; an operator, what surfacesOf() visits of its operands. What lies in the
  /// box may not be left out. The default visits nothing and returns false: the surface is one.
  virtual bool localSurfacesIn(const OrientedBox<T>& /*box*/, SurfaceVisitor<T> /*visit*/) const {
    return false;
  }
  /// Classes of a few hundred boxes at most, with no hints or one for each; runs inside a parallel
  /// region.
  virtual void localClasses(std::span<const OrientedBox<T>> boxes, std::span<BoxClass> classes,
                            std::span<BoxHint> hints) const;
  /// A number k such that f(p) + k |p|^2 / 2 is a convex function in the box, slack included: 0 for
  /// convex solids with exact distances; none if there is no such number, or it is not known. Boxes
  /// are then enclosed by tangent planes, so an override asks that localGradient() is, within the
  /// rounding of error(), the gradient at a point within that distance, or zero.
  [[nodiscard]] virtual std::optional<T> localConcavity(const OrientedBox<T>&) const { return {}; }
  /// See lipschitzIn(). By default, what localGuarantee() says.
  [[nodiscard]] virtual std::optional<T> localLipschitzIn(const OrientedBox<T>& box) const;
  /// Guarantees nothing but the sign unless overridden.
  [[nodiscard]] virtual Guarantee<T> localGuarantee() const { return {}; }
  [[nodiscard]] virtual Box<T> localBoundingBox() const { return Box<T>::everywhere(); }
  [[nodiscard]] virtual Box<T> localClearanceBox() const;
  [[nodiscard]] virtual std::vector<std::string> localPatchNames() const { return {"surface"}; }

  /// For describe(): the name with its parameters, and the operands.
  [[nodiscard]] virtual std::string localName() const { return "Function"; }
  virtual void forEachOperand(FunctionRef<void(const SignedDistanceFunction&)>) const {}

  /// For composites: an operand's answer for a box given in the composite's own frame.
  [[nodiscard]] static Interval<T> boundsOf(const SignedDistanceFunction& operand,
                                            const OrientedBox<T>& box, BoxHint* hint = nullptr) {
    return operand.localBounds(operand.toLocal(box), hint);
  }
  [[nodiscard]] static BoxClass classOf(const SignedDistanceFunction& operand,
                                        const OrientedBox<T>& box, BoxHint* hint = nullptr) {
    return operand.localClassify(operand.toLocal(box), hint);
  }
  /// The same for facetsIn(), with facets in the composite's frame.
  static bool facetsOf(const SignedDistanceFunction& operand, const OrientedBox<T>& box,
                       FacetVisitor<T> visit);
  /// The same for Solid::surfacesIn().
  static void surfacesOf(const Solid<T>& operand, const OrientedBox<T>& box,
                         SurfaceVisitor<T> visit);

  /// Two tests by which the default of localClassify() proves that a box within the domain is cut.
  [[nodiscard]] bool holdsNearestPoint(const OrientedBox<T>& box) const;
  [[nodiscard]] bool holdsBothSides(const OrientedBox<T>& box) const;
  /// What the default of localClassify() finds out about a box within the domain that neither its
  /// bounds nor these tests decide: by a walk to the other side, and by bounds in parts of the box.
  /// Computes a fixed number of values and bounds at most.
  [[nodiscard]] BoxClass classOfUndecided(const OrientedBox<T>& box) const;

 private:
  [[nodiscard]] Crossing<T> toWorld(Crossing<T> local) const;

  template <std::floating_point>
  friend class Solid;  // forwards the local functions of the shape it holds

  void describe(std::string& text, int depth) const;
  [[nodiscard]] OrientedBox<T> toLocal(const OrientedBox<T>& box) const;
  [[nodiscard]] OrientedBox<T> toLocal(const Box<T>& box) const;
  /// Those that are not finite become points.
  void toLocal(std::span<const Segment<T>> segments, std::span<Segment<T>> local) const;
  [[nodiscard]] BoxClass classByDescent(const OrientedBox<T>& box,
                                        std::optional<T> concavity) const;
  [[nodiscard]] BoxClass classOfParts(const OrientedBox<T>& box) const;
  [[nodiscard]] SurfacePoint<T> toWorld(SurfacePoint<T> local) const;
  [[nodiscard]] T placementError(T reach) const;
  /// Calls answer(local points, their results) for batches of the points, in parallel, with the
  /// origin in place of points that are not finite, whose result then is `refused`.
  template <typename Result>
  void forLocalPoints(std::span<const Vec3<T>> points, std::span<Result> results,
                      const ParallelOptions& options, const Result& refused,
                      FunctionRef<void(std::span<const Vec3<T>>, std::span<Result>)> answer) const;

  RigidTransform<T> placement_;
};

extern template class SignedDistanceFunction<float>;
extern template class SignedDistanceFunction<double>;

}  // namespace cutwater
