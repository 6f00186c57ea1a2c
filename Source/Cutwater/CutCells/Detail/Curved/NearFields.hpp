#pragma once

#include <Cutwater/CutCells/Detail/Curved/FluidField.hpp>
#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>

#include <array>
#include <optional>

namespace cutwater {

/// The box between the outermost planes.
[[nodiscard]] Box<double> boxOf(const GridPlanes& planes);

/// A field in a tile, with the surfaces that its walls lie in there, if they are known; and where
/// that is found which lies in planes beyond the seam. For one thread at a time.
class NearFields {
 public:
  /// Views both.
  NearFields(const FluidField& field, const GridPlanes& planes) : field_(field), planes_(planes) {}

  [[nodiscard]] const FluidField& here() { return below({}); }
  /// For what lies in the last plane across each axis along which this is not 0, so far below it.
  [[nodiscard]] const FluidField& below(const Vec3<double>& shift);

 private:
  struct Near {
    std::unique_ptr<const FluidField> field;  // null: that of the solid
  };
  const FluidField& field_;
  const GridPlanes& planes_;
  std::array<std::optional<Near>, 8> near_;  // by the axes along which they are below
};

}  // namespace cutwater
