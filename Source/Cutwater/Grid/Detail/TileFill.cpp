#include <Cutwater/Grid/Detail/TileFill.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater::detail {

namespace {

/// Writes the same value at all indices of a block.
template <typename Value>
void fillBlock(const GridView<Value>& view, const GridBlock& block, Value value) {
  if (view.data == nullptr) return;
  const auto& [first, size] = block;
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

}  // namespace

template <std::floating_point T>
void TileFill<T>::fill(const GridBlock& tile) {
  tile_ = tile;
  placePositions();
  if (task_.hasBand()) {
    fillBand();
  } else {
    addPoints({.indices = tile, .number = 0}, task_.order.bits());
  }
}

template <std::floating_point T>
void TileFill<T>::placePositions() {
  const auto& [first, size] = tile_;
  const auto longest = std::max({size[0], size[1], size[2]});
  for (std::uint32_t n = 0; n < longest; ++n) {
    Offset offset{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      offset[axis] = first[axis] + std::min(n, size[axis] - 1);
    }
    const auto index = task_.patch.indices.at(offset[0], offset[1], offset[2]);
    positions_[n] = task_.patch.level.position(index);
  }
}

template <std::floating_point T>
GridBlock TileFill<T>::indicesOf(std::uint32_t number, int bits) const {
  const auto offset = task_.order.offset(number);
  GridBlock block;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (offset[axis] >= tile_.size[axis]) return {};
    block.first[axis] = tile_.first[axis] + offset[axis];
    block.size[axis] = std::min(task_.order.shape(bits)[axis], tile_.size[axis] - offset[axis]);
  }
  return block;
}

template <std::floating_point T>
void TileFill<T>::fillBand() {
  std::array<Blocks, 2> blocks;
  blocks[0][0] = {.indices = tile_, .number = 0};
  std::size_t count = 1;
  int bits = task_.order.bits();
  for (std::size_t from = 0; count > 0; from = 1 - from) {
    judge(blocks[from].first(count));
    count = settle(blocks[from].first(count), bits, blocks[1 - from]);
    bits = std::max(bits - kDivisionBits, kLeafBits);
  }
}

template <std::floating_point T>
std::size_t TileFill<T>::settle(std::span<const Block> blocks, int bits, Blocks& parts) {
  const int part = std::max(bits - kDivisionBits, kLeafBits);
  std::size_t count = 0;
  for (const auto& block : blocks) {
    if (block.isBeyond) {
      fillBlock(task_.targets.distance, block.indices, std::copysign(task_.limit, block.sign));
      fillBlock(task_.targets.patch, block.indices, kNone);
    } else if (bits <= kLeafBits) {
      addPoints(block, bits);
    } else {
      const auto end = block.number + (1U << bits);
      for (auto number = block.number; number < end; number += 1U << part) {
        const auto indices = indicesOf(number, part);
        if (indices.size != Offset{}) parts[count++] = {.indices = indices, .number = number};
      }
    }
  }
  return count;
}

template <std::floating_point T>
void TileFill<T>::judge(std::span<Block> blocks) const {
  Scratch<Vec3<T>, kMostBlocks> centers;
  Scratch<T, kMostBlocks> values;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const auto& [first, size] = blocks[i].indices;
    Offset lower{};
    Offset upper{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lower[axis] = first[axis] - tile_.first[axis];
      upper[axis] = lower[axis] + size[axis] - 1;
    }
    // Coordinates grow with the index, even when rounded, so no position is outside.
    blocks[i].box = {position(lower), position(upper)};
    centers[i] = blocks[i].box.center();
  }
  if (task_.promise.lipschitz) {
    task_.solid.signedDistances(centers.first(blocks.size()), values.first(blocks.size()),
                                {.threads = 1});
  }
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const auto box = OrientedBox<T>::of(blocks[i].box);
    if (task_.promise.lipschitz && box.isWithin(task_.promise.domain)) {
      conclude(blocks[i], box, values[i]);
    } else {
      const auto range = task_.solid.bounds(blocks[i].box);
      blocks[i].isBeyond = range.lower > task_.limit || range.upper < -task_.limit;
      blocks[i].sign = range.lower;
    }
  }
}

template <std::floating_point T>
void TileFill<T>::conclude(Block& block, const OrientedBox<T>& box, T atCenter) const {
  const auto range = boundsAround(atCenter, box, task_.promise);
  const T missing = task_.limit - (atCenter < 0 ? -range.upper : range.lower);
  block.isBeyond = missing < 0;
  block.sign = atCenter;
  // The bound for all within r of the centre exceeds that for all within box.radius() by the
  // Lipschitz constant times the difference, or more.
  constexpr T kOutward = 1 + 8 * std::numeric_limits<T>::epsilon();
  const T radius = box.radius() - kOutward * (missing / *task_.promise.lipschitz);
  block.center = box.center;
  if (radius > 0) block.beyondSquared = radius * radius / (kOutward * kOutward);
}

template <std::floating_point T>
void TileFill<T>::addPoints(const Block& block, int bits) {
  const bool isWhole = block.indices.size == task_.order.shape(bits);
  for (auto number = block.number; number < block.number + (1U << bits); ++number) {
    const auto inTile = task_.order.offset(number);
    const auto& size = tile_.size;
    if (!isWhole && (inTile[0] >= size[0] || inTile[1] >= size[1] || inTile[2] >= size[2])) {
      continue;
    }
    const auto point = position(inTile);
    const Offset offset{tile_.first[0] + inTile[0], tile_.first[1] + inTile[1],
                        tile_.first[2] + inTile[2]};
    if (lengthSquared(point - block.center) < block.beyondSquared) {
      batch_.writeBeyond(offset, block.sign);
    } else {
      batch_.add(point, offset);
    }
  }
}

template class TileFill<float>;
template class TileFill<double>;

}  // namespace cutwater::detail
