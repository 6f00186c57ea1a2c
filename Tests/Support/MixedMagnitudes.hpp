#pragma once

#include <Cutwater/Surface/PolygonSoup.hpp>

#include <array>
#include <cmath>
#include <random>

namespace cutwater::test {

/// Soups of a few triangles, whose coordinates are of any magnitude that T has beside 1: zeros,
/// round ones, those of single precision and random bits. Points are close to others; triangles are
/// slivers, needles and points; half of the soups are flat but for the smallest of such numbers.
template <std::floating_point T>
class MixedMagnitudes {
 public:
  explicit MixedMagnitudes(unsigned seed) : engine_(seed) {}

  PolygonSoup next() {
    constexpr std::array<int, 5> kRanges{0, 30, 60, 110, sizeof(T) == sizeof(float) ? 120 : 250};
    range_ = kRanges[below(kRanges.size())];
    const int flatAxis = static_cast<int>(below(6));  // half of them have none
    const T flatness = std::ldexp(T(1), -range_);
    PolygonSoup soup;
    soup.patchNames = {"all"};
    const std::uint32_t count = 5 + below(6);
    for (std::uint32_t i = 0; i < count; ++i) {
      Vec3<T> p{uniform(), uniform(), uniform()};  // at first: one triangle at least
      if (i > 2) p = {coordinate(), coordinate(), coordinate()};
      if (i > 3 && below(3) == 0) {
        p = Vec3<T>(soup.points[below(i)]);
        p[static_cast<int>(below(3))] += power(range_ + 50) * uniform();
      }
      if (flatAxis < 3) p[flatAxis] *= flatness;
      soup.points.emplace_back(p);
    }
    if (below(2) == 0) {
      addRandomTriangles(soup, 1 + below(12));
    } else {
      addBipyramid(soup, 3 + below(count - 4));
    }
    return soup;
  }

  /// Up to n - 1.
  std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(engine_() % n); }
  /// From -1 to 1.
  T uniform() { return std::uniform_real_distribution<T>(-1, 1)(engine_); }
  /// Of the soup last made.
  T coordinate() {
    switch (below(6)) {
      case 0:
        return 0;
      case 1:
        return std::round(4 * uniform()) / 4;
      case 2:
        return static_cast<T>(static_cast<float>(uniform()));
      case 3:
        return static_cast<T>(static_cast<float>(power(range_) * uniform()));
      default:
        return power(range_) * uniform();
    }
  }

 private:
  /// 2^-k for a k up to the range.
  T power(int range) {
    return std::ldexp(T(1), -static_cast<int>(below(static_cast<std::size_t>(range) + 1)));
  }
  void addRandomTriangles(PolygonSoup& soup, std::uint32_t count) {
    soup.addPolygon(std::array{0U, 1U, 2U});
    for (std::uint32_t i = 1; i < count; ++i) {
      soup.addPolygon(std::array{below(soup.points.size()), below(soup.points.size()),
                                 below(soup.points.size())});
    }
  }
  /// Over a ring of so many points.
  static void addBipyramid(PolygonSoup& soup, std::uint32_t ring) {
    for (std::uint32_t i = 0; i < ring; ++i) {
      const std::uint32_t a = 2 + i;
      const std::uint32_t b = 2 + (i + 1) % ring;
      soup.addPolygon(std::array{0U, a, b});
      soup.addPolygon(std::array{1U, b, a});
    }
  }

  std::mt19937_64 engine_;
  int range_ = 0;
};

}  // namespace cutwater::test
