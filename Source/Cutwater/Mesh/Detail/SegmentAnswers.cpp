#include <Cutwater/Mesh/Detail/DcelIndex.hpp>
#include <Cutwater/Mesh/Detail/MeshCrossings.hpp>
#include <Cutwater/Mesh/Detail/MeshIndex.hpp>
#include <Cutwater/Mesh/Detail/SegmentAnswers.hpp>

namespace cutwater {

template <std::floating_point T, typename Index>
CrossingCount SegmentAnswers<T, Index>::crossings(const Segment<T>& segment,
                                                  CrossingVisitor<T> visit,
                                                  std::size_t atOnce) const {
  const Segment<T> ends{points_.scaled(segment.start), points_.scaled(segment.end)};
  if (ends.start == ends.end) return {};
  const auto near = nearPart(segment);
  const auto restored = [&](Crossing<T> crossing) {
    crossing.parameter =
        static_cast<T>(near.start + double{crossing.parameter} * (near.end - near.start));
    return visit(crossing);
  };
  const bool byWinding = index_.signJumps() && index_.signs().scheme == SignScheme::WindingNumber;
  return meshCrossings<T>({.surface = index_.surface(),
                           .along = index_.trianglesAlong(),
                           .nearest = [this](const Vec3<T>& p) { return index_.nearest(p); },
                           .isInside = [this](const Vec3<T>& p) { return points_.isInside(p); },
                           .winding = byWinding ? index_.winding() : nullptr,
                           .isClosed = !index_.signJumps()},
                          {.ends = ends, .searched = near.part, .atOnce = atOnce}, restored);
}

template <std::floating_point T, typename Index>
FirstHit<T> SegmentAnswers<T, Index>::firstHit(const Segment<T>& segment) const {
  FirstHit<T> hit;
  const auto take = [&](const Crossing<T>& crossing) {
    hit.crossing = crossing;
    return false;
  };
  // On a closed surface without overlaps, the first passage is the first crossing.
  const auto [found, unresolved] = crossings(segment, take, 1);
  hit.found = found > 0;
  hit.unresolved = unresolved;
  return hit;
}

template <std::floating_point T, typename Index>
ClippedSegment SegmentAnswers<T, Index>::nearPart(const Segment<T>& segment) const {
  constexpr double kNear = 0x1p20;  // beyond, rounding would be coarse relative to the surface
  const double scale{index_.surface().scale};
  const auto& solidBox = index_.solidBox();
  const bool isBounded = !index_.signJumps() || index_.signs().scheme == SignScheme::WindingNumber;
  // By pseudonormals the sign may change anywhere.
  Box<double> box =
      isBounded
          ? Box<double>{Vec3<double>(solidBox.lower), Vec3<double>(solidBox.upper)}.grown(1 / scale)
          : Box<double>{}.extend(Vec3<double>{}).grown(kNear / scale);
  const Segment<double> whole{Vec3<double>(segment.start), Vec3<double>(segment.end)};
  for (const auto& p : {whole.start, whole.end}) {
    if (maxComponent(abs(scale * p)) <= kNear) box.extend(p);
  }
  // Far ends without anything in between do not meet the surface: then, one of them.
  const Vec3<double> start(points_.scaled(segment.start));
  auto result = clipped(whole, box);
  if (!result) return {{start, start}};
  result->part = {scale * result->part.start, scale * result->part.end};
  return *result;
}

template class SegmentAnswers<float, MeshIndex<float>>;
template class SegmentAnswers<double, MeshIndex<double>>;
template class SegmentAnswers<float, DcelIndex<float>>;
template class SegmentAnswers<double, DcelIndex<double>>;

}  // namespace cutwater
