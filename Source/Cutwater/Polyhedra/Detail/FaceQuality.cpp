#include <Cutwater/Polyhedra/Detail/FaceQuality.hpp>

namespace cutwater {

double aspectRatio(const Vec3<double>& seen, double volume) {
  const double least = std::min({seen.x, seen.y, seen.z});
  const double most = std::max({seen.x, seen.y, seen.z});
  const double surface = (seen.x + seen.y + seen.z) / 6 / std::pow(volume, 2.0 / 3);
  return std::max(most / least, surface);
}

double FaceBetween::orthogonality() const {
  const auto passing = line();
  return dot(passing, face.area) / (length(passing) * length(face.area) + kTiny);
}

Vec3<double> FaceBetween::line() const {
  if (other) return *other - center;
  const auto normal = face.area / (length(face.area) + kTiny);
  return dot(normal, face.center - center) * normal;
}

Vec3<double> FaceBetween::asideOf(const Vec3<double>& passing) const {
  const auto toFace = face.center - center;
  return toFace - dot(face.area, toFace) / (dot(face.area, passing) + kTiny) * passing;
}

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
    : mesh_(mesh),
      volumes_(mesh.cells.leaf.size(), 0),
      cellCenters_(mesh.cells.leaf.size()),
      seen_(mesh.cells.leaf.size()) {
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
    seen_[cell] += abs(areas_[face]);
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

FaceBetween FaceQuality::between(std::size_t face) const {
  FaceBetween result{{areas_[face], centers_[face]}, cellCenters_[mesh_.faces.owner[face]], {}};
  if (face < mesh_.faces.neighbour.size()) result.other = cellCenters_[mesh_.faces.neighbour[face]];
  return result;
}

}  // namespace cutwater
