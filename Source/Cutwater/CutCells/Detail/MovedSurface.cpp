#include <Cutwater/CutCells/Detail/MovedSurface.hpp>

#include <cmath>

namespace cutwater {

namespace {

/// Rounding leaves a component of a normal, a sum of unit vectors times angles, below this.
constexpr double kZero = 1e-12;

/// Sums of the normals of the triangles at each vertex, weighted by their angles there.
std::vector<Vec3<double>> vertexNormals(std::span<const Vec3<double>> positions,
                                        std::span<const MovedSurface::Corners> triangles) {
  std::vector<Vec3<double>> normals(positions.size());
  for (const auto& corners : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto& p = positions[corners[i]];
      const auto u = positions[corners[(i + 1) % 3]] - p;
      const auto v = positions[corners[(i + 2) % 3]] - p;
      const auto area = cross(u, v);
      const double size = length(area);
      if (size > 0) normals[corners[i]] += (std::atan2(size, dot(u, v)) / size) * area;
    }
  }
  return normals;
}

}  // namespace

MovedSurface::MovedSurface(std::span<const Vec3<double>> positions,
                           std::span<const Corners> triangles)
    : triangles_(triangles) {
  const auto normals = vertexNormals(positions, triangles);
  vertices_.reserve(positions.size());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    MovedVertex vertex{.position = positions[i]};
    for (int axis = 0; axis < 3; ++axis) {
      vertex.shift[static_cast<std::size_t>(axis)] = normals[i][axis] < -kZero ? -1 : 1;
    }
    vertices_.push_back(vertex);
  }
}

int MovedSurface::windingAt(const Vec3<double>& node) const {
  int winding = 0;
  for (std::uint32_t id = 0; id < triangles_.size(); ++id) {
    winding += riseBelowNode(triangle(id), node);
  }
  return winding;
}

}  // namespace cutwater
