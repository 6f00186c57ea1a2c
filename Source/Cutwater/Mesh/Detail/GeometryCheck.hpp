// Private: checks whether the numbers in a geometry file can be valid.
#pragma once

#include <Cutwater/Mesh/Detail/MeshLayout.hpp>

namespace cutwater::detail {

/// @throws Error(File) for a file that is damaged.
[[noreturn]] void failDamaged(const char* what);
inline void requireIntact(bool ok, const char* what) {
  if (!ok) failDamaged(what);
}

/// Checks what the header states: the frames, and the number of elements of each array as far as it
/// follows from others.
template <std::floating_point T>
void checkLayout(const MeshLayout<T>& layout);

/// Checks the arrays, which must lie within the block: every index, and whatever else queries rely
/// on to stay within arrays and to terminate. Floating-point values are not checked, except for
/// positions: damage to them is for the checksum to find.
template <std::floating_point T>
void checkArrays(const MeshLayout<T>& layout, const Block& block, std::uint64_t patches,
                 int threads);

}  // namespace cutwater::detail
