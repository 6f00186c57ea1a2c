#pragma once

#include <Cutwater/Grid/Detail/OctreeSigns.hpp>
#include <Cutwater/Grid/UnresolvedFeatures.hpp>

namespace cutwater::detail {

/// Compares the surface in one cell with the signs at its corners.
template <std::floating_point T>
class UnresolvedCell {
 public:
  UnresolvedCell(const SignedDistanceFunction<T>& solid, const Box<T>& box,
                 const CellSigns<T>& signs)
      : solid_(solid), box_(box), signs_(signs) {}

  struct Finding {
    UnresolvedKind kind = UnresolvedKind::Thin;
    bool isSolid = false;
    T depth = 0;  ///< as a length
    Vec3<T> point = {};
  };
  /// Returns nothing if the corners resolve the surface. `isCut`: the cell certainly contains some
  /// surface.
  [[nodiscard]] std::optional<Finding> find(bool isCut);

 private:
  static constexpr std::size_t kMostPoints = 64;

  /// A depth that does not count: points found on the surface are off it by rounding.
  [[nodiscard]] T skin() const { return box_.diagonal() * T(0x1p-20); }
  /// Whether the cell is on the corners' side of the surface, except perhaps for its skin.
  [[nodiscard]] bool isOnlyTouched() const;
  [[nodiscard]] bool mayMeet(const Box<T>& part) const { return mayBeCut(solid_.classify(part)); }
  [[nodiscard]] UnresolvedKind hiddenKind() const;
  [[nodiscard]] bool isMultiCut(bool& isSolid) const;
  /// Notes crossings of one of kCellEdges, up to kMostPoints in all.
  void walkEdge(std::size_t number);
  /// Notes surface points in the cell, found by sampling.
  void samplePoints();
  void note(const Vec3<T>& point, const Vec3<T>& normal);
  /// Updates depth and point from the notes that are new.
  void measure(bool isHidden, Finding& result);
  /// How far the cell reaches from a noted point along its normal, into the solid or the fluid.
  [[nodiscard]] T reachFrom(std::size_t point, bool isSolid) const;
  /// Depth of the solid or fluid behind a noted point: along the normal, to its other side or to
  /// where the cell ends; `most` if it is at least that.
  [[nodiscard]] T depthAt(std::size_t point, bool isSolid, T most) const;

  const SignedDistanceFunction<T>& solid_;
  Box<T> box_;
  CellSigns<T> signs_;
  std::size_t count_ = 0;     // of notes
  std::size_t measured_ = 0;  // the first of them
  std::array<Vec3<T>, kMostPoints> points_;
  std::array<Vec3<T>, kMostPoints> normals_;
};

extern template class UnresolvedCell<float>;
extern template class UnresolvedCell<double>;

}  // namespace cutwater::detail
