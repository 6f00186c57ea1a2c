#pragma once

#include <Cutwater/Grid/Detail/CellBatch.hpp>
#include <Cutwater/Grid/Detail/TileParts.hpp>

namespace cutwater::detail {

/// Classifies the cells of tiles of a grid patch, one tile at a time.
///
/// A tile is divided into ever smaller parts as long as the value in a part's middle does not prove
/// that each cell of it is clear by CellBatch's own test. So which parts there are changes no
/// class. Without a Lipschitz constant there is no such proof, and cells only share what box
/// queries have learned about their part.
template <std::floating_point T>
class TileClasses {
 public:
  explicit TileClasses(const FillTask<T>& task) : task_(task), batch_(task) {}

  void fill(const OffsetBox& tile);
  /// After the last tile.
  void finish() { batch_.flush(); }

 private:
  struct Part : TilePart {
    BoxHint hint;
  };

  /// The box around the cells of these indices.
  [[nodiscard]] Box<T> boxOf(const OffsetBox& indices) const;
  void settle(std::span<Part> parts) const;
  /// Whether the value in the middle of the box proves that all its cells are clear.
  [[nodiscard]] bool isClear(const Box<T>& box, T atCenter) const;

  const FillTask<T>& task_;
  CellBatch<T> batch_;
};

extern template class TileClasses<float>;
extern template class TileClasses<double>;

}  // namespace cutwater::detail
