#include <Cutwater/Polyhedra/Detail/CellFaces.hpp>
#include <Cutwater/Polyhedra/Detail/FaceQuality.hpp>
#include <Cutwater/Polyhedra/Detail/SimpleLoops.hpp>
#include <Cutwater/Polyhedra/FluidMesh.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

// check() of FluidMesh.

namespace cutwater {

namespace {

void checkOrder(const FluidMesh::Faces& faces, FluidMeshReport& report) {
  for (std::size_t n = 0; n < faces.neighbour.size(); ++n) {
    const bool isInPlace = faces.owner[n] < faces.neighbour[n] &&
                           (n == 0 || std::tie(faces.owner[n - 1], faces.neighbour[n - 1]) <=
                                          std::tie(faces.owner[n], faces.neighbour[n]));
    if (!isInPlace) ++report.disordered;
  }
}

double inDegrees(double cosine) {
  return std::acos(cosine) * 180 / std::numbers::pi;
}

void checkFaces(const FluidMesh& mesh, const FaceQuality& quality, FluidMeshReport& report) {
  constexpr double kMostSkew = 4;
  constexpr double kMostDegrees = 70;
  const auto& faces = mesh.faces;
  double cosines = 0;
  for (std::size_t face = 0; face < faces.count(); ++face) {
    const auto loop = faces.of(face);
    if (loop.size() < 3 || hasRepeatedCorner(loop)) ++report.repeatedCorners;
    if (quality.area(face) == Vec3<double>{}) ++report.flatFaces;
    const auto between = quality.between(face);
    const double skewness = between.skewness(loop, [&](std::uint32_t n) { return mesh.points[n]; });
    report.worstSkewness = std::max(report.worstSkewness, skewness);
    if (skewness > kMostSkew) ++report.skewFaces;
    if (!(between.pyramid() > 0)) ++report.invertedFaces;
    if (face >= faces.neighbour.size()) continue;
    if (!(between.pyramidBeyond() > 0)) ++report.invertedFaces;
    const double cosine = std::clamp(between.orthogonality(), -1.0, 1.0);
    const double angle = inDegrees(cosine);
    cosines += cosine;
    report.worstNonOrthogonality = std::max(report.worstNonOrthogonality, angle);
    if (angle > kMostDegrees) ++report.nonOrthogonalFaces;
  }
  if (!faces.neighbour.empty()) {
    report.meanNonOrthogonality = inDegrees(cosines / static_cast<double>(faces.neighbour.size()));
  }
}

void checkCells(const FluidMesh& mesh, const FaceQuality& quality, FluidMeshReport& report) {
  const CellFaces cells(mesh);
  CellEdges edges;
  for (std::uint32_t cell = 0; cell < cells.count(); ++cell) {
    report.fluidVolume += mesh.cells.volume[cell];
    report.meshVolume += quality.volume(cell);
    if (!(quality.volume(cell) > 0)) ++report.invertedCells;
    if (!edges.openOf(cells, cell).empty()) ++report.openCells;
    if (cells.of(cell).size() < kFewestFaces) ++report.fewFaces;
    Vec3<double> sum;
    double surface = 0;
    for (const auto face : cells.of(cell)) {
      const auto& area = quality.area(face);
      sum += mesh.faces.owner[face] == cell ? area : -area;
      surface += length(area);
    }
    report.worstClosure = std::max(report.worstClosure, length(sum) / surface);
    report.worstAspectRatio = std::max(report.worstAspectRatio, quality.aspectRatio(cell));
  }
}

}  // namespace

FluidMeshReport check(const FluidMesh& mesh) {
  FluidMeshReport report;
  const FaceQuality quality(mesh);
  checkOrder(mesh.faces, report);
  checkFaces(mesh, quality, report);
  checkCells(mesh, quality, report);
  return report;
}

}  // namespace cutwater
