#pragma once

#include <Cutwater/Polyhedra/Detail/CellFaces.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace cutwater {

/// What OpenFOAM's checkMesh takes as a limit: of skewness, of the cosine of non-orthogonality, 70
/// degrees, and of the aspect ratio.
constexpr double kMostSkewness = 4;
constexpr double kLeastOrthogonality = 0.3420201433256687;
constexpr double kMostAspectRatio = 1000;

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

/// The larger of two: the extents of a cell as seen along the axes, each the sum of its faces'
/// areas that way, and its surface beside that of a cube of its volume.
[[nodiscard]] double aspectRatio(const Vec3<double>& seen, double volume);

/// A face and the centres of its cells, the first one behind it: what OpenFOAM measures of it
/// (primitiveMeshTools, version 1912).
struct FaceBetween {
  FaceMoments face;
  Vec3<double> center;
  std::optional<Vec3<double>> other;  ///< none in a patch

  /// The volumes of the pyramids over it with their tops in the centres: positive, if it looks out
  /// of its cell, and into the other one.
  [[nodiscard]] double pyramid() const { return dot(face.area, face.center - center) / 3; }
  [[nodiscard]] double pyramidBeyond() const { return dot(face.area, *other - face.center) / 3; }
  /// The cosine of the angle between an inner face's normal and the line between its cells.
  [[nodiscard]] double orthogonality() const;
  /// How far the line between the centres passes by the face's own, over the extent of the face
  /// that way; of faces in patches, the line along their normal.
  template <typename At>
  [[nodiscard]] double skewness(std::span<const std::uint32_t> corners, const At& at) const {
    const auto passing = line();
    const auto aside = asideOf(passing);
    const double distance = length(aside);
    double extent = (other ? 0.2 : 0.4) * length(passing) + kTiny;
    for (const auto corner : corners) {
      const double reach = dot(aside, at(corner) - face.center) / (distance + kTiny);
      extent = std::max(extent, std::abs(reach));
    }
    return distance / extent;
  }

 private:
  static constexpr double kTiny = 1e-150;  // OpenFOAM's ROOTVSMALL

  [[nodiscard]] Vec3<double> line() const;
  [[nodiscard]] Vec3<double> asideOf(const Vec3<double>& passing) const;
};

/// The centres, areas and volumes of a mesh, and its faces between them.
class FaceQuality {
 public:
  /// Views the mesh of these.
  explicit FaceQuality(const CellFaces& cells, int threads = 0);

  [[nodiscard]] const Vec3<double>& area(std::size_t face) const { return areas_[face]; }
  [[nodiscard]] const Vec3<double>& center(std::size_t face) const { return centers_[face]; }
  [[nodiscard]] double volume(std::size_t cell) const { return volumes_[cell]; }
  [[nodiscard]] const Vec3<double>& cellCenter(std::size_t cell) const {
    return cellCenters_[cell];
  }

  /// Of a cell, see cutwater::aspectRatio().
  [[nodiscard]] double aspectRatio(std::size_t cell) const {
    return cutwater::aspectRatio(seen_[cell], volumes_[cell]);
  }
  [[nodiscard]] FaceBetween between(std::size_t face) const;

 private:
  void addPyramids(const CellFaces& cells, std::uint32_t cell, std::vector<FaceMoments>& faces);

  const FluidMesh& mesh_;
  std::vector<Vec3<double>> areas_;
  std::vector<Vec3<double>> centers_;
  std::vector<double> volumes_;
  std::vector<Vec3<double>> cellCenters_;
  std::vector<Vec3<double>> seen_;  // cells along the axes
};

}  // namespace cutwater
