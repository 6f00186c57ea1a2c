#include <Cutwater/Core/Detail/ParallelBatches.hpp>
#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <algorithm>

// Batches of boxes.

namespace cutwater {

namespace {

/// Boxes are passed to the shapes in batches of this size, whose local copies fit the L1 cache.
constexpr std::size_t kBoxBatch = 256;

}  // namespace

template <std::floating_point T>
void SignedDistanceFunction<T>::classify(std::span<const Box<T>> boxes, std::span<BoxClass> classes,
                                         std::span<BoxHint> hints,
                                         const ParallelOptions& options) const {
  require(boxes.size() == classes.size(), "classify: need one class per box",
          Named{"boxes", boxes.size()}, Named{"classes", classes.size()});
  require(hints.empty() || hints.size() == boxes.size(), "classify: need one hint per box, or none",
          Named{"boxes", boxes.size()}, Named{"hints", hints.size()});
  const auto visit = [&](std::size_t first, std::size_t count) {
    const auto some = boxes.subspan(first, count);
    const auto found = classes.subspan(first, count);
    const auto known = hints.empty() ? hints : hints.subspan(first, count);
    const auto isUsual = [](const Box<T>& box) { return !box.empty() && isFinite(box); };
    if (std::ranges::all_of(some, isUsual)) {
      Scratch<OrientedBox<T>, kBoxBatch> local;
      for (std::size_t i = 0; i < count; ++i) local[i] = toLocal(some[i]);
      localClasses(local.first(count), found, known);
    } else {
      for (std::size_t i = 0; i < count; ++i) {
        found[i] = classify(some[i], known.empty() ? nullptr : &known[i]);
      }
    }
  };
  detail::parallelBatches(boxes.size(), kBoxBatch, options, visit);
}

template <std::floating_point T>
void SignedDistanceFunction<T>::localClasses(std::span<const OrientedBox<T>> boxes,
                                             std::span<BoxClass> classes,
                                             std::span<BoxHint> hints) const {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    classes[i] = localClassify(boxes[i], hints.empty() ? nullptr : &hints[i]);
  }
}

template void SignedDistanceFunction<float>::classify(std::span<const Box<float>>,
                                                      std::span<BoxClass>, std::span<BoxHint>,
                                                      const ParallelOptions&) const;
template void SignedDistanceFunction<float>::localClasses(std::span<const OrientedBox<float>>,
                                                          std::span<BoxClass>,
                                                          std::span<BoxHint>) const;
template void SignedDistanceFunction<double>::classify(std::span<const Box<double>>,
                                                       std::span<BoxClass>, std::span<BoxHint>,
                                                       const ParallelOptions&) const;
template void SignedDistanceFunction<double>::localClasses(std::span<const OrientedBox<double>>,
                                                           std::span<BoxClass>,
                                                           std::span<BoxHint>) const;

}  // namespace cutwater
