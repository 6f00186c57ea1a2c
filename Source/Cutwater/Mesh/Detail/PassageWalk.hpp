#pragma once

#include <Cutwater/Triangles/SurfaceLocation.hpp>

namespace cutwater {

/// Where a segment passes through a triangle.
struct Passage {
  double parameter = 0;  ///< 0 at the segment's start, 1 at its end
  std::uint32_t triangle = kNone;
  int direction = 0;  ///< 1 from back to front, -1 from front to back
};

/// The passages of a segment through a surface, one after the other, in the order of their computed
/// parameters (of equal ones, the lowest triangle first). Which passages there are is exact; their
/// parameters are rounded. They are found in batches of fixed size, so nothing is allocated however
/// many there are.
template <std::floating_point T>
class PassageWalk {
 public:
  static constexpr std::size_t kBatch = 64;

  /// `first`, at most kBatch: how many are sought before the others. If few are wanted, the search
  /// ends sooner; the answers are the same.
  PassageWalk(const TriangleSurface<T>& surface, const Segment<double>& segment,
              TrianglesAlong along, std::size_t first = kBatch)
      : surface_(surface), segment_(segment), along_(along), most_(first) {}

  /// Returns the next passage; after the last, one without a triangle.
  [[nodiscard]] Passage next();

 private:
  void fetch();
  [[nodiscard]] double insert(const Passage& passage);

  const TriangleSurface<T>& surface_;
  Segment<double> segment_;
  TrianglesAlong along_;
  std::size_t most_;                   // that the next batch may hold
  std::array<Passage, kBatch> batch_;  // in order
  std::size_t count_ = 0;
  std::size_t at_ = 0;
  Passage last_{.parameter = -1, .triangle = 0, .direction = 0};  // of all earlier batches
  bool isComplete_ = false;  // nothing is left beyond the batch
};

extern template class PassageWalk<float>;
extern template class PassageWalk<double>;

}  // namespace cutwater
