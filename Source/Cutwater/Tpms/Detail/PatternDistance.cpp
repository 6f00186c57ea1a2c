#include <Cutwater/Tpms/Detail/Constants.hpp>
#include <Cutwater/Tpms/Detail/CubeInBall.hpp>
#include <Cutwater/Tpms/Detail/FootPoint.hpp>
#include <Cutwater/Tpms/Detail/PatternDistance.hpp>

#include <algorithm>
#include <numbers>

namespace cutwater::detail {

namespace {

constexpr double kSqrt3 = std::numbers::sqrt3;

struct Cube {
  Vec3<double> center;  // relative to the point
  double half;

  [[nodiscard]] double distance() const {
    return length(max(abs(center) - Vec3<double>{half, half, half}, {}));
  }
  /// Distance from a place to the farthest corner.
  [[nodiscard]] double farthestFrom(const Vec3<double>& place) const {
    return length(abs(center - place) + Vec3<double>{half, half, half});
  }
  /// The octants by rank, from the one that is farthest from the origin to the nearest.
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
  /// Searches a ball of radius `reach`, in which one of radius `free` is known to contain no
  /// surface.
  SurfaceSearch(const PatternDistance& pattern, const Vec3<double>& point, double reach,
                double free)
      : pattern_(pattern), point_(point), best_(reach) {
    addFreeBall({{}, free});
  }

  double run() {
    const Cube all{{}, best_};
    if (isSettledFrom({})) return best_;
    side_ = pattern_.pattern_.value(point_ / kTwoPi<double>) < 0 ? -1 : 1;
    // Depth first: at most seven octants wait on each level, and cubes as small as a quarter of the
    // tolerance are not divided: 2^-40 of the first, by PatternDistance's constructor.
    constexpr std::size_t kDeepest = 40;
    std::array<Cube, 7 * kDeepest + 8> pending;
    std::size_t size = 0;
    pending[size++] = all;
    while (size > 0 && !isSettled_) {
      const Cube cube = pending[--size];
      if (isPassed(cube)) continue;
      if (kSqrt3 * cube.half < 0.25 * pattern_.tolerance_) {
        best_ = std::min(best_, length(cube.center));  // counts as surface
        continue;
      }
      size += openOctants(cube, std::span(pending).subspan(size));
    }
    return best_;
  }

 private:
  struct Ball {
    Vec3<double> center;  // relative to the point
    double radius;
  };

  /// Surface within this radius would be nearer than the tolerance allows.
  [[nodiscard]] double radius() const { return best_ - pattern_.tolerance_; }

  void addFreeBall(const Ball& ball) {
    if (freeCount_ < free_.size()) free_[freeCount_++] = ball;
  }

  /// Whether the cube is beyond what is searched, or inside a free ball.
  [[nodiscard]] bool isPassed(const Cube& cube) const {
    if (cube.distance() >= radius()) return true;
    return std::any_of(free_.begin(), free_.begin() + freeCount_, [&](const Ball& ball) {
      return cube.farthestFrom(ball.center) <= ball.radius;
    });
  }

  /// Finds the octants of a cube that may contain nearer surface, the nearest last, and returns
  /// their number.
  std::size_t openOctants(const Cube& cube, std::span<Cube> open) {
    std::array<Vec3<double>, 8> places;
    std::size_t count = 0;
    for (int rank = 0; rank < 8; ++rank) {
      open[count] = cube.octant(rank);
      if (!isPassed(open[count])) {
        places[count] = point_ + open[count].center;
        ++count;
      }
    }
    std::array<PatternExpansion, 8> found;
    expandPattern(pattern_.pattern_, places, {found.data(), count});
    std::size_t left = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const CubeInBall part{open[i].center, open[i].half, radius()};
      if (isOnOneSide(part, pattern_.pattern_, found[i], side_)) continue;
      if (side_ * found[i].value < -kRounding) passSurface(open[i].center);
      open[left++] = open[i];
    }
    return left;
  }

  /// Handles a place on the other side: there is surface on the way.
  void passSurface(const Vec3<double>& place) {
    best_ = std::min(best_, length(place));
    isSettled_ = isSettled_ || isSettledFrom(place);
  }

  /// Looks for a foot point from a place, relative to the point. Returns whether it is certainly
  /// the nearest.
  bool isSettledFrom(const Vec3<double>& start) {
    const auto foot = footPoint(pattern_.pattern_, point_, point_ + start);
    if (!foot) return false;
    best_ = std::min(best_, foot->distance);
    addFreeBall({foot->place - point_, foot->freeRadius});
    return foot->freeRadius > 2 * foot->distance;
  }

  static constexpr double kRounding = 1e-12;

  const PatternDistance& pattern_;
  Vec3<double> point_;
  double best_;
  double side_ = 1;  // the sign of F at the point
  bool isSettled_ = false;
  std::array<Ball, 12> free_{};
  std::size_t freeCount_ = 0;
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
  return levelDistance(pattern_.kind(), terms_, point / kTwoPi<double>, 0.0);
}

double PatternDistance::upTo(double reach, const Vec3<double>& point) const {
  const double bound = lowerBound(point);
  return bound >= reach ? bound : SurfaceSearch(*this, point, reach, bound).run();
}

}  // namespace cutwater::detail
