#pragma once

#include <Cutwater/Core/IndexBox.hpp>

#include <array>
#include <cstddef>

namespace cutwater {

/// A view of the caller's array of values, one per index of a grid patch. `data` points at the
/// value of its lowest index. Strides are in elements and arbitrary, so one component of an
/// application's array can be filled in place.
template <typename Value>
struct GridView {
  Value* data = nullptr;
  std::array<std::ptrdiff_t, 3> stride{};

  /// An array without gaps in which x varies fastest.
  static constexpr GridView contiguous(Value* data, const IndexBox& box) {
    const auto nx = static_cast<std::ptrdiff_t>(box.length(0));
    const auto ny = static_cast<std::ptrdiff_t>(box.length(1));
    return {data, {1, nx, nx * ny}};
  }

  /// The value at offset (i, j, k) from the lowest index.
  constexpr Value& at(std::size_t i, std::size_t j, std::size_t k) const {
    return data[static_cast<std::ptrdiff_t>(i) * stride[0] +
                static_cast<std::ptrdiff_t>(j) * stride[1] +
                static_cast<std::ptrdiff_t>(k) * stride[2]];
  }
};

}  // namespace cutwater
