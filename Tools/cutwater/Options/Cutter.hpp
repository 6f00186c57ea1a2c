#pragma once

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>

#include <optional>
#include <variant>

#include "Options/CuttingOptions.hpp"

namespace cutwater::tool {

/// Cuts cells: by a surface, exactly, or by a solid that is none, within errors that the cells
/// state.
class Cutter {
 public:
  /// @throws Error(Argument) for options that only surfaces have, where the solid is none; and as
  /// CellCutter.
  Cutter(const Solid<double>& solid, const CuttingOptions& options);

  template <typename Mesh>
  [[nodiscard]] auto cut(const Mesh& mesh, const CutOptions& options) const {
    return std::visit([&](const auto& cutter) { return cutter.cut(mesh, options); }, cutter_);
  }

  /// One for coarser cells, by which time is estimated: these have not all planes of open patches,
  /// and do not fit a period.
  [[nodiscard]] Cutter trial(const Solid<double>& solid, const CuttingOptions& options) const;

 private:
  std::variant<CellCutter, SolidCutter> cutter_;
};

}  // namespace cutwater::tool
