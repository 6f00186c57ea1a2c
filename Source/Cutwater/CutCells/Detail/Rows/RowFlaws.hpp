// Private: whether rows of cut cells belong together.
#pragma once

#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/CutLeaves.hpp>

namespace cutwater {

/// What does not hold of these rows, of which every function on cut cells relies: lengths, order,
/// and what rows say of each other. Null if all is well. Numbers must be finite; whether volumes
/// and areas are right is for check().
[[nodiscard]] const char* flawOf(const CutCells& cells);
/// The same of leaves. Whether they are those of some octree, functions that take it must see.
[[nodiscard]] const char* flawOf(const CutLeaves& leaves);

}  // namespace cutwater
