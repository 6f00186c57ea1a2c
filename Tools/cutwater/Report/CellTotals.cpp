#include "Report/CellTotals.hpp"

#include <Cutwater/Grid/Isosurface.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>

#include <algorithm>
#include <cmath>

#include "Report/Format.hpp"
#include "Report/Json.hpp"

namespace cutwater::tool {

namespace {

Json orNull(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

}  // namespace

PlacedSurface::PlacedSurface(const Solid<double>& solid, const Box<double>& within,
                             const CutterOptions& options)
    : box{}, measure{}, projected{} {
  if (const auto* const mesh = solid.as<MeshSDF<double>>()) {
    auto soup = mesh->soup();
    for (auto& p : soup.points) p = solid.placement().toWorld(p);
    triangles = soup.polygonCount();
    const bool isCapped = options.capHoles && !mesh->signReport().isClosed();
    take(std::move(soup), options);
    boundsBody = boundsBody && !isCapped;
    return;
  }
  constexpr double kCells = 64;  // along the longest side
  const auto region = within.intersection(solid.boundingBox());
  boundsBody = false;
  if (region.empty() || !isFinite(region.size())) return;
  const double spacing = maxComponent(region.size()) / kCells;
  take(isosurface(solid, nodesAround(region, spacing), {.tolerance = 0.1}), options);
  boundsBody = false;
}

void PlacedSurface::take(PolygonSoup soup, const CutterOptions& options) {
  PolygonSoup walls;
  walls.points = soup.points;
  for (std::size_t i = 0; i < soup.polygonCount(); ++i) {
    const auto c = soup.polygon(i);
    const auto& a = soup.points[c[0]];
    const auto vector = 0.5 * cross(soup.points[c[1]] - a, soup.points[c[2]] - a);
    projected += abs(vector);
    const auto& patch = soup.patchNames[soup.patches[i]];
    if (std::ranges::count(options.openPatches, patch) > 0) openArea += length(vector);
    if (std::ranges::count(options.baffles, patch) > 0) continue;
    walls.addPolygon(c);
    for (const auto corner : c) box.extend(soup.points[corner]);
  }
  measure = cutwater::measure(walls);
  boundsBody = options.period == Vec3<double>{} && walls.polygonCount() > 0;
  isAllWall = options.baffles.empty();
}

double PlacedSurface::expectedCells(const Vec3<double>& size) const {
  return projected.x / (size.y * size.z) + projected.y / (size.z * size.x) +
         projected.z / (size.x * size.y);
}

CellTotals::CellTotals(const CutCellsReport& report, std::size_t all, std::size_t allPieces,
                       const Box<double>& filled, const PlacedSurface& placed, FluidSide side)
    : found(report), cells(all), pieces(allPieces) {
  if (!placed.boundsBody) {
    whyUnknown = "its volume and its area are not those of the surface alone";
    return;
  }
  const auto beyond = max(filled.lower - placed.box.lower, placed.box.upper - filled.upper);
  if (maxComponent(beyond) > 0) {
    whyUnknown = "part of the surface is outside the grid";
    return;
  }
  const double area = placed.measure.area - placed.openArea;
  const double volume = placed.measure.volume;
  const double within = side == FluidSide::Inside ? found.fluidVolume : found.bodyVolume;
  volumeError = std::abs(within - volume) / volume;
  if (placed.isAllWall) areaError = std::abs(found.wallArea - area) / placed.measure.area;
}

void CellTotals::state(double volume, double largest) {
  const double fluid = std::abs(found.fluidVolume);
  const double body = std::abs(found.bodyVolume);
  const double smaller = std::min(fluid, body);
  statedError = smaller > 0 ? volume / smaller : 0;
  largestError = largest;
  whyUnknown = "off by " + number(*statedError, 2) + " of the smaller volume and by " +
               number(largest, 2) + " of a cell or a face at most, as cells estimate it";
}

std::string CellTotals::json(const std::string& input) const {
  return Json{{"input", input},
              {"cells", cells},
              {"cutCells", found.cutCells},
              {"pieces", pieces},
              {"multiPieceCells", found.multiPieceCells},
              {"thinCells", found.thinCells},
              {"fluidVolume", found.fluidVolume},
              {"bodyVolume", found.bodyVolume},
              {"boundaryArea", found.wallArea},
              {"volumeError", orNull(volumeError)},
              {"areaError", orNull(areaError)},
              {"statedError", orNull(statedError)},
              {"largestError", orNull(largestError)},
              {"worstClosure", found.worstClosure},
              {"seconds", seconds}}
      .text();
}

std::string CellTotals::text() const {
  auto text = "pieces of fluid in them: " + grouped(pieces) + "; " +
              grouped(found.multiPieceCells) + " cells have several, in " +
              grouped(found.thinCells) + " all corners are on one side\n";
  text += "fluid " + number(found.fluidVolume, 6) + ", body " + number(found.bodyVolume, 6) +
          ", wall " + number(found.wallArea, 6);
  if (volumeError) {
    text += "; off the surface's own by " + number(*volumeError, 2) + " of the volume";
    if (areaError) text += " and " + number(*areaError, 2) + " of the area";
  } else {
    text += "; " + whyUnknown;
  }
  return text + "\npieces close to " + number(found.worstClosure, 2) + " of a face\n";
}

}  // namespace cutwater::tool
