#pragma once

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Sdf/Solid.hpp>

#include <array>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "Arguments.hpp"

/// What is behind a cw_solid.
struct cw_solid {
  explicit cw_solid(cutwater::Solid<double> shape)
      : solid(std::move(shape)), patchNames(solid.patchNames()) {}

  /// What cuts cells, made by the first call for each side.
  [[nodiscard]] const cutwater::CellCutter& cutter(cutwater::FluidSide side) const {
    const std::lock_guard lock(mutex_);
    auto& kept = cutters_.at(side == cutwater::FluidSide::Inside ? 1 : 0);
    if (!kept) kept.emplace(solid, side);
    return *kept;
  }

  cutwater::Solid<double> solid;
  std::vector<std::string> patchNames;

 private:
  mutable std::mutex mutex_;
  mutable std::array<std::optional<cutwater::CellCutter>, 2> cutters_;
};

/// What is behind a cw_cutter.
struct cw_cutter {
  explicit cw_cutter(cutwater::CellCutter made) : cutter(std::move(made)) {}

  cutwater::CellCutter cutter;
};

namespace cutwater::binding {

inline const cw_solid& handleOf(const cw_solid* handle) {
  require(handle != nullptr, "the solid is NULL");
  return *handle;
}

/// Calls make() and passes a new handle with its result to the caller, or NULL if it throws.
template <typename Handle, typename Make>
cw_status create(const char* function, Handle** result, Make make) {
  if (result != nullptr) *result = nullptr;
  return guarded(function, [&] {
    require(result != nullptr, "the result is NULL");
    *result = new Handle(make());
  });
}

}  // namespace cutwater::binding
