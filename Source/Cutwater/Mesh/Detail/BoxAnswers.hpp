#pragma once

#include <Cutwater/Mesh/Detail/PointAnswers.hpp>
#include <Cutwater/Triangles/QueryBox.hpp>

#include <optional>

namespace cutwater {

/// What a mesh answers about boxes, and its facets in them: see PointAnswers. Boxes are in the
/// mesh's own frame where they are made of T, in the surface's scaled units where of double.
template <std::floating_point T, typename Index>
class BoxAnswers {
 public:
  using Nearest = typename TriangleSurface<T>::Nearest;
  /// The class of a box as any function would find it: for boxes that triangles do not decide.
  using DefaultClass = FunctionRef<BoxClass(const OrientedBox<T>& box, BoxHint* hint)>;

  explicit BoxAnswers(const Index& index) : index_(index), points_(index) {}

  // See the functions of SignedDistanceFunction that begin with local.
  [[nodiscard]] Interval<T> bounds(const OrientedBox<T>& box) const;
  [[nodiscard]] BoxClass classOf(const OrientedBox<T>& box, BoxHint* hint,
                                 DefaultClass byDefault) const;
  void classesOf(std::span<const OrientedBox<T>> boxes, std::span<BoxClass> classes,
                 std::span<BoxHint> hints, DefaultClass byDefault) const;
  /// Returns false, and visits nothing, where the box is so large or so far that the surface is a
  /// point.
  [[nodiscard]] bool facetsIn(const OrientedBox<T>& box, FacetVisitor<T> visit) const;
  /// Whether the sign certainly changes at triangles alone in the box.
  [[nodiscard]] bool isSteady(const Box<T>& box) const;

 private:
  static constexpr std::size_t kBatch = PointAnswers<T, Index>::kBatch;

  [[nodiscard]] const TriangleSurface<T>& surface() const { return index_.surface(); }
  [[nodiscard]] const SignReport& signs() const { return index_.signs(); }

  /// Returns the box in scaled units; nothing if they do not resolve it, as it is too large or too
  /// far.
  [[nodiscard]] std::optional<OrientedBox<double>> scaled(const OrientedBox<T>& box) const;
  [[nodiscard]] Box<double> scaled(const Box<T>& box) const {
    const double scale{surface().scale};
    return {scale * Vec3<double>(box.lower), scale * Vec3<double>(box.upper)};
  }
  /// The class of a box; nothing if no triangle and no jump meets it: then its centre decides.
  [[nodiscard]] std::optional<BoxClass> classUnlessClear(const OrientedBox<T>& box, BoxHint* hint,
                                                         DefaultClass byDefault) const;
  [[nodiscard]] BoxClass classOfClear(const OrientedBox<T>& box, const Vec3<T>& p,
                                      const Nearest& nearest, BoxHint* hint) const;
  /// A lower bound on the distance from the box to the triangles, which is known to be within
  /// `limit`.
  [[nodiscard]] double gapTo(const OrientedBox<double>& box, double limit) const;
  /// Whether the sign certainly does not change in a box that meets no triangle.
  [[nodiscard]] bool isJumpFree(const Box<double>& box) const;
  [[nodiscard]] SurfaceFacet<T> facet(std::uint32_t id, const QueryBox& box) const;

  const Index& index_;
  PointAnswers<T, Index> points_;
};

}  // namespace cutwater
