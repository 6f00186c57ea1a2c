#include <Cutwater/Core/Eigen.hpp>
#include <Cutwater/Grid/Detail/SharpFeatures.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include <Eigen/Eigenvalues>

namespace cutwater::detail {

namespace {

/// How far outside a cell an edge may pass and still be represented by the nearest point in the
/// cell, in cell diagonals.
constexpr double kFarthest = 0.25;

Vec3<double> fromEigen(const Eigen::Vector3d& v) {
  return {v[0], v[1], v[2]};
}

/// The part of a line in a box, by the slab method: from + t along, for t in the interval.
Interval<double> partIn(const Box<double>& box, const Vec3<double>& from,
                        const Vec3<double>& along) {
  Interval<double> part{-Box<double>::kInf, Box<double>::kInf};
  for (int axis = 0; axis < 3; ++axis) {
    const double a = (box.lower[axis] - from[axis]) / along[axis];
    const double b = (box.upper[axis] - from[axis]) / along[axis];
    // NaN, from 0 / 0, bounds nothing.
    part.lower = std::max(part.lower, std::min(a, b));
    part.upper = std::min(part.upper, std::max(a, b));
  }
  return part;
}

/// Where planes meet: the points with the least sum of squared distances from them. Directions that
/// the planes hardly constrain, as along an edge, are free.
class PlanesMeeting {
 public:
  explicit PlanesMeeting(const Vec3<double>& center) : center_(center) {}

  void add(const Vec3<double>& point, const Vec3<double>& normal) {
    const auto n = toEigen(normal);
    matrix_ += n * n.transpose();
    right_ += n * dot(normal, point - center_);
  }
  /// The point nearest to the centre; if the points form a line that passes through the box, one in
  /// it.
  [[nodiscard]] Vec3<double> pointIn(const Box<double>& box) const {
    // For normals 30 degrees apart, the smaller eigenvalue is 0.07 of the larger one.
    constexpr double kLeast = 0.02;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix_);
    const auto& values = solver.eigenvalues();
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    for (int i = 0; i < 3; ++i) {
      if (values[i] < kLeast * values[2]) continue;
      const Eigen::Vector3d along = solver.eigenvectors().col(i);
      offset += along.dot(right_) / values[i] * along;
    }
    const auto nearest = center_ + fromEigen(offset);
    const bool isLine = values[0] < kLeast * values[2] && values[1] >= kLeast * values[2];
    if (!isLine || box.contains(nearest)) return nearest;
    const auto along = fromEigen(solver.eigenvectors().col(0));
    const auto part = partIn(box, nearest, along);
    return part.lower > part.upper ? nearest
                                   : nearest + std::clamp(0.0, part.lower, part.upper) * along;
  }

 private:
  Vec3<double> center_;
  Eigen::Matrix3d matrix_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_ = Eigen::Vector3d::Zero();
};

/// The face of the cell beyond which an outside point lies: in the pyramid from that face to the
/// middle of the cell beyond. Pyramids of different cells do not overlap.
std::optional<CellFace> faceBefore(const Box<double>& cell, const Vec3<double>& point) {
  std::optional<CellFace> face;
  double beyond = 0;
  double inset = 0.5;
  for (int axis = 0; axis < 3; ++axis) {
    const double place = (point[axis] - cell.lower[axis]) / (cell.upper[axis] - cell.lower[axis]);
    const double within = std::min(place, 1 - place);
    if (within >= 0) {
      inset = std::min(inset, within);
    } else if (face) {
      return std::nullopt;
    } else {
      face = {axis, place > 0.5};
      beyond = -within;
    }
  }
  return beyond < inset ? face : std::nullopt;
}

}  // namespace

template <std::floating_point T>
SharpFeatures<T>::SharpFeatures(const SignedDistanceFunction<T>& solid, double degrees)
    : solid_(solid),
      leastCosine_(degrees < 180 ? std::cos(degrees * std::numbers::pi / 180) : -1) {}

template <std::floating_point T>
std::optional<Vec3<double>> SharpFeatures<T>::pointIn(
    std::span<const Vec3<double>> points, const Box<double>& cell,
    FunctionRef<bool(const CellFace&)> isFreeBeyond) const {
  std::vector<Vec3<double>> normals;
  Vec3<double> center{};
  double least = 1;
  for (const auto& point : points) {
    const auto normal = normalized(Vec3<double>(solid_.gradient(Vec3<T>(point))));
    for (const auto& other : normals) least = std::min(least, dot(normal, other));
    normals.push_back(normal);
    center = center + (1.0 / static_cast<double>(points.size())) * point;
  }
  if (!(least < leastCosine_)) return std::nullopt;
  PlanesMeeting planes(center);
  for (std::size_t i = 0; i < points.size(); ++i) planes.add(points[i], normals[i]);
  // The point may move a little on its way to the surface.
  const auto within = cell.grown(-0.01 * (cell.upper.x - cell.lower.x));
  auto meeting = planes.pointIn(within);
  const auto isAllowed = [&](const Vec3<double>& place) {
    if (!isFinite(place) || cell.contains(place)) return isFinite(place);
    const auto face = faceBefore(cell, place);
    return face && isFreeBeyond(*face);
  };
  if (!isAllowed(meeting)) {
    const auto nearest = max(within.lower, min(meeting, within.upper));
    if (!(length(meeting - nearest) < kFarthest * within.diagonal())) return std::nullopt;
    meeting = nearest;
  }
  const Vec3<double> result(solid_.closestPoint(Vec3<T>(meeting)).point);
  if (!isAllowed(result)) return std::nullopt;
  // No triangle of the fan may be folded over.
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t j = (i + 1) % points.size();
    const auto area = cross(points[j] - points[i], result - points[i]);
    if (!(dot(area, normals[i]) > 0 || dot(area, normals[j]) > 0)) return std::nullopt;
  }
  return result;
}

void joinFeatures(std::vector<std::array<std::uint32_t, 3>>& triangles,
                  std::span<const std::size_t> fans, std::span<const Vec3<double>> points) {
  const auto area = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    return cross(points[b] - points[a], points[c] - points[a]);
  };
  const auto key = [](std::uint64_t from, std::uint64_t to) { return from << 32U | to; };
  std::unordered_map<std::uint64_t, std::size_t> byEdge;
  byEdge.reserve(fans.size());
  for (const auto n : fans) byEdge.emplace(key(triangles[n][0], triangles[n][1]), n);
  for (const auto n : fans) {
    const auto [u, v, feature] = triangles[n];
    const auto other = byEdge.find(key(v, u));
    if (other == byEdge.end() || other->second < n) continue;  // the first of the two flips both
    const auto next = triangles[other->second][2];
    const auto before = area(u, v, feature) + area(v, u, next);
    const bool isFolded =
        !(dot(area(feature, u, next), before) > 0) || !(dot(area(next, v, feature), before) > 0);
    if (isFolded) continue;
    triangles[n] = {feature, u, next};
    triangles[other->second] = {next, v, feature};
  }
}

template class SharpFeatures<float>;
template class SharpFeatures<double>;

}  // namespace cutwater::detail
