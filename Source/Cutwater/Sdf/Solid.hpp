#pragma once

#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <concepts>
#include <memory>
#include <type_traits>
#include <utility>

namespace cutwater {

/// Any signed distance function as a value. Copies share one immutable expression. Moving a Solid
/// moves only this handle, so another instance of a mesh costs only a transform.
///
/// Operators (`|`, `&`, `-`, `~` and the functions in Operations/) take and return Solids.
template <std::floating_point T>
class Solid final : public SignedDistanceFunction<T> {
 public:
  /// Takes ownership of the shape; its placement becomes the Solid's.
  template <std::derived_from<SignedDistanceFunction<T>> Shape>
  requires(!std::same_as<Shape, Solid>)
      Solid(Shape shape)  // NOLINT(google-explicit-constructor): a shape is a solid
      : Solid(std::make_unique<Shape>(std::move(shape))) {}

  /// @throws Error if there is no shape.
  explicit Solid(std::unique_ptr<SignedDistanceFunction<T>> shape);

  /// signedDistance(), to the bit, if it is within `wanted`; otherwise any number beyond the same
  /// end of `wanted`, which may cost less.
  [[nodiscard]] T signedDistanceWithin(const Vec3<T>& point, const Interval<T>& wanted) const;

  /// Visits surfaces that together contain this solid's in a box, each smooth there as far as is
  /// known, and perhaps some that do not meet the box: of a union, those of its operands; of a
  /// cuboid, the planes of its faces; of most shapes without edges, their own. Visits nothing for a
  /// box that is empty or not finite. Allocates memory.
  void surfacesIn(const Box<T>& box, SurfaceVisitor<T> visit) const;

  /// The shape inside, without the Solid's placement, if it has this type; otherwise nullptr.
  template <std::derived_from<SignedDistanceFunction<T>> Shape>
  [[nodiscard]] const Shape* as() const {
    return dynamic_cast<const Shape*>(root_.get());
  }

 private:
  T localSignedDistance(const Vec3<T>& p) const override;
  T localSignedDistanceWithin(const Vec3<T>& p, const Interval<T>& wanted) const override;
  void localSignedDistances(std::span<const Vec3<T>> points, std::span<T> distances) const override;
  bool localGainsFromNeighbours() const override { return root_->localGainsFromNeighbours(); }
  bool localSignedDistancesWithin(std::span<const Vec3<T>> points, T limit,
                                  std::span<T> distances) const override;
  Vec3<T> localGradient(const Vec3<T>& p) const override;
  SurfacePoint<T> localClosestPoint(const Vec3<T>& p) const override;
  void localClosestPoints(std::span<const Vec3<T>> points,
                          std::span<SurfacePoint<T>> results) const override;
  SurfaceOwner localOwner(const Vec3<T>& p) const override;
  CrossingCount localCrossings(const Segment<T>& segment, CrossingVisitor<T> visit) const override;
  void localCrossingsOfEach(std::span<const Segment<T>> segments, std::span<CrossingCount> counts,
                            CrossingsVisitor<T> visit) const override;
  void localFirstHits(std::span<const Segment<T>> segments,
                      std::span<FirstHit<T>> hits) const override;
  Interval<T> localBounds(const OrientedBox<T>& box, BoxHint* hint) const override;
  BoxClass localClassify(const OrientedBox<T>& box, BoxHint* hint) const override;
  bool localFacetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const override;
  bool localSurfacesIn(const OrientedBox<T>& box, SurfaceVisitor<T> visit) const override;
  void localClasses(std::span<const OrientedBox<T>> boxes, std::span<BoxClass> classes,
                    std::span<BoxHint> hints) const override;
  std::optional<T> localConcavity(const OrientedBox<T>& box) const override {
    return root_->localConcavity(box);
  }
  std::optional<T> localLipschitzIn(const OrientedBox<T>& box) const override {
    return root_->localLipschitzIn(box);
  }
  Guarantee<T> localGuarantee() const override { return guarantee_; }
  Box<T> localBoundingBox() const override { return boundingBox_; }
  Box<T> localClearanceBox() const override;
  std::vector<std::string> localPatchNames() const override;
  std::string localName() const override { return root_->localName(); }
  void forEachOperand(FunctionRef<void(const SignedDistanceFunction<T>&)> visit) const override {
    root_->forEachOperand(visit);
  }

  std::shared_ptr<const SignedDistanceFunction<T>> root_;  // its own placement is the identity
  Guarantee<T> guarantee_;                                 // of root_; composites query it often
  Box<T> boundingBox_;
};

/// `Solid ball = Sphere<double>(...)` is a Solid<double>.
template <typename Shape>
Solid(Shape) -> Solid<typename Shape::Scalar>;

/// A Solid or a shape that converts to one.
template <typename S>
concept SolidLike = std::derived_from<S, SignedDistanceFunction<typename S::Scalar>>;

extern template class Solid<float>;
extern template class Solid<double>;

}  // namespace cutwater
