#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Surface/Detail/Pseudonormals.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

#include <algorithm>
#include <bit>
#include <limits>

namespace cutwater {
namespace {

template <std::floating_point T>
constexpr double kEpsilon = std::numeric_limits<T>::epsilon();

/// The direction of a sum of vectors whose lengths add up to `weight`; zero where only rounding is
/// left of the sum, as between two coincident triangles back to back.
template <std::floating_point T>
Vec3<T> directionOfSum(const Vec3<double>& sum, double weight, double epsilon) {
  return length(sum) > 8 * epsilon * weight ? static_cast<Vec3<T>>(normalized(sum)) : Vec3<T>{};
}

constexpr std::size_t kTrianglesPerBlock = 16384;
// Parts that the points are divided into; all parts read all triangles.
constexpr std::size_t kMostParts = 8;
// Neighbours in memory belong to the same part.
constexpr std::size_t kPointsTogether = 64;

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
  Pseudonormals<T> result;
  result.triangles.resize(triangles.size());
  std::vector<WeightedSum> sums(points.size());
  const std::size_t parts =
      std::bit_floor(std::min(kMostParts, static_cast<std::size_t>(availableThreads())));
  // Block by block, so that the shapes stay in the cache.
  std::vector<TriangleShape> shapes(std::min(kTrianglesPerBlock, triangles.size()));
  for (std::size_t first = 0; first < triangles.size(); first += kTrianglesPerBlock) {
    const auto block =
        triangles.subspan(first, std::min(kTrianglesPerBlock, triangles.size() - first));
    const auto measure = [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        const auto [a, b, c] = block[i];
        shapes[i] = triangleShape({Vec3<double>(points[index(a)]), Vec3<double>(points[index(b)]),
                                   Vec3<double>(points[index(c)])});
        result.triangles[first + i] = static_cast<Vec3<T>>(shapes[i].normal);
      }
    };
    parallelFor(block.size(), {.grain = 1024}, measure);
    // The order of triangles is kept for any number of threads: each part has its own points.
    const auto add = [&](std::size_t part, std::size_t) {
      for (std::size_t i = 0; i < block.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t point = index(block[i][k]);
          if ((point / kPointsTogether & (parts - 1)) != part) continue;
          auto& [vector, weight] = sums[point];
          vector += shapes[i].angles[k] * shapes[i].normal;
          weight += shapes[i].angles[k];
        }
      }
    };
    parallelFor(parts, {}, add);
  }

  result.vertices.resize(points.size());
  const auto finish = [&](std::size_t begin, std::size_t end) {
    for (auto v = begin; v < end; ++v) {
      result.vertices[v] = directionOfSum<T>(sums[v].vector, sums[v].weight, kEpsilon<double>);
    }
  };
  parallelFor(points.size(), {.grain = 16384}, finish);
  return result;
}

template struct Pseudonormals<float>;
template struct Pseudonormals<double>;
template Pseudonormals<float> pseudonormals(std::span<const Vec3<float>>,
                                            std::span<const TriangleCorners>);
template Pseudonormals<double> pseudonormals(std::span<const Vec3<double>>,
                                             std::span<const TriangleCorners>);

}  // namespace cutwater
