#pragma once

#include <Cutwater/Core/IndexBox.hpp>

#include <bit>
#include <type_traits>

namespace cutwater::test {

/// Equal as bytes: tells -0 from 0, and NaN equals itself.
template <typename T>
bool sameBits(T a, T b) {
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

/// Visits the box's indices, x fastest.
template <typename Visit>
void forEach(const IndexBox& box, Visit visit) {
  for (int k = box.lo.k; k <= box.hi.k; ++k) {
    for (int j = box.lo.j; j <= box.hi.j; ++j) {
      for (int i = box.lo.i; i <= box.hi.i; ++i) visit(Index3{i, j, k});
    }
  }
}

}  // namespace cutwater::test
