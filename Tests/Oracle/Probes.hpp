#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <array>
#include <cmath>
#include <random>

namespace cutwater::test {

/// Random points about a surface of triangles; the same ones on every run.
class Probes {
 public:
  Probes(const PolygonSoup& soup, unsigned seed)
      : soup_(soup), diagonal_(soup.boundingBox().diagonal()), engine_(seed) {}

  /// Where distances matter: beside faces, edges and vertices, from 1e-12 to 1 diagonal away.
  Vec3<double> next() { return foot(triangle()) + reach(0, 12) * direction(); }

  /// Where signs are hard to tell: from 1e-15 to 0.1 diagonals beside the surface, in any direction
  /// and along normals and axes; exactly in line with vertices, and in the planes of triangles.
  Vec3<double> nextHard() {
    const auto t = triangle();
    const auto f = foot(t);
    switch (engine_() % 8) {
      case 0:
        return f + reach(1, 15) * direction();
      case 1:
        return f + signedReach() * normalized(cross(t[1] - t[0], t[2] - t[0]));
      case 2:
        return shifted(f, signedReach());
      case 3: {  // with the coordinates of a vertex, but for one
        const auto& v = t[engine_() % 3];
        return shifted(v, engine_() % 4 == 0 ? ulps(v) : signedReach());
      }
      case 4:
        return mixed(t, triangle(), triangle());
      case 5:
        return 0.5 * (t[0] + (engine_() % 2 == 0 ? t[1] : triangle()[1]));
      case 6: {  // in the plane of a triangle, within or beyond
        std::uniform_real_distribution<double> wide(-1, 2);
        const double u = wide(engine_);
        const double v = wide(engine_);
        return t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
      }
      default:
        return f;  // on the surface, but for rounding
    }
  }

 private:
  using Corners = std::array<Vec3<double>, 3>;

  Corners triangle() {
    const auto corners = soup_.polygon(engine_() % soup_.polygonCount());
    return {soup_.points[corners[0]], soup_.points[corners[1]], soup_.points[corners[2]]};
  }
  /// In the triangle (twice as often), on an edge, on a vertex.
  Vec3<double> foot(const Corners& t) {
    double u = unit_(engine_);
    double v = unit_(engine_);
    if (u + v > 1) u = 1 - u, v = 1 - v;
    const auto where = engine_() % 4;
    if (where == 1) v = 0;
    if (where == 2) u = v = 0;
    const auto first = engine_() % 3;
    const auto& a = t[first];
    return a + u * (t[(first + 1) % 3] - a) + v * (t[(first + 2) % 3] - a);
  }
  /// 10^-most to 10^-least diagonals.
  double reach(double least, double most) {
    return diagonal_ * std::pow(10.0, -least - (most - least) * unit_(engine_));
  }
  double signedReach() { return engine_() % 2 == 0 ? reach(1, 15) : -reach(1, 15); }
  double ulps(const Vec3<double>& at) {
    const double step = std::numeric_limits<double>::epsilon() * (length(at) + diagonal_);
    return step * (static_cast<double>(engine_() % 9) - 4) / 4;
  }
  Vec3<double> shifted(Vec3<double> p, double by) {
    p[static_cast<int>(engine_() % 3)] += by;
    return p;
  }
  /// x of one vertex, y of another, z of a third.
  Vec3<double> mixed(const Corners& one, const Corners& two, const Corners& three) {
    const bool same = engine_() % 2 == 0;
    const auto x = engine_() % 3;
    const auto y = engine_() % 3;
    const auto z = engine_() % 3;
    return {one[x].x, (same ? one : two)[y].y, (same ? one : three)[z].z};
  }
  Vec3<double> direction() {
    const double x = gauss_(engine_);
    const double y = gauss_(engine_);
    const double z = gauss_(engine_);
    return normalized(Vec3<double>{x, y, z});
  }

  const PolygonSoup& soup_;
  double diagonal_;
  std::mt19937 engine_;
  std::uniform_real_distribution<double> unit_;
  std::normal_distribution<double> gauss_;
};

}  // namespace cutwater::test
