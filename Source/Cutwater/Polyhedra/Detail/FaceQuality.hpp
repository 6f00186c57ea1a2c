#pragma once

#include <Cutwater/Polyhedra/FluidMesh.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

struct FaceMoments {
  Vec3<double> area;  ///< its vector
  Vec3<double> center;
};
struct CellMoments {
  double volume = 0;
  Vec3<double> center;
};

/// Of a face by the triangles between its edges and the mean of its corners. `at(corner)`: the
/// point.
template <typename At>
[[nodiscard]] FaceMoments faceMoments(std::span<const std::uint32_t> corners, const At& at) {
  Vec3<double> mean;
  for (const auto corner : corners) mean += at(corner);
  mean *= 1 / static_cast<double>(corners.size());
  if (corners.size() == 3) {
    const auto a = at(corners[0]);
    return {0.5 * cross(at(corners[1]) - a, at(corners[2]) - a), mean};
  }
  Vec3<double> normals;
  Vec3<double> weighted;
  double weight = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const auto a = at(corners[k]);
    const auto b = at(corners[k + 1 < corners.size() ? k + 1 : 0]);
    const auto normal = cross(b - a, mean - a);
    const double size = length(normal);
    normals += normal;
    weight += size;
    weighted += size / 3 * (a + b + mean);
  }
  return {0.5 * normals, weight > 0 ? weighted / weight : mean};
}

/// Of a cell by the pyramids between its faces, seen from outside, and the mean of their centres.
[[nodiscard]] CellMoments cellMoments(std::span<const FaceMoments> faces);
template <typename At>
[[nodiscard]] CellMoments cellMoments(const std::vector<std::vector<std::uint32_t>>& loops,
                                      const At& at) {
  std::vector<FaceMoments> faces;
  for (const auto& loop : loops) faces.push_back(faceMoments(loop, at));
  return cellMoments(faces);
}

/// The centres, areas and volumes of a mesh, and the measures of its faces, as OpenFOAM computes
/// them (primitiveMeshTools, version 1912).
class FaceQuality {
 public:
  /// Views the mesh.
  explicit FaceQuality(const FluidMesh& mesh);

  [[nodiscard]] const Vec3<double>& area(std::size_t face) const { return areas_[face]; }
  [[nodiscard]] const Vec3<double>& center(std::size_t face) const { return centers_[face]; }
  [[nodiscard]] double volume(std::size_t cell) const { return volumes_[cell]; }
  [[nodiscard]] const Vec3<double>& cellCenter(std::size_t cell) const {
    return cellCenters_[cell];
  }

  /// How far the line between the centres of its cells passes by a face's center, over the extent
  /// of the face that way; of faces in patches, the line along their normal.
  [[nodiscard]] double skewness(std::size_t face) const;
  /// The cosine of the angle between an inner face's normal and the line between its cells.
  [[nodiscard]] double orthogonality(std::size_t face) const;
  /// The volume of the pyramid over a face with its top in the centre of a cell; positive, if the
  /// face looks out of it.
  [[nodiscard]] double pyramid(std::size_t face, std::uint32_t cell) const;

 private:
  void addPyramids();

  const FluidMesh& mesh_;
  std::vector<Vec3<double>> areas_;
  std::vector<Vec3<double>> centers_;
  std::vector<double> volumes_;
  std::vector<Vec3<double>> cellCenters_;
};

}  // namespace cutwater
