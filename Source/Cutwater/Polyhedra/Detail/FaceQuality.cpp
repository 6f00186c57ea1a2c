#include <Cutwater/Core/Parallel.hpp>
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

FaceQuality::FaceQuality(const CellFaces& cells, int threads)
    : mesh_(cells.mesh()),
      areas_(mesh_.faces.count()),
      centers_(mesh_.faces.count()),
      volumes_(cells.count()),
      cellCenters_(cells.count()),
      seen_(cells.count()) {
  const ParallelOptions how{.threads = threads, .grain = 1024};
  parallelFor(areas_.size(), how, [&](std::size_t begin, std::size_t end) {
    for (auto face = begin; face < end; ++face) {
      const auto moments =
          faceMoments(mesh_.faces.of(face), [&](std::uint32_t n) { return mesh_.points[n]; });
      areas_[face] = moments.area;
      centers_[face] = moments.center;
    }
  });
  parallelFor(volumes_.size(), how, [&](std::size_t begin, std::size_t end) {
    std::vector<FaceMoments> faces;
    for (auto cell = static_cast<std::uint32_t>(begin); cell < end; ++cell) {
      addPyramids(cells, cell, faces);
    }
  });
}

void FaceQuality::addPyramids(const CellFaces& cells, std::uint32_t cell,
                              std::vector<FaceMoments>& faces) {
  faces.clear();
  for (const auto face : cells.of(cell)) {
    const double sign = mesh_.faces.owner[face] == cell ? 1 : -1;
    faces.push_back({sign * areas_[face], centers_[face]});
    seen_[cell] += abs(areas_[face]);
  }
  const auto moments = cellMoments(faces);
  volumes_[cell] = moments.volume;
  cellCenters_[cell] = moments.center;
}

FaceBetween FaceQuality::between(std::size_t face) const {
  FaceBetween result{{areas_[face], centers_[face]}, cellCenters_[mesh_.faces.owner[face]], {}};
  if (face < mesh_.faces.neighbour.size()) result.other = cellCenters_[mesh_.faces.neighbour[face]];
  return result;
}

}  // namespace cutwater
