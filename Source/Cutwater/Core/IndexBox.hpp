#pragma once

#include <cstddef>
#include <cstdint>

namespace cutwater {

/// Integer coordinates of a cell or node in the index space of a level; may be negative.
struct Index3 {
  std::int32_t i = 0;
  std::int32_t j = 0;
  std::int32_t k = 0;

  bool operator==(const Index3&) const = default;
};

/// All indices from `lo` to `hi`, both included. Empty if any component of hi is below lo's.
struct IndexBox {
  Index3 lo;
  Index3 hi{-1, -1, -1};

  /// The box of nx * ny * nz indices that starts at (0, 0, 0).
  static constexpr IndexBox ofSize(std::int32_t nx, std::int32_t ny, std::int32_t nz) {
    return {{0, 0, 0}, {nx - 1, ny - 1, nz - 1}};
  }

  /// Number of indices along axis 0, 1 or 2; 0 if there are none.
  [[nodiscard]] constexpr std::size_t length(int axis) const {
    const std::int64_t a = axis == 0 ? lo.i : axis == 1 ? lo.j : lo.k;
    const std::int64_t b = axis == 0 ? hi.i : axis == 1 ? hi.j : hi.k;
    return b < a ? 0 : static_cast<std::size_t>(b - a + 1);
  }
  [[nodiscard]] constexpr std::size_t count() const { return length(0) * length(1) * length(2); }
  [[nodiscard]] constexpr bool empty() const { return count() == 0; }

  /// Whether the index lies in the box, both ends included.
  [[nodiscard]] constexpr bool contains(const Index3& index) const {
    return lo.i <= index.i && index.i <= hi.i && lo.j <= index.j && index.j <= hi.j &&
           lo.k <= index.k && index.k <= hi.k;
  }

  /// The index (i, j, k) steps from `lo`, which must be within the range of int32.
  [[nodiscard]] constexpr Index3 at(std::uint32_t i, std::uint32_t j, std::uint32_t k) const {
    const auto along = [](std::int32_t first, std::uint32_t steps) {
      return static_cast<std::int32_t>(std::int64_t{first} + steps);
    };
    return {along(lo.i, i), along(lo.j, j), along(lo.k, k)};
  }

  bool operator==(const IndexBox&) const = default;
};

/// Calls visit(index) for all indices of a box, i fastest and k slowest.
template <typename Visit>
constexpr void forEachIndex(const IndexBox& box, const Visit& visit) {
  for (std::int64_t k = box.lo.k; k <= box.hi.k; ++k) {
    for (std::int64_t j = box.lo.j; j <= box.hi.j; ++j) {
      for (std::int64_t i = box.lo.i; i <= box.hi.i; ++i) {
        visit(Index3{static_cast<std::int32_t>(i), static_cast<std::int32_t>(j),
                     static_cast<std::int32_t>(k)});
      }
    }
  }
}

}  // namespace cutwater
