#include <Cutwater/Tpms/FootPoint.hpp>
#include <Cutwater/Tpms/PatternDistance.hpp>

#include <algorithm>
#include <numbers>

namespace cutwater::detail {

namespace {

constexpr double kTwoPi = 2 * std::numbers::pi;
constexpr double kSqrt3 = std::numbers::sqrt3;

struct Cube {
  Vec3<double> center;  // relative to the point
  double half;

  [[nodiscard]] double distance() const {
    return length(max(abs(center) - Vec3<double>{half, half, half}, {}));
  }
  /// From a place to its farthest corner.
  [[nodiscard]] double farthestFrom(const Vec3<double>& place) const {
    return length(abs(center - place) + Vec3<double>{half, half, half});
  }
  /// Its octants, from the one that is farthest from the origin to the nearest.
  [[nodiscard]] Cube octant(int rank) const {
    Vec3<double> to;
    for (int axis = 0; axis < 3; ++axis) {
      const double inwards = center[axis] > 0 ? -1 : 1;
      to[axis] = (rank >> axis & 1) != 0 ? inwards : -inwards;
    }
    return {center + 0.5 * half * to, 0.5 * half};
  }
};

}  // namespace

/// One search around a point.
class SurfaceSearch {
 public:
  SurfaceSearch(const PatternDistance& pattern, const Vec3<double>& point, double reach)
      : pattern_(pattern), point_(point), best_(reach) {}

  double run() {
    const double reach = best_;
    if (isSettledFrom({})) return best_;
    // Depth first: at most seven octants wait on each level, and of a cube as small as a quarter of
    // the tolerance no octants are asked: 2^-40 of the first, by PatternDistance's constructor.
    constexpr std::size_t kDeepest = 40;
    std::array<Cube, 7 * kDeepest + 8> pending;
    std::size_t size = 0;
    pending[size++] = {{}, reach};
    while (size > 0) {
      const Cube cube = pending[--size];
      if (isFree(cube)) continue;
      if (kSqrt3 * cube.half < 0.25 * pattern_.tolerance_) {
        best_ = std::min(best_, length(cube.center));  // as good as surface
        continue;
      }
      if (cube.half < 0.5 * reach && isSettledFrom(cube.center)) return best_;
      for (int rank = 0; rank < 8; ++rank) pending[size++] = cube.octant(rank);
    }
    return best_;
  }

 private:
  static constexpr int kMostFeet = 12;

  [[nodiscard]] bool isFree(const Cube& cube) const {
    if (cube.distance() >= best_ - pattern_.tolerance_) return true;
    for (int i = 0; i < feetCount_; ++i) {
      const auto& foot = feet_[static_cast<std::size_t>(i)];
      if (cube.farthestFrom(foot.place - point_) <= foot.freeRadius) return true;
    }
    return pattern_.lowerBound(point_ + cube.center) >= kSqrt3 * cube.half;
  }

  /// Looks for a foot from a place, relative to the point. Whether it is certainly the nearest.
  bool isSettledFrom(const Vec3<double>& start) {
    if (feetCount_ == kMostFeet || triesLeft_-- <= 0) return false;
    const auto foot = footPoint(pattern_.pattern_, point_, point_ + start);
    if (!foot || foot->distance > 1.3 * best_) return false;
    for (int i = 0; i < feetCount_; ++i) {
      if (length(feet_[static_cast<std::size_t>(i)].place - foot->place) < 1e-6) return false;
    }
    feet_[static_cast<std::size_t>(feetCount_++)] = *foot;
    best_ = std::min(best_, foot->distance);
    return foot->freeRadius > 2 * foot->distance;
  }

  const PatternDistance& pattern_;
  Vec3<double> point_;
  double best_;
  std::array<FootPoint, kMostFeet> feet_{};
  int feetCount_ = 0;
  int triesLeft_ = 1000;
};

PatternDistance::PatternDistance(TpmsPattern pattern, double tolerance)
    : pattern_(pattern),
      terms_{.part = {.absolute = 1, .plain = 0, .level = 0, .half = 0},
             .weight = {1, 1, 1},
             .levelSlope = 0,
             .leastSlope = pattern.lipschitz() / 16,
             .perLipschitz = 1 / pattern.lipschitz(),
             .twiceCurvature = 2 * pattern.curvature(),
             .lengthPerRadian = 1},
      tolerance_(std::max(tolerance, 0x1p-36)) {}

double PatternDistance::lowerBound(const Vec3<double>& point) const {
  return levelDistance(pattern_.kind(), terms_, point / kTwoPi, 0.0);
}

double PatternDistance::upTo(double reach, const Vec3<double>& point) const {
  const double bound = lowerBound(point);
  return bound >= reach ? bound : SurfaceSearch(*this, point, reach).run();
}

}  // namespace cutwater::detail
