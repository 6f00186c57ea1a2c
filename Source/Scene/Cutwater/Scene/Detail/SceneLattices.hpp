#pragma once

#include <Cutwater/Lattice/Thickness.hpp>
#include <Cutwater/Lattice/UnitCell.hpp>
#include <Cutwater/Scene/Detail/SceneRecord.hpp>

namespace cutwater::scene {

// Keys that all lattices share: the unit cell, given by the value of the key that identifies the
// form, the height of re-entrant cells, and the radius of struts.
SceneKey unitCellKey(const char* name);
SceneKey reentrantHeightKey();
UnitCell unitCellOf(const SceneRecord& r, std::string_view key);
SceneKey strutRadiusKey();
Thickness<double> strutRadiusOf(const SceneRecord& r);

/// Lattices that are fitted to a shape.
SceneForm conformalForm();

}  // namespace cutwater::scene
