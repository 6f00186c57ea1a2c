// Private: whether a geometry file's numbers can be what they stand for.
#pragma once

#include <Cutwater/Mesh/MeshLayout.hpp>

namespace cutwater::detail {

/// @throws Error(File) for a file that is damaged.
[[noreturn]] void failDamaged(const char* what);
inline void requireIntact(bool ok, const char* what) {
  if (!ok) failDamaged(what);
}

/// Of what the header tells: frames, and the number of elements of each array as far as it follows
/// from others.
template <std::floating_point T>
void checkLayout(const MeshLayout<T>& layout);

/// Of the arrays, which must lie within the block: every index and whatever else queries rely on so
/// as not to read beyond arrays or go on for ever. What floating-point numbers say is not looked
/// at, but for positions: damage to them is for the checksum to find.
template <std::floating_point T>
void checkArrays(const MeshLayout<T>& layout, const Block& block, std::uint64_t patches,
                 int threads);

}  // namespace cutwater::detail
