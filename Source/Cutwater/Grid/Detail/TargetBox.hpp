#pragma once

#include <Cutwater/Core/GridView.hpp>
#include <Cutwater/Grid/Detail/GridTiles.hpp>

#include <algorithm>

namespace cutwater::detail {

/// Writes the same value at all indices of a box, unless the view is empty.
template <typename Value>
void fillBox(const GridView<Value>& view, const OffsetBox& box, const Value& value) {
  if (view.data == nullptr) return;
  const auto& [first, size] = box;
  for (auto k = first[2]; k < first[2] + size[2]; ++k) {
    for (auto j = first[1]; j < first[1] + size[1]; ++j) {
      Value* const row = &view.at(first[0], j, k);
      if (view.stride[0] == 1) {
        std::fill_n(row, size[0], value);
      } else {
        for (std::uint32_t i = 0; i < size[0]; ++i) row[i * view.stride[0]] = value;
      }
    }
  }
}

}  // namespace cutwater::detail
