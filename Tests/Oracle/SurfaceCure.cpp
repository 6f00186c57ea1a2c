#include "Oracle/SurfaceCure.hpp"

#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Repair/FillHoles.hpp>
#include <Cutwater/Repair/Wrap.hpp>
#include <Cutwater/Surface/Cleaning/CapOnPlane.hpp>
#include <Cutwater/Surface/Cleaning/Clean.hpp>
#include <Cutwater/Surface/Cleaning/Detail/SoupEdits.hpp>
#include <Cutwater/Surface/Cleaning/ExtendTo.hpp>
#include <Cutwater/Surface/Cleaning/Rims.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace cutwater::test {
namespace {

constexpr double kTolerance = 1e-6;  // of the diagonal

bool isClosed(const PolygonSoup& soup) {
  return soup.polygonCount() > 0 && detail::openEdgesOf(soup).empty();
}

/// Whether there is more between the faces than rounding.
bool enclosesSomething(const PolygonSoup& soup) {
  const auto size = measure(soup);
  return std::abs(size.volume) > 1e-6 * size.area * soup.boundingBox().diagonal();
}

/// Whether a line along z meets the surface once: every face looks the same way.
bool isTerrain(const PolygonSoup& soup) {
  if (soup.polygonCount() < 100) return false;
  std::set<int> sides;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    std::vector<Vec3<double>> corners;
    for (const auto corner : soup.polygon(i)) corners.push_back(soup.points[corner]);
    const double z = polygonArea(corners).normal.z;
    sides.insert(z > 0 ? 1 : z < 0 ? -1 : 0);
  }
  return sides.size() == 1 && *sides.begin() != 0 && soup.boundingBox().size().z > 0;
}

/// The planes across an axis that whole rims lie in, each once: axis and coordinate.
std::set<std::pair<int, double>> planesOfRims(const PolygonSoup& soup, double tolerance) {
  std::set<std::pair<int, double>> planes;
  for (const auto& rim : findRims(soup)) {
    const auto plane = planeOf(rim, 0.5 * tolerance);
    if (plane) planes.insert({plane->axis, tolerance * std::round(plane->at / tolerance)});
  }
  return planes;
}

void cap(PolygonSoup& soup, double tolerance, Cure& cure) {
  auto capped = soup;
  std::size_t count = 0;
  for (const auto& [axis, level] : planesOfRims(soup, tolerance)) {
    SurfacePlane plane;
    plane.point[axis] = level;
    plane.normal[axis] = 1;
    count += capOnPlane(capped, plane, {.tolerance = 2 * tolerance}).closed.count;
  }
  if (count == 0 || !enclosesSomething(capped)) return;
  cure.capped = count;
  soup = std::move(capped);
}

void fill(PolygonSoup& soup, Cure& cure) {
  auto filled = soup;
  const auto report = fillHoles(filled, {.widest = 0.3 * soup.boundingBox().diagonal()});
  if (report.filled.count == 0 || !enclosesSomething(filled)) return;
  cure.holes = report.filled.count;
  soup = std::move(filled);
}

std::size_t countOf(const CleanReport& report) {
  std::size_t count = 0;
  for (const auto& step : report.steps) count += step.correction.places.count;
  return count;
}

/// Exactly, and with a tolerance where that leaves fewer edges open.
std::size_t cleanIt(PolygonSoup& soup) {
  const auto count = countOf(clean(soup));
  const auto open = detail::openEdgesOf(soup).size();
  if (open == 0) return count;
  auto welded = soup;
  const auto more = clean(welded, {.weldWithin = kTolerance * soup.boundingBox().diagonal()});
  if (detail::openEdgesOf(welded).size() >= open) return count;
  soup = std::move(welded);
  return count + countOf(more);
}

void closeIt(PolygonSoup& soup, Cure& cure) {
  const double diagonal = soup.boundingBox().diagonal();
  cure.corrections = cleanIt(soup);
  if (isClosed(soup) && enclosesSomething(soup)) return;
  if (isTerrain(soup)) {
    static_cast<void>(extendTo(soup, 2, soup.boundingBox().lower.z - 0.1 * diagonal));
    cure.extended = true;
    return;
  }
  if (!isClosed(soup)) cap(soup, kTolerance * diagonal, cure);
  if (!isClosed(soup)) fill(soup, cure);
  if (isClosed(soup) && enclosesSomething(soup)) return;
  cure.gap = diagonal / 30;
  wrap(soup, {.gap = cure.gap, .seconds = 600});
  cure.wrapped = true;
}

}  // namespace

std::string Cure::text() const {
  std::string result = corrections > 0 ? "clean (" + std::to_string(corrections) + ")" : "";
  const auto add = [&](bool done, const std::string& what) {
    if (done) result += (result.empty() ? "" : ", ") + what;
  };
  add(extended, "extend");
  add(capped > 0, "cap (" + std::to_string(capped) + ")");
  add(holes > 0, "holes (" + std::to_string(holes) + ")");
  add(wrapped, "wrap");
  add(!failure.empty(), failure);
  return result.empty() ? "-" : result;
}

Cure cure(PolygonSoup& soup) {
  Cure result;
  try {
    closeIt(soup, result);
  } catch (const Error& error) {
    result.failure = error.what();
  }
  return result;
}

}  // namespace cutwater::test
