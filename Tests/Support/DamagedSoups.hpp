#pragma once

#include <Cutwater/Surface/Tessellation.hpp>

#include <numbers>

#include "Support/Random.hpp"
#include "Support/Soups.hpp"

namespace cutwater::test {

/// The polygons that `keep` picks by their index; points stay.
template <typename Keep>
PolygonSoup onlyFaces(const PolygonSoup& soup, Keep keep) {
  PolygonSoup result;
  result.points = soup.points;
  result.patchNames = soup.patchNames;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    if (keep(i)) result.addPolygon(soup.polygon(i), soup.patches[i]);
  }
  return result;
}

inline Vec3<double> middleOf(const PolygonSoup& soup, std::size_t i) {
  Vec3<double> sum;
  for (const auto c : soup.polygon(i)) sum += soup.points[c];
  return sum / static_cast<double>(soup.polygon(i).size());
}

/// Without every so many polygons.
inline PolygonSoup sieveOf(const PolygonSoup& soup, std::size_t every) {
  return onlyFaces(soup, [&](std::size_t i) { return i % every != every / 2; });
}

/// Every polygon with points of its own.
inline PolygonSoup unwelded(const PolygonSoup& soup) {
  PolygonSoup result;
  result.patchNames = soup.patchNames;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    std::vector<std::uint32_t> corners;
    for (const auto c : soup.polygon(i)) {
      corners.push_back(static_cast<std::uint32_t>(result.points.size()));
      result.points.push_back(soup.points[c]);
    }
    result.addPolygon(corners, soup.patches[i]);
  }
  return result;
}

/// Every point moved by up to `distance` along each axis.
inline PolygonSoup jittered(PolygonSoup soup, double distance) {
  RandomPoints<double> random(distance, 77);
  for (auto& p : soup.points) p += random.next();
  return soup;
}

/// Every polygon turned around.
inline PolygonSoup insideOut(PolygonSoup soup) {
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) soup = flipped(std::move(soup), i);
  return soup;
}

inline PolygonSoup moved(PolygonSoup soup, const Vec3<double>& offset) {
  for (auto& p : soup.points) p += offset;
  return soup;
}

/// As together(), but points in one place are one.
inline PolygonSoup weldedTogether(const PolygonSoup& one, const PolygonSoup& other) {
  auto result = together(one, other);
  weldExactly(result);
  return result;
}

/// The lower half of a ball of radius 1 about the origin, open at the flat top; n quads around.
inline PolygonSoup bowl(int n) {
  std::vector<tessellation::ProfilePoint> profile;
  for (int i = 0; i <= n / 2; ++i) {
    const double angle = std::numbers::pi * (static_cast<double>(i) / n - 0.5);
    profile.push_back({i == 0 ? 0 : std::cos(angle), i == n / 2 ? 0 : std::sin(angle)});
  }
  const auto closed = tessellation::revolve(profile, n, tessellation::ProfileEnds::OnAxis);
  return onlyFaces(closed, [&](std::size_t i) { return middleOf(closed, i).z < 0; });
}

/// A band about the z axis of radius 1 and width 2 * half, which turns over `halfTurns` times.
inline PolygonSoup twistedBand(std::uint32_t n, double half, int halfTurns) {
  PolygonSoup soup;
  soup.patchNames = {"band"};
  for (std::uint32_t i = 0; i < n; ++i) {
    const double around = 2 * std::numbers::pi * i / n;
    const double tilt = 0.5 * halfTurns * around;
    for (const double side : {-half, half}) {
      const double radius = 1 + side * std::cos(tilt);
      soup.points.push_back(
          {radius * std::cos(around), radius * std::sin(around), side * std::sin(tilt)});
    }
  }
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t a = 2 * i;
    const bool crossesOver = i + 1 == n && halfTurns % 2 != 0;
    const std::uint32_t next = i + 1 == n ? 0 : a + 2;
    const std::uint32_t b = crossesOver ? next + 1 : next;
    const std::uint32_t c = crossesOver ? next : next + 1;
    soup.addPolygon(std::array{a, b, a + 1});
    soup.addPolygon(std::array{a + 1, b, c});
  }
  return soup;
}

}  // namespace cutwater::test
