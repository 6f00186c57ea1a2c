#pragma once

#include <Cutwater/Core/RigidTransform.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

#include <functional>
#include <ostream>

#include "Support/Soups.hpp"

namespace cutwater::test {

// Closed surfaces that are hard on signs: thin, sharp, nearly flat, all but touching.

/// Moved anyhow, so that no coordinate is round.
inline RigidTransform<double> anyPlacement() {
  RigidTransform<double> placement;
  placement.rotate(41.7, {0.3, -0.5, 0.8});
  placement.translate({0.123, -0.456, 0.789});
  return placement;
}

/// The same, a million diagonals of `box` away.
inline RigidTransform<double> farPlacement(const Box<double>& box) {
  auto placement = anyPlacement();
  placement.translate(1e6 * box.diagonal() * Vec3<double>{0.6, -0.7, 0.4});
  return placement;
}

inline PolygonSoup moved(const PolygonSoup& soup, const RigidTransform<double>& placement) {
  return withPoints(soup, [&](const Vec3<double>& p) { return placement.toWorld(p); });
}

inline PolygonSoup stretched(const PolygonSoup& soup, const Vec3<double>& factors) {
  return withPoints(soup, [&](const Vec3<double>& p) {
    return Vec3<double>{factors.x * p.x, factors.y * p.y, factors.z * p.z};
  });
}

/// A box with a plate of this thickness standing on it.
inline PolygonSoup fin(double thickness) {
  const double right = 0.5 + thickness;
  return prism({{0, 0}, {1, 0}, {1, 1}, {right, 1}, {right, 2}, {0.5, 2}, {0.5, 1}, {0, 1}}, 1);
}

/// Two boxes this far apart.
inline PolygonSoup gap(double width) {
  return together(tessellation::box({0, 0, 0}, {1, 1, 1}),
                  tessellation::box({1 + width, 0, 0}, {2, 1, 1}));
}

inline PolygonSoup plate(double thickness) {
  return tessellation::box({0, 0, 1}, {1, 1, 1 + thickness}, 3);
}

/// With a trailing edge of this angle.
inline PolygonSoup wedge(double angle) {
  return prism({{0, -angle / 2}, {1, 0}, {0, angle / 2}}, 1);
}

/// Spikes of length 1 on every face of a small ball.
inline PolygonSoup starOfNeedles() {
  const auto ball = tessellation::icosphere(1e-3, 1);
  PolygonSoup soup;
  soup.points = ball.points;
  soup.patchNames = ball.patchNames;
  for (std::size_t i = 0; i < ball.polygonCount(); ++i) {
    const auto v = ball.polygon(i);
    const auto tip = static_cast<std::uint32_t>(soup.points.size());
    soup.points.push_back(normalized(soup.points[v[0]] + soup.points[v[1]] + soup.points[v[2]]));
    for (std::size_t k = 0; k < 3; ++k) soup.addPolygon(std::array{v[k], v[(k + 1) % 3], tip});
  }
  return soup;
}

/// A ball, and something very small at the origin.
inline PolygonSoup dust(double size) {
  const auto ball = withPoints(tessellation::icosphere(1, 0), [](const Vec3<double>& p) {
    return p + Vec3<double>{3, 0, 0};
  });
  return together(ball, stretched(tetrahedron(), {size, size, size}));
}

/// As a single-precision file would hold it.
inline PolygonSoup snapped(const PolygonSoup& soup) {
  return withPoints(soup, [](const Vec3<double>& p) { return Vec3<double>(Vec3<float>(p)); });
}

/// A cube and another on its edge; one mesh, four faces at that edge.
inline PolygonSoup touchingAtAnEdge() {
  auto soup =
      together(tessellation::box({0, 0, 0}, {1, 1, 1}), tessellation::box({1, 1, 0}, {2, 2, 1}));
  weldExactly(soup);
  return soup;
}

inline PolygonSoup touchingAtAVertex() {
  auto soup = together(tetrahedron(), stretched(tetrahedron(), {-1, -1, -1}));
  weldExactly(soup);
  for (std::size_t i = 4; i < 8; ++i) soup = flipped(std::move(soup), i);
  return soup;
}

/// A cube whose top and front meet in two triangles without area, as T-junctions are closed.
inline PolygonSoup flatTriangles() {
  auto soup = triangulated(cube());
  const auto middle = static_cast<std::uint32_t>(soup.points.size());
  // Splits the first triangle at the middle of its first edge, and closes the slit.
  const auto t = soup.polygon(0);
  const std::array corner{t[0], t[1], t[2]};
  soup.points.push_back(0.5 * (soup.points[corner[0]] + soup.points[corner[1]]));
  soup.corners[1] = middle;
  soup.addPolygon(std::array{middle, corner[1], corner[2]});
  soup.addPolygon(std::array{corner[0], corner[1], middle});
  return soup;
}

struct Nasty {
  const char* name;
  std::function<PolygonSoup()> make;
};

inline void PrintTo(const Nasty& nasty, std::ostream* out) {
  *out << nasty.name;
}

inline std::vector<Nasty> nasties() {
  using tessellation::box;
  using tessellation::icosphere;
  return {
      {"NeedleTetrahedron",
       [] {
         return stretched(tetrahedron(), {1e8, 1, 1});
       }},
      {"NeedleBox",
       [] {
         return box({0, 0, 0}, {1e8, 1, 1});
       }},
      {"Fin", [] { return fin(1e-8); }},
      {"Gap8", [] { return gap(1e-8); }},
      {"Gap12", [] { return gap(1e-12); }},
      {"GapOfAnUlp", [] { return gap(0x1p-52); }},
      {"Plate8", [] { return plate(1e-8); }},
      {"Plate12", [] { return plate(1e-12); }},
      {"PlateOfFourUlps", [] { return plate(0x1p-50); }},
      {"PlateOfAnUlp", [] { return plate(0x1p-52); }},
      {"Wedge6", [] { return wedge(1e-6); }},
      {"Wedge10", [] { return wedge(1e-10); }},
      {"StarOfNeedles", [] { return starOfNeedles(); }},
      {"SnappedTorus", [] { return snapped(tessellation::torus(2, 0.7, 32, 16)); }},
      {"SnappedBall", [] { return snapped(icosphere(1, 3)); }},
      {"Lens",
       [] {
         return stretched(icosphere(1, 2), {1, 1, 1e-9});
       }},
      {"DustOfFloat", [] { return dust(0x1p-30); }},
      {"Dust", [] { return dust(1e-79); }},
      {"TouchingAtAnEdge", [] { return touchingAtAnEdge(); }},
      {"TouchingAtAVertex", [] { return touchingAtAVertex(); }},
      {"FlatTriangles", [] { return flatTriangles(); }},
      {"Overlapping",
       [] {
         return together(icosphere(1, 1), stretched(icosphere(1, 2), {0.5, 1.5, 0.5}));
       }},
      {"Nested", [] { return together(icosphere(1, 1), icosphere(0.5, 1)); }},
  };
}

/// These, and a few from files.
inline std::vector<Nasty> nastyAndRealSolids() {
  auto all = nasties();
  for (const char* name : {"elephant", "knot2", "mpi_triang", "anchor", "star"}) {
    const auto file = CUTWATER_CGAL_MESHES "/" + std::string(name) + ".off";
    all.push_back({name, [file] { return readSurface(file).soup; }});
  }
  return all;
}

}  // namespace cutwater::test
