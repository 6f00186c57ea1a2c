#pragma once

#include <Cutwater/Grid/OctreeSigns.hpp>
#include <Cutwater/Grid/UnresolvedFeatures.hpp>

namespace cutwater::detail {

/// The surface in one cell against the signs at its corners.
template <std::floating_point T>
class UnresolvedCell {
 public:
  UnresolvedCell(const SignedDistanceFunction<T>& solid, const Box<T>& box, const CellSigns& signs)
      : solid_(solid), box_(box), signs_(signs) {}

  struct Finding {
    UnresolvedKind kind = UnresolvedKind::Thin;
    bool isSolid = false;
    T depth = 0;  ///< as a length
    Vec3<T> point = {};
  };
  /// Nothing if corners tell it all. `isCut`: some surface is certainly in the cell.
  [[nodiscard]] std::optional<Finding> find(bool isCut);

 private:
  static constexpr std::size_t kMostPoints = 64;

  [[nodiscard]] bool mayMeet(const Box<T>& part) const { return mayBeCut(solid_.classify(part)); }
  [[nodiscard]] UnresolvedKind hiddenKind() const;
  [[nodiscard]] bool isMultiCut(bool& isSolid) const;
  /// Notes the first crossings of the edges, and what these pass through between two of them.
  void walkEdges();
  /// Notes points of the surface in the cell, from samples.
  void samplePoints();
  void note(const Vec3<T>& point, const Vec3<T>& normal);
  /// Of the solid or the fluid behind a noted point: along the normal, to the other side or out of
  /// the cell.
  [[nodiscard]] T depthAt(std::size_t point, bool isSolid) const;

  const SignedDistanceFunction<T>& solid_;
  Box<T> box_;
  CellSigns signs_;
  EdgeStretch<T> thickest_{};  // twice as thick as its distance
  std::size_t count_ = 0;
  std::array<Vec3<T>, kMostPoints> points_;
  std::array<Vec3<T>, kMostPoints> normals_;
};

extern template class UnresolvedCell<float>;
extern template class UnresolvedCell<double>;

}  // namespace cutwater::detail
