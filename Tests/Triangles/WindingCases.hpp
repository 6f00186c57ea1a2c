#pragma once

#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>
#include <Cutwater/Surface/Tessellation.hpp>
#include <Cutwater/Triangles/WindingNumber.hpp>

#include <cmath>

#include "Support/Random.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {

/// Triangles, a tree over them, and their moments.
template <typename T>
class Winding {
 public:
  using Corners = std::array<std::uint32_t, 3>;

  Winding(std::vector<Vec3<T>> positions, std::vector<Corners> triangles)
      : positions_(std::move(positions)), triangles_(std::move(triangles)) {
    std::vector<Box<double>> boxes;
    for (const auto& corners : triangles_) {
      Box<double> box;
      for (const auto v : corners) box.extend(Vec3<double>(positions_[v]));
      boxes.push_back(box);
    }
    tree_ = buildBvh<16, 4>(boxes);
    arrays_ = buildWindingMoments<T>(positions_, triangles_, tree_.tree());
  }
  /// Polygons as fans.
  explicit Winding(const PolygonSoup& soup) : Winding(positionsOf(soup), trianglesOf(soup)) {}
  [[nodiscard]] WindingNumber<T> number() const {
    return {positions_,      triangles_,    tree_.tree(),
            arrays_.moments, arrays_.edges, arrays_.openEdges};
  }
  /// winding->isInside(p) for winding.number().isInside(p).
  struct Pointer {
    WindingNumber<T> number;
    const WindingNumber<T>* operator->() const { return &number; }
  };
  [[nodiscard]] Pointer operator->() const { return {number()}; }
  [[nodiscard]] const WindingArrays& arrays() const { return arrays_; }
  [[nodiscard]] const BvhArrays<16, 4>& tree() const { return tree_; }
  [[nodiscard]] const std::vector<Vec3<T>>& positions() const { return positions_; }
  [[nodiscard]] const std::vector<Corners>& triangles() const { return triangles_; }
  [[nodiscard]] std::array<Vec3<double>, 3> triangle(std::size_t id) const {
    const auto& v = triangles_[id];
    return {Vec3<double>(positions_[v[0]]), Vec3<double>(positions_[v[1]]),
            Vec3<double>(positions_[v[2]])};
  }

 private:
  static std::vector<Vec3<T>> positionsOf(const PolygonSoup& soup) {
    std::vector<Vec3<T>> result;
    for (const auto& p : soup.points) result.push_back(static_cast<Vec3<T>>(p));
    return result;
  }
  static std::vector<Corners> trianglesOf(const PolygonSoup& soup) {
    std::vector<Corners> result;
    for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
      const auto c = soup.polygon(i);
      for (std::size_t k = 2; k < c.size(); ++k) result.push_back({c[0], c[k - 1], c[k]});
    }
    return result;
  }

  std::vector<Vec3<T>> positions_;
  std::vector<Corners> triangles_;
  BvhArrays<16, 4> tree_;
  WindingArrays arrays_;
};

struct Long3 {
  long double x, y, z;
};
inline long double dot(const Long3& a, const Long3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// The oracle: one triangle by atan2 in extended precision.
inline long double turnsOf(const std::array<Vec3<double>, 3>& triangle, const Vec3<double>& p) {
  std::array<Long3, 3> v{};
  std::array<long double, 3> l{};
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = {static_cast<long double>(triangle[i].x) - p.x,
            static_cast<long double>(triangle[i].y) - p.y,
            static_cast<long double>(triangle[i].z) - p.z};
    l[i] = std::sqrt(dot(v[i], v[i]));
  }
  const auto& [a, b, c] = v;
  const Long3 normal{b.y * c.z - b.z * c.y, b.z * c.x - b.x * c.z, b.x * c.y - b.y * c.x};
  return std::atan2(dot(a, normal),
                    l[0] * l[1] * l[2] + dot(a, b) * l[2] + dot(b, c) * l[0] + dot(c, a) * l[1]) /
         (2 * 3.14159265358979323846264338327950288L);
}

template <typename T>
double bruteForce(const Winding<T>& winding, const Vec3<double>& p) {
  long double sum = 0;
  for (std::size_t i = 0; i < winding.triangles().size(); ++i) {
    sum += turnsOf(winding.triangle(i), p);
  }
  return static_cast<double>(sum);
}

inline PolygonSoup filtered(const PolygonSoup& soup, auto keep) {
  PolygonSoup result;
  result.points = soup.points;
  result.patchNames = soup.patchNames;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    if (keep(i, soup.points[soup.polygon(i)[0]])) result.addPolygon(soup.polygon(i), 0);
  }
  return result;
}

inline PolygonSoup randomTriangles(std::uint32_t count, double size, unsigned seed) {
  RandomPoints<double> random(1, seed);
  PolygonSoup soup;
  soup.patchNames = {"all"};
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto center = 0.5 * random.next();
    for (int k = 0; k < 3; ++k) soup.points.push_back(center + size * random.next());
    soup.addPolygon(std::array{3 * i, 3 * i + 1, 3 * i + 2});
  }
  return soup;
}

/// Closed, holed, overlapping, and without any order; all within [-1, 1]^3.
inline std::vector<PolygonSoup> soups() {
  const auto sphere = tessellation::icosphere(0.8, 4);
  const auto torus = tessellation::torus(0.6, 0.2, 40, 20);
  const auto moved = withPoints(sphere, [](auto p) { return 0.5 * p + Vec3<double>{0.3, 0.2, 0}; });
  return {sphere,
          filtered(sphere, [](std::size_t i, const auto&) { return i % 29 != 0; }),
          filtered(torus, [](std::size_t, const auto& p) { return p.x < 0.3; }),
          together(sphere, moved),
          randomTriangles(1500, 0.03, 1),
          randomTriangles(300, 0.6, 2)};
}

}  // namespace cutwater::test
