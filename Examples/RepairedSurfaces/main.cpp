// A half model with the usual damage, cleaned, capped and mirrored, and the ground below a terrain.
// See README.md and Docs/cleaning.md.
#include <Cutwater/Surface/Cleaning/CapOnPlane.hpp>
#include <Cutwater/Surface/Cleaning/Clean.hpp>
#include <Cutwater/Surface/Cleaning/ExtendTo.hpp>
#include <Cutwater/Surface/Cleaning/MirrorAt.hpp>
#include <Cutwater/Surface/MeshReport.hpp>
#include <Cutwater/Surface/Tessellation.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

using namespace cutwater;

namespace {

/// The half y > 0 of a torus, as STL files have it: every face with points of its own, a
/// rounding apart; one face twice, one the wrong way round.
PolygonSoup damagedHalf() {
  const auto torus = tessellation::torus(2, 0.5, 48, 24);
  PolygonSoup soup;
  soup.patchNames = torus.patchNames;
  for (std::size_t i = 0; i < torus.polygonCount(); ++i) {
    const auto polygon = torus.polygon(i);
    if ((torus.points[polygon[0]] + torus.points[polygon[2]]).y < 0) continue;
    std::vector<std::uint32_t> corners;
    for (const auto corner : polygon) {
      const Vec3<double> p = torus.points[corner];
      const double noise = 4e-7 * std::sin(static_cast<double>(7 * soup.points.size()));
      corners.push_back(static_cast<std::uint32_t>(soup.points.size()));
      soup.points.push_back({p.x + noise, p.y, p.z - noise});
    }
    if (i == 7) std::ranges::reverse(corners);
    soup.addPolygon(corners);
    if (i == 11) soup.addPolygon(corners);
  }
  return soup;
}

/// A hill of 20 x 20 squares.
PolygonSoup hill() {
  PolygonSoup soup;
  soup.patchNames = {"hill"};
  constexpr std::uint32_t kWidth = 21;
  for (std::uint32_t i = 0; i < kWidth * kWidth; ++i) {
    const std::uint32_t column = i % kWidth;
    const std::uint32_t row = i / kWidth;
    const double x = 0.1 * column;
    const double y = 0.1 * row;
    soup.points.push_back({x, y, 0.3 * std::sin(2 * x) * std::sin(2 * y)});
    if (column + 1 == kWidth || row + 1 == kWidth) continue;
    soup.addPolygon(std::array{i, i + 1, i + kWidth + 1});
    soup.addPolygon(std::array{i, i + kWidth + 1, i + kWidth});
  }
  return soup;
}

bool isSound(const PolygonSoup& soup, const char* what) {
  const auto report = check(DcelMesh<double>(soup));
  std::printf("%s: %s, volume %.4f\n\n", what, report.summary().c_str(), report.volume);
  return report.isClean();
}

}  // namespace

int main() {
  // [DOCS
  PolygonSoup half = damagedHalf();
  const CleanReport cleaned = clean(half, {.weldWithin = 1e-5});
  std::printf("%s", cleaned.text().c_str());

  PolygonSoup capped = half;  // a closed half, or ...
  const SurfacePlane symmetry{{0, 0, 0}, {0, 1, 0}};
  const OpeningReport caps = capOnPlane(capped, symmetry, {.tolerance = 1e-5, .patch = "symmetry"});
  std::printf("%s", caps.text().c_str());

  PolygonSoup whole = half;  // ... the whole
  const OpeningReport joined = mirrorAt(whole, symmetry, /*tolerance=*/1e-5);

  PolygonSoup ground = hill();
  const OpeningReport sides = extendToBox(ground, {{-1, -1, -1}, {3, 3, 2}}, /*axis=*/2);
  const MeshReport found = check(DcelMesh<double>(ground));  // found.isClean()
  // DOCS]
  const bool sound =
      isSound(capped, "half") && isSound(whole, "whole") && isSound(ground, "ground");
  const bool closed = caps.closed.count == 2 && joined.rimEdges > 0 && sides.closed.count == 1;
  return sound && closed && found.isClean() ? 0 : 1;
}
