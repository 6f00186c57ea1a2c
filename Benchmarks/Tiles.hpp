#pragma once

#include <Cutwater/Core/IndexBox.hpp>

#include <cstdint>
#include <vector>

namespace cutwater::benchmarks {

/// A grid's cells in tiles, so that a part of them can stand for all.
class Tiles {
 public:
  static constexpr std::int32_t kSide = 16;

  /// Needs one cell or more along each axis.
  explicit Tiles(const Index3& cells);

  [[nodiscard]] std::size_t count() const { return boxes_.size(); }
  /// In scattered order: the first ones are spread evenly.
  [[nodiscard]] const IndexBox& operator[](std::size_t i) const { return boxes_[i]; }
  [[nodiscard]] IndexBox whole() const { return whole_; }
  /// Position of a cell in an array of all, x fastest.
  [[nodiscard]] std::size_t linear(const Index3& cell) const;
  [[nodiscard]] Index3 cell(std::size_t linear) const;

 private:
  Index3 cells_;
  IndexBox whole_;
  std::vector<IndexBox> boxes_;
};

}  // namespace cutwater::benchmarks
