#include <Cutwater/CutCells/Detail/Surface/MovedSurface.hpp>
#include <Cutwater/CutCells/Detail/Surface/SaddleSplit.hpp>

#include <cmath>

namespace cutwater {

namespace {

/// Rounding leaves a component of a normal, a sum of unit vectors times angles, below this.
constexpr double kZero = 1e-12;

/// Adds to the normals of a triangle's vertices: its unit normal times its angle there.
void addNormal(const MovedTriangles& triangles, const MovedTriangles::Corners& corners,
               std::vector<Vec3<double>>& normals) {
  const std::array t{triangles.positionOf(corners[0]), triangles.positionOf(corners[1]),
                     triangles.positionOf(corners[2])};
  const auto area = cross(t[1] - t[0], t[2] - t[0]);
  const double size = length(area);
  if (!(size > 0)) return;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto u = t[(i + 1) % 3] - t[i];
    const auto v = t[(i + 2) % 3] - t[i];
    normals[corners[i]] += (std::atan2(size, dot(u, v)) / size) * area;
  }
}

}  // namespace

MovedSurface::MovedSurface(std::span<const Vec3<double>> positions,
                           std::span<const Corners> triangles, std::span<const Corners> baffles) {
  triangles_.corners.assign(triangles.begin(), triangles.end());
  triangles_.meshTriangles = triangles.size();
  triangles_.vertices.reserve(positions.size());
  for (const auto& p : positions) triangles_.vertices.push_back({.position = p});
  pairSides(triangles_);
  moveVertices();
  closedCount_ = triangles_.corners.size();
  addBaffles(positions, baffles);
}

void MovedSurface::addBaffles(std::span<const Vec3<double>> positions,
                              std::span<const Corners> baffles) {
  std::vector<std::uint32_t> numberOf(baffles.empty() ? 0 : positions.size(), kNone);
  for (auto corners : baffles) {
    for (auto& corner : corners) {
      auto& number = numberOf[corner];
      if (number == kNone) {
        number = static_cast<std::uint32_t>(triangles_.vertices.size());
        triangles_.vertices.push_back({.position = positions[corner]});
      }
      corner = number;
    }
    triangles_.corners.push_back(corners);
    triangles_.edges.push_back({kNone, kNone, kNone});
  }
}

void MovedSurface::moveVertices() {
  // Bit 0: a triangle across the axis faces down; bit 1: one faces up.
  std::vector<std::array<std::uint8_t, 3>> faces(triangles_.vertices.size());
  std::vector<Vec3<double>> normals(triangles_.vertices.size());
  for (std::uint32_t id = 0; id < triangles_.meshTriangles; ++id) {
    const auto& corners = triangles_.corners[id];
    addNormal(triangles_, corners, normals);
    for (int axis = 0; axis < 3; ++axis) {
      const int side = triangles_.facing(id, axis);
      if (side == 0) continue;
      for (const auto v : corners) faces[v][static_cast<std::size_t>(axis)] |= side > 0 ? 2 : 1;
    }
  }
  std::vector<Saddle> saddles;
  for (std::uint32_t v = 0; v < faces.size(); ++v) {
    for (int axis = 0; axis < 3; ++axis) {
      const auto face = faces[v][static_cast<std::size_t>(axis)];
      const bool goesUp = face == 1 || face == 2 ? face == 2 : normals[v][axis] >= -kZero;
      triangles_.vertices[v].shift[static_cast<std::size_t>(axis)] = goesUp ? 1 : -1;
      if (face == 3) saddles.push_back({v, axis});
    }
  }
  if (!saddles.empty()) overlapping_ = splitSaddles(triangles_, saddles);
}

}  // namespace cutwater
