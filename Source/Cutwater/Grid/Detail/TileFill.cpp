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
      [this](std::span<Part> parts, int bits) {
        settle(parts, bits);
        for (const auto& part : parts) {
          if (part.isSettled) noteBeyond({part.indices, part.sign < 0});
        }
      },
      [this](const Part& part, int bits) { addPoints(part, bits); });
}

template <std::floating_point T>
void TileFill<T>::settle(std::span<Part> parts, int bits) {
  findBoxes(parts);
  const bool isTile = bits == task_.order.bits();
  if (isTile && isBeyondByLast(parts.front())) return;
  if (!isTile && bits <= TilePart::kLeafBits && task_.hasExactWay()) return classifyParts(parts);
  boundParts(parts);
  if (isTile && parts.front().lipschitz) last_ = {parts.front().center, parts.front().sign};
}

template <std::floating_point T>
void TileFill<T>::findBoxes(std::span<Part> parts) const {
  for (auto& part : parts) {
    const auto& [first, size] = part.indices;
    Offset lower{};
    Offset upper{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      lower[axis] = first[axis] - tile_.first[axis];
      upper[axis] = lower[axis] + size[axis] - 1;
    }
    // Coordinates grow with the index, even when rounded, so no position is outside.
    part.box = {position(lower), position(upper)};
    part.beyondSquared = -1;  // not the one of a larger part that it began as a copy of
  }
}

template <std::floating_point T>
void TileFill<T>::classifyParts(std::span<Part> parts) const {
  Scratch<Box<T>, TilePart::kMost> boxes;
  Scratch<BoxClass, TilePart::kMost> classes;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    boxes[i] = parts[i].box.grown(task_.limit + 4 * task_.rounding);
  }
  task_.solid.classify(boxes.first(parts.size()), classes.first(parts.size()), {}, {.threads = 1});
  for (std::size_t i = 0; i < parts.size(); ++i) {
    parts[i].isSettled = !mayBeCut(classes[i]);
    if (parts[i].isSettled) parts[i].sign = classes[i] == BoxClass::Inside ? T(-1) : T(1);
  }
}

template <std::floating_point T>
std::optional<T> TileFill<T>::lipschitzIn(const Part& part) const {
  const auto& promise = task_.promise;
  if (part.lipschitz) return part.lipschitz;
  const bool isAnywhere = OrientedBox<T>::of(part.box).isWithin(promise.domain);
  return promise.lipschitz && isAnywhere ? promise.lipschitz : task_.solid.lipschitzIn(part.box);
}

template <std::floating_point T>
void TileFill<T>::boundParts(std::span<Part> parts) const {
  Scratch<Vec3<T>, TilePart::kMost> centers;
  Scratch<T, TilePart::kMost> values;
  std::size_t count = 0;
  for (auto& part : parts) {
    part.lipschitz = lipschitzIn(part);
    if (part.lipschitz) centers[count++] = part.box.center();
  }
  task_.solid.signedDistances(centers.first(count), values.first(count), {.threads = 1});
  count = 0;
  for (auto& part : parts) {
    if (part.lipschitz) {
      boundByLipschitz(part, OrientedBox<T>::of(part.box), values[count++]);
    } else {
      const auto range = task_.solid.bounds(part.box);
      part.isSettled = range.lower > task_.limit || range.upper < -task_.limit;
      part.sign = range.lower;
    }
  }
}

template <std::floating_point T>
bool TileFill<T>::isBeyondByLast(Part& part) const {
  const auto half = max(abs(part.box.lower - last_.point), abs(part.box.upper - last_.point));
  const auto around = OrientedBox<T>::of({last_.point - half, last_.point + half});
  if (last_.value == 0 || !task_.promise.lipschitz || !around.isWithin(task_.promise.domain)) {
    return false;
  }
  part.lipschitz = task_.promise.lipschitz;
  boundByLipschitz(part, around, last_.value);
  return part.isSettled;
}

template <std::floating_point T>
void TileFill<T>::boundByLipschitz(Part& part, const OrientedBox<T>& box, T atCenter) const {
  auto promise = task_.promise;
  promise.lipschitz = part.lipschitz;
  const auto range = boundsAround(atCenter, box, promise);
  const T missing = task_.limit - (atCenter < 0 ? -range.upper : range.lower);
  part.isSettled = missing < 0;
  part.sign = atCenter;
  // The bound for all within r of the centre exceeds that for all within box.radius() by the
  // Lipschitz constant times the difference, or more.
  constexpr T kOutward = 1 + 8 * std::numeric_limits<T>::epsilon();
  const T radius = box.radius() - kOutward * (missing / *part.lipschitz);
  part.center = box.center;
  if (radius > 0) part.beyondSquared = radius * radius / (kOutward * kOutward);
}

template <std::floating_point T>
void TileFill<T>::noteBeyond(const Beyond& part) {
  auto& run = beyond_.indices;
  const auto goesOn = [&](std::size_t axis) {
    return run.first[axis] == part.indices.first[axis] && run.size[axis] == part.indices.size[axis];
  };
  const bool isNext = run.first[0] + run.size[0] == part.indices.first[0] && goesOn(1) && goesOn(2);
  if (isNext && beyond_.isInside == part.isInside) {
    run.size[0] += part.indices.size[0];
  } else {
    fillBeyond();
    beyond_ = part;
  }
}

template <std::floating_point T>
void TileFill<T>::fillBeyond() {
  const auto& [indices, isInside] = beyond_;
  fillBox(task_.targets.distance, indices, isInside ? -task_.limit : task_.limit);
  fillBox(task_.targets.patch, indices, std::uint32_t{kNone});
  constexpr T kNaN = std::numeric_limits<T>::quiet_NaN();
  fillBox(task_.targets.closestPoint, indices, {kNaN, kNaN, kNaN});
  fillBox(task_.targets.normal, indices, {kNaN, kNaN, kNaN});
  beyond_ = {};
}

template <std::floating_point T>
void TileFill<T>::addPoints(const Part& part, int bits) {
  const bool hasOwnWay = task_.hasOwnWay && part.lipschitz == T(1);
  batch_.begin(hasOwnWay ? std::optional(typename PointBatch<T>::Known{part.center, part.sign})
                         : std::nullopt);
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
