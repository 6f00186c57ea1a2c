#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Mesh/PolygonGeometry.hpp>
#include <Cutwater/Mesh/Pseudonormals.hpp>

#include <algorithm>
#include <limits>

namespace cutwater {
namespace {

template <std::floating_point T>
constexpr double kEpsilon = std::numeric_limits<T>::epsilon();

/// The direction of a sum of vectors whose lengths add up to `weight`; zero where only rounding is
/// left of it, as between two coincident triangles back to back.
template <std::floating_point T>
Vec3<T> directionOfSum(const Vec3<double>& sum, double weight, double epsilon) {
  return length(sum) > 8 * epsilon * weight ? static_cast<Vec3<T>>(normalized(sum)) : Vec3<T>{};
}

/// Of the points, in parallel: all parts read all triangles.
constexpr std::size_t kMostParts = 16;

struct WeightedSum {
  Vec3<double> vector;
  double weight = 0;
};

}  // namespace

template <std::floating_point T>
Vec3<T> Pseudonormals<T>::edge(const Vec3<T>& one, const Vec3<T>& other) {
  return directionOfSum<T>(Vec3<double>(one) + Vec3<double>(other), 2, kEpsilon<T>);
}

template <std::floating_point T>
Pseudonormals<T> pseudonormals(std::span<const Vec3<T>> points,
                               std::span<const TriangleCorners> triangles) {
  std::vector<TriangleShape> shapes(triangles.size());
  const auto measure = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto [a, b, c] = triangles[i];
      shapes[i] = triangleShape({Vec3<double>(points[index(a)]), Vec3<double>(points[index(b)]),
                                 Vec3<double>(points[index(c)])});
    }
  };
  parallelFor(triangles.size(), {.grain = 4096, .progress = {}}, measure);

  Pseudonormals<T> result;
  result.triangles.resize(triangles.size());
  result.vertices.resize(points.size());
  std::vector<WeightedSum> sums(points.size());
  // Each thread goes through all triangles, in their order, for a part of the points.
  const auto sum = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t vertex = index(triangles[i][k]);
        if (vertex - begin >= end - begin) continue;
        auto& [vector, weight] = sums[vertex];
        vector += shapes[i].angles[k] * shapes[i].normal;
        weight += shapes[i].angles[k];
      }
    }
    for (auto v = begin; v < end; ++v) {
      result.vertices[v] = directionOfSum<T>(sums[v].vector, sums[v].weight, kEpsilon<double>);
    }
  };
  const auto parts =
      std::min<std::size_t>(kMostParts, static_cast<std::size_t>(availableThreads()));
  parallelFor(points.size(), {.grain = (points.size() + parts - 1) / parts}, sum);
  const auto round = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      result.triangles[i] = static_cast<Vec3<T>>(shapes[i].normal);
    }
  };
  parallelFor(triangles.size(), {.grain = 16384}, round);
  return result;
}

template struct Pseudonormals<float>;
template struct Pseudonormals<double>;
template Pseudonormals<float> pseudonormals(std::span<const Vec3<float>>,
                                            std::span<const TriangleCorners>);
template Pseudonormals<double> pseudonormals(std::span<const Vec3<double>>,
                                             std::span<const TriangleCorners>);

}  // namespace cutwater
