#pragma once

#include <Cutwater/Core/Detail/Batches.hpp>
#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Core/Vec3.hpp>

#include <span>

namespace cutwater::detail {

/// Maps the points into an operand's frame by image(p), and calls batch(images, index of the first)
/// for one piece of them after the other.
template <std::floating_point T, typename Image, typename Batch>
void forImages(std::span<const Vec3<T>> points, const Image& image, const Batch& batch) {
  constexpr std::size_t kMost = 256;
  Scratch<Vec3<T>, kMost> images;
  forBatches(points.size(), kMost, [&](std::size_t first, std::size_t count) {
    const auto from = points.subspan(first, count);
    const auto some = images.first(count);
    const Image map = image;  // here, calls within the loop cannot change it
    for (std::size_t i = 0; i < count; ++i) some[i] = map(from[i]);
    batch(std::span<const Vec3<T>>(some), first);
  });
}

}  // namespace cutwater::detail
