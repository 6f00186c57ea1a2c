#include <Cutwater/Grid/SharpFeatures.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include <Eigen/Eigenvalues>

namespace cutwater::detail {

namespace {

Eigen::Vector3d toEigen(const Vec3<double>& v) {
  return {v.x, v.y, v.z};
}

/// The point nearest to `center` of all that have the least sum of squared distances from planes.
/// Directions in which planes hardly bind it, as along an edge, do not move it.
class PlanesMeeting {
 public:
  explicit PlanesMeeting(const Vec3<double>& center) : center_(center) {}

  void add(const Vec3<double>& point, const Vec3<double>& normal) {
    const auto n = toEigen(normal);
    matrix_ += n * n.transpose();
    right_ += n * dot(normal, point - center_);
  }
  [[nodiscard]] Vec3<double> point() const {
    // Normals 30 degrees apart: the lesser eigenvalue is 0.07 of the larger one.
    constexpr double kLeast = 0.02;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix_);
    const auto& values = solver.eigenvalues();
    Eigen::Vector3d offset = Eigen::Vector3d::Zero();
    for (int i = 0; i < 3; ++i) {
      if (values[i] < kLeast * values[2]) continue;
      const Eigen::Vector3d along = solver.eigenvectors().col(i);
      offset += along.dot(right_) / values[i] * along;
    }
    return center_ + Vec3<double>{offset[0], offset[1], offset[2]};
  }

 private:
  Vec3<double> center_;
  Eigen::Matrix3d matrix_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right_ = Eigen::Vector3d::Zero();
};

}  // namespace

template <std::floating_point T>
SharpFeatures<T>::SharpFeatures(const SignedDistanceFunction<T>& solid, double degrees)
    : solid_(solid),
      leastCosine_(degrees < 180 ? std::cos(degrees * std::numbers::pi / 180) : -1) {}

template <std::floating_point T>
std::optional<Vec3<double>> SharpFeatures<T>::pointIn(std::span<const Vec3<double>> points,
                                                      const Box<double>& cell) const {
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
  const auto meeting = planes.point();
  if (!isFinite(meeting) || !cell.contains(meeting)) return std::nullopt;
  const auto nearest = solid_.closestPoint(Vec3<T>(meeting));
  const Vec3<double> result(nearest.point);
  if (!isFinite(result) || !cell.contains(result)) return std::nullopt;
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
    if (other == byEdge.end() || other->second < n) continue;  // the first of the two turns both
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
