#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <optional>
#include <vector>

namespace cutwater::detail {

struct CellFace {
  int axis;
  bool isUpper;
};

/// Restores edges and corners of a solid, which marching cubes would cut off: where normals at the
/// points of a cell's polygon differ, the planes through these points meet in a further point.
///
/// L. P. Kobbelt, M. Botsch, U. Schwanecke and H.-P. Seidel, "Feature sensitive surface extraction
/// from volume data", SIGGRAPH 2001.
template <std::floating_point T>
class SharpFeatures {
 public:
  /// `degrees`: normals that differ by more make an edge; 180 or more: no edges.
  SharpFeatures(const SignedDistanceFunction<T>& solid, double degrees);

  [[nodiscard]] bool areWanted() const { return leastCosine_ > -1; }
  /// Returns the surface point nearest to where the planes meet, if that is in the cell, or beyond
  /// one of its faces in the quarter of a neighbour that is nearest to that face and has no surface
  /// of its own: elsewhere, triangles might cross those of other cells. If the planes meet in a
  /// line, any part of it in the cell will do, or, if it only passes close by, the nearest point in
  /// the cell.
  [[nodiscard]] std::optional<Vec3<double>> pointIn(
      std::span<const Vec3<double>> points, const Box<double>& cell,
      FunctionRef<bool(const CellFace&)> isFreeBeyond) const;

 private:
  const SignedDistanceFunction<T>& solid_;
  double leastCosine_;
};

/// Flips the common edge of any two of the triangles at `fans`, whose last corner is a feature,
/// that share their first two corners. An edge then joins their features instead. No edge is
/// flipped if that would fold a triangle over.
void joinFeatures(std::vector<std::array<std::uint32_t, 3>>& triangles,
                  std::span<const std::size_t> fans, std::span<const Vec3<double>> points);

extern template class SharpFeatures<float>;
extern template class SharpFeatures<double>;

}  // namespace cutwater::detail
