#include <Cutwater/Surface/Detail/LeafBoxes.hpp>

#include <algorithm>

namespace cutwater {

namespace {

constexpr double kHalf = 0x1p20;  // half the extent of a leaf
constexpr double kFar = 0x1p29;   // differences do not overflow

constexpr auto kBits = [] {
  std::array<std::int32_t, LeafBoxes::kWidth> bits{};
  for (std::size_t k = 0; k < bits.size(); ++k) bits[k] = std::int32_t{1} << k;
  return bits;
}();

/// A whole number surely below (direction -1) or above (1) a value: it is cut off towards zero, and
/// was off by less than 1 before.
std::int32_t outward(double value, int direction) {
  return static_cast<std::int32_t>(std::clamp(value, -kFar, kFar)) + 2 * direction;
}

}  // namespace

LeafBoxes::LeafBoxes(std::span<const Box<double>> boxes) {
  for (const auto& box : boxes) all_.extend(box);
  if (!all_.empty()) center_ = all_.center();
  for (int axis = 0; axis < 3; ++axis) {
    const double half = 0.5 * (all_.upper[axis] - all_.lower[axis]);
    scale_[axis] = half > 0x1p-900 ? kHalf / half : 0;
    auto& lower = lower_[static_cast<std::size_t>(axis)];
    auto& upper = upper_[static_cast<std::size_t>(axis)];
    for (std::size_t k = 0; k < kWidth; ++k) {
      const bool isUsed = k < boxes.size() && !boxes[k].empty();
      lower[k] = isUsed ? first(boxes[k], axis) : kNever;
      upper[k] = isUsed ? last(boxes[k], axis) : -kNever;
    }
  }
}

std::int32_t LeafBoxes::first(const Box<double>& box, int axis) const {
  return outward(scale_[axis] * (box.lower[axis] - center_[axis]), -1);
}
std::int32_t LeafBoxes::last(const Box<double>& box, int axis) const {
  return outward(scale_[axis] * (box.upper[axis] - center_[axis]), 1);
}

std::uint32_t LeafBoxes::meeting(const Box<double>& box) const {
  if (!all_.overlaps(box)) return 0;
  const std::array from{first(box, 0), first(box, 1), first(box, 2)};
  const std::array to{last(box, 0), last(box, 1), last(box, 2)};
  std::int32_t lanes = 0;
  // One loop without branches, which compilers vectorise.
  for (std::size_t k = 0; k < kWidth; ++k) {
    const std::int32_t gaps = (to[0] - lower_[0][k]) | (upper_[0][k] - from[0]) |
                              (to[1] - lower_[1][k]) | (upper_[1][k] - from[1]) |
                              (to[2] - lower_[2][k]) | (upper_[2][k] - from[2]);
    lanes |= ~(gaps >> 31) & kBits[k];  // negative: apart on an axis
  }
  return static_cast<std::uint32_t>(lanes);
}

}  // namespace cutwater
