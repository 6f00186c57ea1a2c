#include <Cutwater/Grid/Detail/TargetBox.hpp>
#include <Cutwater/Grid/Detail/TileFill.hpp>
#include <Cutwater/Sdf/Detail/Defaults.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater::detail {

template <std::floating_point T>
void TileFill<T>::fill(const OffsetBox& tile) {
  tile_ = tile;
  placePositions();
  if (task_.hasBand()) {
    fillBand();
  } else {
    Part whole;
    whole.indices = tile;
    addPoints(whole, task_.order.bits());
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
void TileFill<T>::fillBand() {
  divideTile<Part>(
      task_.order, tile_,
      [this](std::span<Part> parts) {
        boundParts(parts);
        for (const auto& part : parts) {
          if (part.isSettled) fillBeyond(part);
        }
      },
      [this](const Part& part, int bits) { addPoints(part, bits); });
}

template <std::floating_point T>
void TileFill<T>::boundParts(std::span<Part> parts) const {
  Scratch<Vec3<T>, TilePart::kMost> centers;
  Scratch<T, TilePart::kMost> values;
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
    parts[i].beyondSquared = -1;  // not the one of a larger part that it began as a copy of
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
      parts[i].isSettled = range.lower > task_.limit || range.upper < -task_.limit;
      parts[i].sign = range.lower;
    }
  }
}

template <std::floating_point T>
void TileFill<T>::boundByLipschitz(Part& part, const OrientedBox<T>& box, T atCenter) const {
  const auto range = boundsAround(atCenter, box, task_.promise);
  const T missing = task_.limit - (atCenter < 0 ? -range.upper : range.lower);
  part.isSettled = missing < 0;
  part.sign = atCenter;
  // The bound for all within r of the centre exceeds that for all within box.radius() by the
  // Lipschitz constant times the difference, or more.
  constexpr T kOutward = 1 + 8 * std::numeric_limits<T>::epsilon();
  const T radius = box.radius() - kOutward * (missing / *task_.promise.lipschitz);
  part.center = box.center;
  if (radius > 0) part.beyondSquared = radius * radius / (kOutward * kOutward);
}

template <std::floating_point T>
void TileFill<T>::fillBeyond(const Part& part) const {
  fillBox(task_.targets.distance, part.indices, std::copysign(task_.limit, part.sign));
  fillBox(task_.targets.patch, part.indices, std::uint32_t{kNone});
  constexpr T kNaN = std::numeric_limits<T>::quiet_NaN();
  fillBox(task_.targets.closestPoint, part.indices, {kNaN, kNaN, kNaN});
  fillBox(task_.targets.normal, part.indices, {kNaN, kNaN, kNaN});
}

template <std::floating_point T>
void TileFill<T>::addPoints(const Part& part, int bits) {
  forIndices(task_.order, tile_, part, bits, [&](const Offset& inTile) {
    const auto point = position(inTile);
    const Offset offset{tile_.first[0] + inTile[0], tile_.first[1] + inTile[1],
                        tile_.first[2] + inTile[2]};
    if (lengthSquared(point - part.center) < part.beyondSquared) {
      batch_.storeBeyond(offset, part.sign);
    } else {
      batch_.add(point, offset);
    }
  });
}

template class TileFill<float>;
template class TileFill<double>;

}  // namespace cutwater::detail
