#pragma once

#include <Cutwater/Lattice/UnitCell.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace cutwater::test {

/// From p to the strut, by the textbook formula.
template <typename T>
T distanceTo(const CellStrut& strut, const Vec3<double>& size, const Vec3<T>& p) {
  const auto scaled = [&](const Vec3<double>& x) {
    return Vec3<double>{x.x * size.x, x.y * size.y, x.z * size.z};
  };
  const Vec3<double> a = scaled(strut.a);
  const Vec3<double> ab = scaled(strut.b) - a;
  const Vec3<double> ap = Vec3<double>(p) - a;
  const double h = std::clamp(dot(ap, ab) / dot(ab, ab), 0.0, 1.0);
  return static_cast<T>(length(ap - h * ab));
}

/// All struts of the cells from first to last, one by one.
inline std::vector<CellStrut> explicitStruts(std::span<const CellStrut> ofCell, int first,
                                             int last) {
  std::vector<CellStrut> struts;
  for (int x = first; x <= last; ++x) {
    for (int y = first; y <= last; ++y) {
      for (int z = first; z <= last; ++z) {
        const Vec3<double> place{1.0 * x, 1.0 * y, 1.0 * z};
        for (const auto& [a, b] : ofCell) struts.push_back({a + place, b + place});
      }
    }
  }
  return struts;
}

/// From p to the nearest of them.
template <typename T>
T distanceTo(std::span<const CellStrut> struts, const Vec3<double>& size, const Vec3<T>& p) {
  T least = std::numeric_limits<T>::infinity();
  for (const auto& strut : struts) least = std::min(least, distanceTo(strut, size, p));
  return least;
}

}  // namespace cutwater::test
