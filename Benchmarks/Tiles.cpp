#include "Tiles.hpp"

#include <algorithm>

#include "Points.hpp"

namespace cutwater::benchmarks {

Tiles::Tiles(const Index3& cells)
    : cells_(cells), whole_(IndexBox::ofSize(cells.i, cells.j, cells.k)) {
  std::vector<IndexBox> inOrder;
  for (std::int32_t k = 0; k < cells.k; k += kSide) {
    for (std::int32_t j = 0; j < cells.j; j += kSide) {
      for (std::int32_t i = 0; i < cells.i; i += kSide) {
        const Index3 last{std::min(i + kSide, cells.i) - 1, std::min(j + kSide, cells.j) - 1,
                          std::min(k + kSide, cells.k) - 1};
        inOrder.push_back({{i, j, k}, last});
      }
    }
  }
  for (const auto i : scattered(inOrder.size())) boxes_.push_back(inOrder[i]);
}

std::size_t Tiles::linear(const Index3& cell) const {
  const auto i = static_cast<std::size_t>(cell.i);
  const auto j = static_cast<std::size_t>(cell.j);
  const auto k = static_cast<std::size_t>(cell.k);
  return i + whole_.length(0) * (j + whole_.length(1) * k);
}

Index3 Tiles::cell(std::size_t linear) const {
  const auto nx = static_cast<std::size_t>(cells_.i);
  const auto ny = static_cast<std::size_t>(cells_.j);
  return {static_cast<std::int32_t>(linear % nx), static_cast<std::int32_t>(linear / nx % ny),
          static_cast<std::int32_t>(linear / nx / ny)};
}

}  // namespace cutwater::benchmarks
