#pragma once

#include <Cutwater/Core/IndexBox.hpp>
#include <Cutwater/Grid/Fill.hpp>
#include <Cutwater/Grid/TileOrder.hpp>

namespace cutwater::detail {

/// Neighbouring indices of a patch.
struct GridBlock {
  Offset first{};
  Offset size{};
};

/// How fill() goes through a patch: in tiles, blocks of indices about as long in space on each
/// axis. Points in small blocks are evaluated together, because the answer of one tells much about
/// the next. With a band, each tile is divided as long as one value in its middle does not prove
/// that all of it is beyond the band.
template <std::floating_point T>
class BlockFill {
 public:
  /// Values beyond the limit become +-limit; it may be infinite. The references must outlive this.
  BlockFill(const SignedDistanceFunction<T>& solid, const Patch<T>& patch,
            const FillTargets<T>& targets, T limit);

  [[nodiscard]] std::size_t tileCount() const;
  /// So many tiles at least should be filled in one go: enough for full batches.
  [[nodiscard]] std::size_t grain() const;
  /// Fills the tiles numbered [begin, end); threads may fill different tiles at the same time.
  void fillTiles(std::size_t begin, std::size_t end) const;

 private:
  class Batch;
  class Tile;

  [[nodiscard]] bool hasBand() const { return limit_ < std::numeric_limits<T>::infinity(); }
  [[nodiscard]] const Offset& tileShape() const { return order_.shape(order_.bits()); }
  [[nodiscard]] std::array<std::size_t, 3> tiles() const;  // along each axis
  [[nodiscard]] GridBlock tile(std::size_t number) const;
  [[nodiscard]] Index3 index(const Offset& offset) const;
  void fillConstant(const GridBlock& block, T distance) const;
  void evaluate(std::span<const Vec3<T>> points, std::span<const Offset> offsets) const;
  void evaluate(std::span<const Vec3<T>> points, std::span<const Offset> offsets,
                std::span<const T> distances) const;
  void write(const Offset& offset, T distance, std::uint32_t patch) const;

  const SignedDistanceFunction<T>& solid_;
  const Patch<T>& patch_;
  const FillTargets<T>& targets_;
  T limit_;
  Guarantee<T> promise_;
  TileOrder order_;
};

extern template class BlockFill<float>;
extern template class BlockFill<double>;

}  // namespace cutwater::detail
