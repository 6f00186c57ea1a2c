#include <Cutwater/Core/Detail/ParallelBatches.hpp>
#include <Cutwater/Polyhedra/Detail/CellFaces.hpp>
#include <Cutwater/Polyhedra/Detail/FaceQuality.hpp>
#include <Cutwater/Polyhedra/Detail/SimpleLoops.hpp>
#include <Cutwater/Polyhedra/FluidMesh.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <vector>

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

/// What is found of some faces, and the sum of the cosines of the inner ones.
struct Findings {
  FluidMeshReport report;
  double cosines = 0;
};

void checkFace(const FluidMesh& mesh, const FaceQuality& quality, std::size_t face,
               Findings& found) {
  auto& report = found.report;
  const auto loop = mesh.faces.of(face);
  if (loop.size() < 3 || hasRepeatedCorner(loop)) ++report.repeatedCorners;
  if (quality.area(face) == Vec3<double>{}) ++report.flatFaces;
  const auto between = quality.between(face);
  const double skewness = between.skewness(loop, [&](std::uint32_t n) { return mesh.points[n]; });
  report.worstSkewness = std::max(report.worstSkewness, skewness);
  if (skewness > kMostSkewness) ++report.skewFaces;
  if (!(between.pyramid() > 0)) ++report.invertedFaces;
  if (!between.other) return;
  if (!(between.pyramidBeyond() > 0)) ++report.invertedFaces;
  const double cosine = std::clamp(between.orthogonality(), -1.0, 1.0);
  found.cosines += cosine;
  report.worstNonOrthogonality = std::max(report.worstNonOrthogonality, inDegrees(cosine));
  if (cosine < kLeastOrthogonality) ++report.nonOrthogonalFaces;
}

void checkCell(const CellFaces& cells, const FaceQuality& quality, std::uint32_t cell,
               CellEdges& edges, FluidMeshReport& report) {
  const auto& mesh = cells.mesh();
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

void merge(const Findings& part, Findings& all) {
  all.cosines += part.cosines;
  for (const auto sum : {&FluidMeshReport::fluidVolume, &FluidMeshReport::meshVolume}) {
    all.report.*sum += part.report.*sum;
  }
  for (const auto worst :
       {&FluidMeshReport::worstClosure, &FluidMeshReport::worstSkewness,
        &FluidMeshReport::worstNonOrthogonality, &FluidMeshReport::worstAspectRatio}) {
    all.report.*worst = std::max(all.report.*worst, part.report.*worst);
  }
  for (const auto count : {&FluidMeshReport::openCells, &FluidMeshReport::repeatedCorners,
                           &FluidMeshReport::flatFaces, &FluidMeshReport::fewFaces,
                           &FluidMeshReport::invertedCells, &FluidMeshReport::invertedFaces,
                           &FluidMeshReport::skewFaces, &FluidMeshReport::nonOrthogonalFaces}) {
    all.report.*count += part.report.*count;
  }
}

/// Calls visit(begin, end, findings) for ranges up to `count`, and adds up what is found, in an
/// order that does not depend on the number of threads.
template <typename Visit>
void addFindings(std::size_t count, int threads, Findings& all, const Visit& visit) {
  constexpr std::size_t kBatch = 4096;
  std::vector<Findings> found(count / kBatch + 1);
  detail::parallelBatches(count, kBatch, {.threads = threads},
                          [&](std::size_t first, std::size_t size) {
                            visit(first, first + size, found[first / kBatch]);
                          });
  for (const auto& part : found) merge(part, all);
}

}  // namespace

FluidMeshReport check(const FluidMesh& mesh, int threads) {
  const CellFaces cells(mesh);
  const FaceQuality quality(cells, threads);
  Findings all;
  checkOrder(mesh.faces, all.report);
  addFindings(mesh.faces.count(), threads, all,
              [&](std::size_t begin, std::size_t end, Findings& found) {
                for (auto face = begin; face < end; ++face) checkFace(mesh, quality, face, found);
              });
  addFindings(cells.count(), threads, all,
              [&](std::size_t begin, std::size_t end, Findings& found) {
                CellEdges edges;
                for (auto cell = static_cast<std::uint32_t>(begin); cell < end; ++cell) {
                  checkCell(cells, quality, cell, edges, found.report);
                }
              });
  if (!mesh.faces.neighbour.empty()) {
    all.report.meanNonOrthogonality =
        inDegrees(all.cosines / static_cast<double>(mesh.faces.neighbour.size()));
  }
  return all.report;
}

}  // namespace cutwater
