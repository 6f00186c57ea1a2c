#pragma once

#include <Cutwater/Io/Scene/SceneRecord.hpp>
#include <Cutwater/Lattice/Thickness.hpp>
#include <Cutwater/Lattice/UnitCell.hpp>

// Private: not installed.

namespace cutwater::scene {

// What lattices of any cells have in common: the unit cell, by the value of the key that tells the
// form, and the height of re-entrant ones; the radius of struts.
SceneKey unitCellKey(const char* name);
SceneKey reentrantHeightKey();
UnitCell unitCellOf(const SceneRecord& r, std::string_view key);
SceneKey strutRadiusKey();
Thickness<double> strutRadiusOf(const SceneRecord& r);

/// Lattices that are fitted to a shape.
SceneForm conformalForm();

}  // namespace cutwater::scene
