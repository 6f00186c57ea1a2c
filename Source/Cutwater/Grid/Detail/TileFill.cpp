#include <Cutwater/Grid/Detail/TileFill.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater::detail {

namespace {

/// Writes the same value at all indices of a box.
template <typename Value>
void fillBox(const GridView<Value>& view, const OffsetBox& box, Value value) {
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

}  // namespace

template <std::floating_point T>
void TileFill<T>::fill(const OffsetBox& tile) {
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
    const auto index = task_.gridPatch.indices.at(offset[0], offset[1], offset[2]);
    positions_[n] = task_.gridPatch.level.position(index);
  }
}

template <std::floating_point T>
OffsetBox TileFill<T>::indicesOf(std::uint32_t number, int bits) const {
  const auto offset = task_.order.offset(number);
  OffsetBox indices;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (offset[axis] >= tile_.size[axis]) return {};
    indices.first[axis] = tile_.first[axis] + offset[axis];
    indices.size[axis] = std::min(task_.order.shape(bits)[axis], tile_.size[axis] - offset[axis]);
  }
  return indices;
}

template <std::floating_point T>
void TileFill<T>::fillBand() {
  std::array<Parts, 2> parts;
  parts[0][0] = {.indices = tile_, .number = 0};
  std::size_t count = 1;
  int bits = task_.order.bits();
  for (std::size_t from = 0; count > 0; from = 1 - from) {
    boundParts(parts[from].first(count));
    count = fillOrDivide(parts[from].first(count), bits, parts[1 - from]);
    bits = std::max(bits - kDivisionBits, kLeafBits);
  }
}

template <std::floating_point T>
void TileFill<T>::boundParts(std::span<Part> parts) const {
  Scratch<Vec3<T>, kMostParts> centers;
  Scratch<T, kMostParts> values;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto& [first, size] = parts[i].indices;
    Offset lower{};
    Offset upper{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lower[axis] = first[axis] - tile_.first[axis];
      upper[axis] = lower[axis] + size[axis] - 1;
    }
    // Coordinates grow with the index, even when rounded, so no position is outside.
    parts[i].box = {position(lower), position(upper)};
    centers[i] = parts[i].box.center();
  }
  if (task_.promise.lipschitz) {
    task_.solid.signedDistances(centers.first(parts.size()), values.first(parts.size()),
                                {.threads = 1});
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const auto box = OrientedBox<T>::of(parts[i].box);
    if (task_.promise.lipschitz && box.isWithin(task_.promise.domain)) {
      boundByLipschitz(parts[i], box, values[i]);
    } else {
      const auto range = task_.solid.bounds(parts[i].box);
      parts[i].isBeyond = range.lower > task_.limit || range.upper < -task_.limit;
      parts[i].sign = range.lower;
    }
  }
}

template <std::floating_point T>
void TileFill<T>::boundByLipschitz(Part& part, const OrientedBox<T>& box, T atCenter) const {
  const auto range = boundsAround(atCenter, box, task_.promise);
  const T missing = task_.limit - (atCenter < 0 ? -range.upper : range.lower);
  part.isBeyond = missing < 0;
  part.sign = atCenter;
  // The bound for all within r of the centre exceeds that for all within box.radius() by the
  // Lipschitz constant times the difference, or more.
  constexpr T kOutward = 1 + 8 * std::numeric_limits<T>::epsilon();
  const T radius = box.radius() - kOutward * (missing / *task_.promise.lipschitz);
  part.center = box.center;
  if (radius > 0) part.beyondSquared = radius * radius / (kOutward * kOutward);
}

template <std::floating_point T>
std::size_t TileFill<T>::fillOrDivide(std::span<const Part> parts, int bits, Parts& smaller) {
  const int smallerBits = std::max(bits - kDivisionBits, kLeafBits);
  std::size_t count = 0;
  for (const auto& part : parts) {
    if (part.isBeyond) {
      fillBeyond(part);
    } else if (bits <= kLeafBits) {
      addPoints(part, bits);
    } else {
      const auto end = part.number + (1U << bits);
      for (auto number = part.number; number < end; number += 1U << smallerBits) {
        const auto indices = indicesOf(number, smallerBits);
        if (indices.size != Offset{}) smaller[count++] = {.indices = indices, .number = number};
      }
    }
  }
  return count;
}

template <std::floating_point T>
void TileFill<T>::fillBeyond(const Part& part) const {
  fillBox(task_.targets.distance, part.indices, std::copysign(task_.limit, part.sign));
  fillBox(task_.targets.patch, part.indices, kNone);
}

template <std::floating_point T>
void TileFill<T>::addPoints(const Part& part, int bits) {
  const bool isWhole = part.indices.size == task_.order.shape(bits);
  for (auto number = part.number; number < part.number + (1U << bits); ++number) {
    const auto inTile = task_.order.offset(number);
    const auto& size = tile_.size;
    if (!isWhole && (inTile[0] >= size[0] || inTile[1] >= size[1] || inTile[2] >= size[2])) {
      continue;
    }
    const auto point = position(inTile);
    const Offset offset{tile_.first[0] + inTile[0], tile_.first[1] + inTile[1],
                        tile_.first[2] + inTile[2]};
    if (lengthSquared(point - part.center) < part.beyondSquared) {
      batch_.storeBeyond(offset, part.sign);
    } else {
      batch_.add(point, offset);
    }
  }
}

template class TileFill<float>;
template class TileFill<double>;

}  // namespace cutwater::detail
