#include <Cutwater/Polyhedra/Detail/FaceQuality.hpp>

#include <algorithm>
#include <cmath>

namespace cutwater {

namespace {

constexpr double kTiny = 1e-150;  // OpenFOAM's ROOTVSMALL

}  // namespace

CellMoments cellMoments(std::span<const FaceMoments> faces) {
  Vec3<double> mean;
  for (const auto& face : faces) mean += face.center;
  mean *= 1 / static_cast<double>(faces.size());
  Vec3<double> weighted;
  double volume = 0;
  for (const auto& face : faces) {
    const double triple = dot(face.area, face.center - mean);
    volume += triple;
    weighted += 0.75 * triple * (face.center - mean);
  }
  if (volume != 0) mean += weighted / volume;
  return {volume / 3, mean};
}

FaceQuality::FaceQuality(const FluidMesh& mesh)
    : mesh_(mesh), volumes_(mesh.cells.leaf.size(), 0), cellCenters_(mesh.cells.leaf.size()) {
  areas_.reserve(mesh.faces.count());
  centers_.reserve(mesh.faces.count());
  for (std::size_t face = 0; face < mesh.faces.count(); ++face) {
    const auto moments =
        faceMoments(mesh.faces.of(face), [&](std::uint32_t n) { return mesh.points[n]; });
    areas_.push_back(moments.area);
    centers_.push_back(moments.center);
  }
  addPyramids();
}

void FaceQuality::addPyramids() {
  const auto& faces = mesh_.faces;
  const auto forSides = [&](const auto& visit) {
    for (std::size_t face = 0; face < faces.count(); ++face) {
      visit(face, faces.owner[face], 1.0);
      if (face < faces.neighbour.size()) visit(face, faces.neighbour[face], -1.0);
    }
  };
  std::vector<Vec3<double>> means(volumes_.size());
  std::vector<double> count(volumes_.size(), 0);
  forSides([&](std::size_t face, std::uint32_t cell, double) {
    means[cell] += centers_[face];
    count[cell] += 1;
  });
  for (std::size_t cell = 0; cell < means.size(); ++cell) means[cell] *= 1 / count[cell];
  forSides([&](std::size_t face, std::uint32_t cell, double sign) {
    const double triple = sign * dot(areas_[face], centers_[face] - means[cell]);
    volumes_[cell] += triple;
    cellCenters_[cell] += triple * (0.75 * (centers_[face] - means[cell]));
  });
  for (std::size_t cell = 0; cell < means.size(); ++cell) {
    if (volumes_[cell] != 0) means[cell] += cellCenters_[cell] / volumes_[cell];
    cellCenters_[cell] = means[cell];
    volumes_[cell] /= 3;
  }
}

double FaceQuality::skewness(std::size_t face) const {
  const auto toFace = centers_[face] - cellCenters_[mesh_.faces.owner[face]];
  const auto& area = areas_[face];
  const bool isInner = face < mesh_.faces.neighbour.size();
  Vec3<double> line;
  if (isInner) {
    line = cellCenters_[mesh_.faces.neighbour[face]] - cellCenters_[mesh_.faces.owner[face]];
  } else {
    const auto normal = area / (length(area) + kTiny);
    line = dot(normal, toFace) * normal;
  }
  const auto aside = toFace - dot(area, toFace) / (dot(area, line) + kTiny) * line;
  const auto direction = aside / (length(aside) + kTiny);
  double extent = (isInner ? 0.2 : 0.4) * length(line) + kTiny;
  for (const auto corner : mesh_.faces.of(face)) {
    extent = std::max(extent, std::abs(dot(direction, mesh_.points[corner] - centers_[face])));
  }
  return length(aside) / extent;
}

double FaceQuality::orthogonality(std::size_t face) const {
  const auto line =
      cellCenters_[mesh_.faces.neighbour[face]] - cellCenters_[mesh_.faces.owner[face]];
  return dot(line, areas_[face]) / (length(line) * length(areas_[face]) + kTiny);
}

double FaceQuality::pyramid(std::size_t face, std::uint32_t cell) const {
  const double volume = dot(areas_[face], centers_[face] - cellCenters_[cell]) / 3;
  return mesh_.faces.owner[face] == cell ? volume : -volume;
}

}  // namespace cutwater
