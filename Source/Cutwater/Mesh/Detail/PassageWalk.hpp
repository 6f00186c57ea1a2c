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
  PassageWalk(const TriangleSurface<T>& surface, const Segment<double>& segment,
              TrianglesAlong along)
      : surface_(surface), segment_(segment), along_(along) {}

  /// Returns the next passage; after the last, one without a triangle.
  [[nodiscard]] Passage next();

 private:
  static constexpr std::size_t kBatch = 64;

  void fetch();
  [[nodiscard]] double insert(const Passage& passage);

  const TriangleSurface<T>& surface_;
  Segment<double> segment_;
  TrianglesAlong along_;
  std::array<Passage, kBatch> batch_;  // in order
  std::size_t count_ = 0;
  std::size_t at_ = 0;
  Passage last_{.parameter = -1, .triangle = 0, .direction = 0};  // of all earlier batches
  bool isComplete_ = false;  // nothing is left beyond the batch
};

extern template class PassageWalk<float>;
extern template class PassageWalk<double>;

}  // namespace cutwater
