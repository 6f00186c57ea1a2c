#include "Report/CellTotals.hpp"

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

PlacedSurface::PlacedSurface(const MeshSDF<double>& mesh, const CutterOptions& options)
    : box{}, measure{}, projected{} {
  auto soup = mesh.soup();
  for (auto& p : soup.points) p = mesh.placement().toWorld(p);
  PolygonSoup walls;
  walls.points = soup.points;
  triangles = soup.polygonCount();
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
  const bool isCapped = options.capHoles && !mesh.signReport().isClosed();
  boundsBody = !isCapped && options.period == Vec3<double>{} && walls.polygonCount() > 0;
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
