#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <random>
#include <vector>

namespace cutwater::benchmarks {

/// The same numbers everywhere: the standard's distributions are not.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// In [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }
  std::size_t below(std::size_t count) { return engine_() % count; }
  Vec3<double> in(const Box<double>& box) {
    const double x = unit();
    const double y = unit();
    const auto size = box.size();
    return box.lower + Vec3<double>(x * size.x, y * size.y, unit() * size.z);
  }
  Vec3<double> inBall(double radius);

 private:
  std::mt19937_64 engine_;
};

/// The surface's box, enlarged by a quarter about its centre.
[[nodiscard]] Box<double> enlargedBox(const PolygonSoup& triangles);

/// Anywhere in the enlarged box.
[[nodiscard]] std::vector<Vec3<double>> uniformPoints(const PolygonSoup& triangles,
                                                      std::size_t count);
/// Within 2 % of the box's diagonal from the surface.
[[nodiscard]] std::vector<Vec3<double>> narrowPoints(const PolygonSoup& triangles,
                                                     std::size_t count);

/// 0, ..., count - 1 in an order in which every beginning is spread evenly.
[[nodiscard]] std::vector<std::size_t> scattered(std::size_t count);

}  // namespace cutwater::benchmarks
