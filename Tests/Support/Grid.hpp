#pragma once

#include <Cutwater/Core/IndexBox.hpp>

#include <bit>
#include <random>
#include <type_traits>

namespace cutwater::test {

/// Equal as bytes: tells -0 from 0, and NaN equals itself.
template <typename T>
bool sameBits(T a, T b) {
  using Bits = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b);
}

/// A box of indices within [0, count)^3.
inline IndexBox randomBox(int count, std::mt19937& random) {
  const auto upTo = [&](int end) {
    return static_cast<int>(random() % static_cast<unsigned>(end));
  };
  const Index3 lower{upTo(count), upTo(count), upTo(count)};
  return {lower,
          {lower.i + upTo(count - lower.i), lower.j + upTo(count - lower.j),
           lower.k + upTo(count - lower.k)}};
}

}  // namespace cutwater::test
