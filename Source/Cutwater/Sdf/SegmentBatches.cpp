#include <Cutwater/Core/Detail/ParallelBatches.hpp>
#include <Cutwater/Core/Detail/Scratch.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Sdf/SignedDistanceFunction.hpp>

#include <algorithm>

// Batches of segments.

namespace cutwater {

namespace {

/// Segments that a thread takes at a time; each may cost as much as many points.
constexpr std::size_t kSegmentBatch = 64;

template <std::floating_point T>
bool isFiniteSegment(const Segment<T>& segment) {
  return isFinite(segment.start) && isFinite(segment.end);
}

/// A crossing of one of the segments of a batch.
template <std::floating_point T>
struct NumberedCrossing {
  std::size_t segment;
  Crossing<T> crossing;
};

}  // namespace

template <std::floating_point T>
void SignedDistanceFunction<T>::toLocal(std::span<const Segment<T>> segments,
                                        std::span<Segment<T>> local) const {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const auto& [start, end] = segments[i];
    local[i] = isFiniteSegment(segments[i])
                   ? Segment<T>{placement_.toLocal(start), placement_.toLocal(end)}
                   : Segment<T>{};
  }
}

template <std::floating_point T>
void SignedDistanceFunction<T>::firstHits(std::span<const Segment<T>> segments,
                                          std::span<FirstHit<T>> hits,
                                          const ParallelOptions& options) const {
  require(segments.size() == hits.size(), "firstHits: need one hit per segment",
          Named{"segments", segments.size()}, Named{"hits", hits.size()});
  const auto visit = [&](std::size_t first, std::size_t count) {
    const auto some = segments.subspan(first, count);
    const auto found = hits.subspan(first, count);
    Scratch<Segment<T>, kSegmentBatch> local;
    toLocal(some, local.first(count));
    localFirstHits(local.first(count), found);
    for (std::size_t i = 0; i < count; ++i) {
      if (!isFiniteSegment(some[i])) found[i] = {};
      if (found[i].found) found[i].crossing = toWorld(found[i].crossing);
    }
  };
  detail::parallelBatches(segments.size(), kSegmentBatch, options, visit);
}

template <std::floating_point T>
void SignedDistanceFunction<T>::localFirstHits(std::span<const Segment<T>> segments,
                                               std::span<FirstHit<T>> hits) const {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    FirstHit<T> hit;
    const auto take = [&](const Crossing<T>& crossing) {
      hit.crossing = crossing;
      return false;
    };
    const auto [found, unresolved] = localCrossings(segments[i], take);
    hit.found = found > 0;
    hit.unresolved = unresolved;
    hits[i] = hit;
  }
}

template <std::floating_point T>
void SignedDistanceFunction<T>::localCrossingsOfEach(std::span<const Segment<T>> segments,
                                                     std::span<CrossingCount> counts,
                                                     CrossingsVisitor<T> visit) const {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    counts[i] = localCrossings(segments[i], [&](const Crossing<T>& crossing) {
      visit(i, crossing);
      return true;
    });
  }
}

template <std::floating_point T>
CrossingLists<T> SignedDistanceFunction<T>::crossings(std::span<const Segment<T>> segments,
                                                      const ParallelOptions& options) const {
  CrossingLists<T> lists;
  lists.offsets.resize(segments.size() + 1);
  lists.unresolved.resize(segments.size());
  // Those of each batch, which are joined in the order of the segments.
  std::vector<std::vector<NumberedCrossing<T>>> batches((segments.size() + kSegmentBatch - 1) /
                                                        kSegmentBatch);
  const auto visit = [&](std::size_t first, std::size_t count) {
    auto& batch = batches[first / kSegmentBatch];
    Scratch<Segment<T>, kSegmentBatch> local;
    Scratch<CrossingCount, kSegmentBatch> counts;
    toLocal(segments.subspan(first, count), local.first(count));
    localCrossingsOfEach(local.first(count), counts.first(count),
                         [&](std::size_t i, const Crossing<T>& crossing) {
                           if (!isFiniteSegment(segments[first + i])) return;
                           batch.push_back({i, toWorld(crossing)});
                           ++lists.offsets[first + i + 1];
                         });
    for (std::size_t i = 0; i < count; ++i) {
      lists.unresolved[first + i] = isFiniteSegment(segments[first + i]) ? counts[i].unresolved : 0;
    }
    std::ranges::stable_sort(batch, {}, &NumberedCrossing<T>::segment);
  };
  detail::parallelBatches(segments.size(), kSegmentBatch, options, visit);
  for (std::size_t i = 0; i < segments.size(); ++i) lists.offsets[i + 1] += lists.offsets[i];
  lists.crossings.reserve(lists.offsets.back());
  for (auto& batch : batches) {
    for (const auto& each : batch) lists.crossings.push_back(each.crossing);
    batch = {};
  }
  return lists;
}

// NOLINTBEGIN(bugprone-macro-parentheses): a type
#define CUTWATER_INSTANTIATE(T)                                                               \
  template void SignedDistanceFunction<T>::toLocal(std::span<const Segment<T>>,               \
                                                   std::span<Segment<T>>) const;              \
  template void SignedDistanceFunction<T>::firstHits(                                         \
      std::span<const Segment<T>>, std::span<FirstHit<T>>, const ParallelOptions&) const;     \
  template void SignedDistanceFunction<T>::localFirstHits(std::span<const Segment<T>>,        \
                                                          std::span<FirstHit<T>>) const;      \
  template void SignedDistanceFunction<T>::localCrossingsOfEach(                              \
      std::span<const Segment<T>>, std::span<CrossingCount>, CrossingsVisitor<T>) const;      \
  template CrossingLists<T> SignedDistanceFunction<T>::crossings(std::span<const Segment<T>>, \
                                                                 const ParallelOptions&) const;
// NOLINTEND(bugprone-macro-parentheses)
CUTWATER_INSTANTIATE(float)
CUTWATER_INSTANTIATE(double)
#undef CUTWATER_INSTANTIATE

}  // namespace cutwater
