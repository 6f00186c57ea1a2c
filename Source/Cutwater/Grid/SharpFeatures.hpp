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

/// Edges and corners of a solid, which marching cubes would cut off: where normals at the points of
/// a cell's polygon differ, the planes through these points meet in one more.
///
/// L. P. Kobbelt, M. Botsch, U. Schwanecke and H.-P. Seidel, "Feature sensitive surface extraction
/// from volume data", SIGGRAPH 2001.
template <std::floating_point T>
class SharpFeatures {
 public:
  /// `degrees`: normals that differ by more make an edge; 180 or more: there are none.
  SharpFeatures(const SignedDistanceFunction<T>& solid, double degrees);

  [[nodiscard]] bool areWanted() const { return leastCosine_ > -1; }
  /// The surface's point nearest to where the planes meet, if that is in the cell, or beyond one of
  /// its faces in the quarter of a neighbour that is nearest to that face, where the neighbour has
  /// no surface of its own: elsewhere, triangles might cross those of other cells. Of a line where
  /// planes meet, what is in the cell will do; and where it passes close by, the nearest in the
  /// cell.
  [[nodiscard]] std::optional<Vec3<double>> pointIn(
      std::span<const Vec3<double>> points, const Box<double>& cell,
      FunctionRef<bool(const CellFace&)> isFreeBeyond) const;

 private:
  const SignedDistanceFunction<T>& solid_;
  double leastCosine_;
};

/// Of the triangles at `fans`, whose last corner is a feature, two that share the edge of their
/// first two corners are turned, so that their features are joined by an edge instead, unless that
/// would fold one of them over.
void joinFeatures(std::vector<std::array<std::uint32_t, 3>>& triangles,
                  std::span<const std::size_t> fans, std::span<const Vec3<double>> points);

extern template class SharpFeatures<float>;
extern template class SharpFeatures<double>;

}  // namespace cutwater::detail
