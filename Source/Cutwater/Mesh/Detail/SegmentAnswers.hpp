#pragma once

#include <Cutwater/Mesh/Detail/ClippedSegment.hpp>
#include <Cutwater/Mesh/Detail/PointAnswers.hpp>

namespace cutwater {

/// What a mesh answers about segments: see PointAnswers.
template <std::floating_point T, typename Index>
class SegmentAnswers {
 public:
  explicit SegmentAnswers(const Index& index) : index_(index), points_(index) {}

  /// See SignedDistanceFunction::localCrossings(), and MeshCrossings.hpp.
  CrossingCount crossings(const Segment<T>& segment, CrossingVisitor<T> visit) const;

 private:
  /// The segment, in scaled units. Ends that are far are moved along it towards the surface, not
  /// beyond any crossing.
  [[nodiscard]] ClippedSegment nearPart(const Segment<T>& segment) const;

  const Index& index_;
  PointAnswers<T, Index> points_;
};

}  // namespace cutwater
