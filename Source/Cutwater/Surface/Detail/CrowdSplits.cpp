#include <Cutwater/Core/Eigen.hpp>
#include <Cutwater/Surface/Detail/CrowdSplits.hpp>
#include <Cutwater/Triangles/ExactPredicates.hpp>

#include <algorithm>
#include <cmath>
#include <span>

#include <Eigen/Eigenvalues>

namespace cutwater {

namespace {

using Axes = std::array<Vec3<double>, 3>;

/// Through three points. Of these, `hubs` are vertices: they are on the plane by definition.
struct SplittingPlane {
  std::array<Vec3<double>, 3> points;
  std::array<std::uint32_t, 2> hubs{kNone, kNone};

  /// 1 or -1 if the triangle lies on that side, touching the plane at most in the hubs; else 0.
  [[nodiscard]] int sideOf(const PairTest& pairs, std::uint32_t triangle) const {
    int side = 0;
    for (const auto v : pairs.corners(triangle)) {
      if (v == hubs[0] || v == hubs[1]) continue;
      const int here = orientation(points[0], points[1], points[2], pairs.position(v));
      if (here == 0 || here == -side) return 0;
      side = here;
    }
    return side;
  }
};

/// How many triangles are on each side, and how many on both.
struct SideCounts {
  double before = 0;
  double behind = 0;
  double both = 0;

  void add(int side) { (side > 0 ? before : side < 0 ? behind : both) += 1; }
  /// The number of pairs that are left, as a share of all.
  [[nodiscard]] double work() const {
    const double all = before + behind + both;
    return ((before + both) * (before + both) + behind * (behind + 2 * both)) / (all * all);
  }
};

/// Orthonormal directions, by ascending variance.
Axes principalAxes(const Eigen::Matrix3d& scatter) {
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(scatter);
  const auto& axes = solver.eigenvectors();
  return {axes.col(0), axes.col(1), axes.col(2)};
}

Vec3<double> unit(const Vec3<double>& v) {
  const double size = length(v);
  return size > 0 ? v / size : Vec3<double>{};
}

Vec3<double> meanOf(std::span<const Vec3<double>> vectors) {
  Vec3<double> sum;
  for (const auto& v : vectors) sum += v;
  return sum / static_cast<double>(vectors.size());
}

/// The sum of v v^T over vectors from `mean` on.
Eigen::Matrix3d scatterOf(std::span<const Vec3<double>> vectors, const Vec3<double>& mean = {}) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const auto& v : vectors) {
    const Eigen::Vector3d d = toEigen(v - mean);
    sum += d * d.transpose();
  }
  return sum;
}

double medianOf(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The plane through the point with this normal.
SplittingPlane planeThrough(const Vec3<double>& point, const Vec3<double>& normal, double reach) {
  const Vec3<double> size = abs(normal);
  const Vec3<double> least = size.x <= size.y && size.x <= size.z ? Vec3<double>{1, 0, 0}
                             : size.y <= size.z                   ? Vec3<double>{0, 1, 0}
                                                                  : Vec3<double>{0, 0, 1};
  const Vec3<double> u = unit(cross(normal, least));
  const Vec3<double> v = unit(cross(normal, u));
  return {{point, point + reach * u, point + reach * v}};
}

/// Looks for the plane that leaves the least work, as a sample of the triangles tells.
class PlaneSearch {
 public:
  PlaneSearch(const PairTest& pairs, const Crowd& crowd) : pairs_(pairs) {
    const std::size_t step = std::max<std::size_t>(1, crowd.size() / kMostInSample);
    for (std::size_t i = step / 2; i < crowd.size(); i += step) {
      const bool isMember = i < crowd.members.size();
      sample_.push_back(isMember ? crowd.members[i] : crowd.guests[i - crowd.members.size()]);
    }
    for (const auto t : sample_) {
      const auto& [a, b, c] = pairs.corners(t);
      const auto& p = pairs.position(a);
      const Vec3<double> ab = pairs.position(b) - p;
      const Vec3<double> ac = pairs.position(c) - p;
      middles_.push_back(p + (ab + ac) / 3.0);
      edges_.insert(edges_.end(), {ab, ac, ac - ab});
    }
    middle_ = meanOf(middles_);
    for (const auto& m : middles_) reach_ = std::max(reach_, length(m - middle_));
  }

  std::optional<SplittingPlane> best() {
    tryHubs();
    if (leastWork_ > kWellSplit) tryDirections();
    if (leastWork_ > kWorthwhile) return {};
    return best_;
  }

 private:
  static constexpr std::size_t kMostInSample = 96;
  static constexpr double kHalved = 0.65;
  static constexpr double kWellSplit = 0.6;
  static constexpr double kWorthwhile = 0.85;

  void consider(const SplittingPlane& plane) {
    SideCounts counts;
    for (const auto t : sample_) counts.add(plane.sideOf(pairs_, t));
    if (counts.work() >= leastWork_) return;
    leastWork_ = counts.work();
    best_ = plane;
  }

  /// Planes across the directions in which triangles, or their places, extend least and most.
  void tryDirections() {
    const Axes long3 = principalAxes(scatterOf(edges_));
    const Axes far3 = principalAxes(scatterOf(middles_, middle_));
    for (const auto& normal : {long3[0], long3[1], long3[2], far3[2]}) {
      std::vector<double> heights;
      for (const auto& m : middles_) heights.push_back(dot(normal, m - middle_));
      consider(planeThrough(middle_ + medianOf(heights) * normal, normal, reach_));
    }
  }

  /// Planes through the vertices that many of the triangles share.
  void tryHubs() {
    const auto [first, second] = hubs();
    if (first == kNone) return;
    const bool hasAxis = second != kNone && pairs_.position(first) != pairs_.position(second);
    if (hasAxis && pairs_.isFlat(first) && pairs_.isFlat(second)) {
      tryAxis(first, second);
      if (leastWork_ <= kHalved) return;  // two fans that close a surface
    }
    tryHub(first);
    if (!hasAxis) return;
    tryHub(second);
    tryAxis(first, second);
  }

  /// The two vertices that most triangles share; kNone unless at least an eighth does.
  [[nodiscard]] std::array<std::uint32_t, 2> hubs() const {
    std::vector<std::uint32_t> vertices;
    for (const auto t : sample_) {
      const auto& corners = pairs_.corners(t);
      vertices.insert(vertices.end(), corners.begin(), corners.end());
    }
    std::ranges::sort(vertices);
    std::array<std::uint32_t, 2> most{kNone, kNone};
    std::array<std::ptrdiff_t, 2> counts{};
    const auto least = static_cast<std::ptrdiff_t>(std::max<std::size_t>(3, sample_.size() / 8));
    for (auto begin = vertices.begin(); begin != vertices.end();) {
      const auto end = std::upper_bound(begin, vertices.end(), *begin);
      const std::ptrdiff_t count = end - begin;
      if (count >= least && count > counts[1]) {
        most[1] = *begin;
        counts[1] = count;
        if (counts[1] > counts[0]) std::swap(most[0], most[1]), std::swap(counts[0], counts[1]);
      }
      begin = end;
    }
    return most;
  }

  /// Directions from the hub to the middles of the triangles.
  [[nodiscard]] std::vector<Vec3<double>> directionsFrom(const Vec3<double>& hub) const {
    std::vector<Vec3<double>> directions;
    for (const auto& m : middles_) directions.push_back(unit(m - hub));
    return directions;
  }

  /// How far the triangles extend, as seen from the hub: the differences of directions.
  [[nodiscard]] std::vector<Vec3<double>> spansFrom(std::uint32_t hub) const {
    std::vector<Vec3<double>> spans;
    for (const auto t : sample_) {
      const auto& [a, b, c] = pairs_.corners(t);
      const auto direction = [&](auto v) {
        return unit(pairs_.position(v) - pairs_.position(hub));
      };
      spans.push_back(direction(a == hub ? b : a) - direction(c == hub ? b : c));
    }
    return spans;
  }

  /// Among planes that contain a line in the direction `mean`, the one that has as many directions
  /// on the one side as on the other, turned from the normal `normal`. Returns its normal.
  static Vec3<double> halvingNormal(std::span<const Vec3<double>> directions,
                                    const Vec3<double>& mean, const Vec3<double>& normal) {
    std::vector<double> slopes;
    for (const auto& u : directions) {
      const double along = dot(mean, u);
      if (along < 0.05) return normal;
      slopes.push_back(dot(normal, u) / along);
    }
    return unit(normal - medianOf(slopes) * mean);
  }

  void tryHub(std::uint32_t hub) {
    const auto& here = pairs_.position(hub);
    const auto directions = directionsFrom(here);
    const Vec3<double> mean = meanOf(directions);
    const auto [p, q, r] = principalAxes(scatterOf(directions, mean));
    const Vec3<double> across = principalAxes(scatterOf(spansFrom(hub)))[0];
    const Vec3<double> ahead = unit(mean);
    for (const auto& axis : {p, q, r, across}) {
      const Vec3<double> normal = unit(axis - dot(axis, ahead) * ahead);
      if (normal == Vec3<double>{}) continue;
      auto plane = planeThrough(here, halvingNormal(directions, ahead, normal), reach_);
      plane.hubs[0] = hub;
      consider(plane);
    }
  }

  void tryAxis(std::uint32_t first, std::uint32_t second) {
    const auto& here = pairs_.position(first);
    const Vec3<double> axis = unit(pairs_.position(second) - here);
    auto directions = directionsFrom(here);
    for (auto& u : directions) u = unit(u - dot(axis, u) * axis);
    Vec3<double> ahead = unit(meanOf(directions));
    ahead = unit(ahead - dot(axis, ahead) * axis);
    const Vec3<double> normal = halvingNormal(directions, ahead, cross(axis, ahead));
    for (const auto& across : {cross(normal, axis), normal}) {
      consider({{here, pairs_.position(second), here + reach_ * across}, {first, second}});
    }
  }

  const PairTest& pairs_;
  std::vector<std::uint32_t> sample_;
  std::vector<Vec3<double>> middles_;
  std::vector<Vec3<double>> edges_;
  Vec3<double> middle_;
  double reach_ = 0;
  double leastWork_ = 2;
  SplittingPlane best_;
};

/// Triangles on each side of a plane, and on both.
struct Sides {
  std::vector<std::uint32_t> before;
  std::vector<std::uint32_t> behind;
  std::vector<std::uint32_t> both;
};

Sides sidesOf(const PairTest& pairs, const SplittingPlane& plane,
              std::span<const std::uint32_t> triangles) {
  Sides sides;
  for (const auto t : triangles) {
    const int side = plane.sideOf(pairs, t);
    (side > 0 ? sides.before : side < 0 ? sides.behind : sides.both).push_back(t);
  }
  return sides;
}

std::vector<std::uint32_t> merged(std::span<const std::uint32_t> a,
                                  std::span<const std::uint32_t> b) {
  std::vector<std::uint32_t> result;
  result.reserve(a.size() + b.size());
  std::ranges::merge(a, b, std::back_inserter(result));
  return result;
}

}  // namespace

std::optional<std::array<Crowd, 3>> split(const PairTest& pairs, const Crowd& crowd) {
  const auto plane = PlaneSearch(pairs, crowd).best();
  if (!plane) return {};
  const Sides members = sidesOf(pairs, *plane, crowd.members);
  const Sides guests = sidesOf(pairs, *plane, crowd.guests);
  // Pairs of triangles on both sides go with those before the plane.
  const auto guestsBehind = merged(guests.behind, guests.both);
  std::array<Crowd, 3> parts{
      Crowd{merged(members.before, members.both), merged(guests.before, guests.both), crowd.within},
      Crowd{members.behind, crowd.within ? merged(members.both, guestsBehind) : guestsBehind,
            crowd.within},
      Crowd{members.both, guests.behind, false}};
  // The sample may have misled.
  const std::size_t most = crowd.size() - 1 - crowd.size() / 16;
  const auto isSmaller = [&](const Crowd& part) { return part.size() <= most; };
  if (!std::ranges::all_of(parts, isSmaller)) return {};
  return parts;
}

}  // namespace cutwater
