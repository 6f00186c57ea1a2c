#pragma once

#include <Cutwater/Mesh/Detail/ClippedSegment.hpp>
#include <Cutwater/Mesh/Detail/PassageWalk.hpp>
#include <Cutwater/Mesh/Detail/PointAnswers.hpp>

namespace cutwater {

/// What a mesh answers about segments: see PointAnswers.
template <std::floating_point T, typename Index>
class SegmentAnswers {
 public:
  explicit SegmentAnswers(const Index& index) : index_(index), points_(index) {}

  /// See SignedDistanceFunction::localCrossings(), and MeshCrossings.hpp.
  CrossingCount crossings(const Segment<T>& segment, CrossingVisitor<T> visit) const {
    return crossings(segment, visit, PassageWalk<T>::kBatch);
  }
  /// The first of them. Triangles behind it are not looked at, as far as the tree allows.
  [[nodiscard]] FirstHit<T> firstHit(const Segment<T>& segment) const;

 private:
  CrossingCount crossings(const Segment<T>& segment, CrossingVisitor<T> visit,
                          std::size_t atOnce) const;
  /// The segment, in scaled units. Ends that are far are moved along it towards the surface, not
  /// beyond any crossing.
  [[nodiscard]] ClippedSegment nearPart(const Segment<T>& segment) const;

  const Index& index_;
  PointAnswers<T, Index> points_;
};

}  // namespace cutwater
