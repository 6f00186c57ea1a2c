#include <Cutwater/Polyhedra/Detail/DividingPlanes.hpp>
#include <Cutwater/Polyhedra/Detail/FaceQuality.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace cutwater {

namespace {

/// See dividingPlanes().
class PlanesOfCell {
 public:
  PlanesOfCell(EditedMesh& mesh, std::uint32_t cell) : mesh_(mesh), cell_(cell) {
    for (const auto number : mesh.facesOf(cell)) {
      const auto& loop = mesh.face(number).loop;
      corners_.insert(corners_.end(), loop.begin(), loop.end());
      (mesh.face(number).other == EditedMesh::kNone ? walls_ : others_).push_back(number);
    }
    Box<double> bounds;
    for (const auto corner : corners_) bounds.extend(mesh.points()[corner]);
    near_ = 0.005 * length(bounds.size());
    std::ranges::sort(walls_, std::greater(),
                      [&](std::uint32_t wall) { return lengthSquared(meanOf(wall).normal); });
    if (walls_.size() > kMostWalls) walls_.resize(kMostWalls);
  }

  std::vector<DividingPlane> all() {
    for (const auto wall : walls_) add(meanOf(wall));
    for (const auto face : others_) add(meanOf(face));
    for (std::size_t a = 0; a < walls_.size(); ++a) {
      for (std::size_t b = a + 1; b < walls_.size(); ++b) addAtEdge(walls_[a], walls_[b]);
    }
    for (const auto wall : walls_) addAtCorners(wall);
    return std::move(planes_);
  }

 private:
  [[nodiscard]] DividingPlane meanOf(std::uint32_t number) {
    const auto& face = mesh_.face(number);
    const auto moments = faceMoments(face.loop, [&](std::uint32_t n) { return mesh_.points()[n]; });
    return {moments.center, face.cell == cell_ ? moments.area : -moments.area, face.loop};
  }

  void addAtCorners(std::uint32_t wall) {
    constexpr double kLeastSine = 0.05;
    const auto mean = meanOf(wall).normal;
    const auto& loop = mesh_.face(wall).loop;
    const auto at = [&](std::size_t k) { return mesh_.points()[loop[k % loop.size()]]; };
    for (std::size_t k = 1; k <= loop.size(); ++k) {
      const auto before = at(k) - at(k - 1);
      const auto after = at(k + 1) - at(k);
      const auto normal = cross(before, after);
      const double sizes = length(before) * length(after);
      if (!(length(normal) > kLeastSine * sizes)) continue;
      add({at(k), dot(normal, mean) < 0 ? -normal : normal});
    }
  }

  /// Of two walls: between the corners that both have.
  void addAtEdge(std::uint32_t a, std::uint32_t b) {
    constexpr double kLeastSine = 0.3;
    const auto& loop = mesh_.face(a).loop;
    const auto& other = mesh_.face(b).loop;
    std::vector<std::uint32_t> shared;
    for (const auto corner : loop) {
      if (std::ranges::count(other, corner) > 0) shared.push_back(corner);
    }
    if (shared.size() < 2) return;
    const auto& points = mesh_.points();
    const auto from = points[shared.front()];
    const auto to = points[*std::ranges::max_element(
        shared, {}, [&](auto corner) { return lengthSquared(points[corner] - from); })];
    const auto edge = (to - from) / length(to - from);
    const auto normals = meanOf(a).normal + meanOf(b).normal;
    for (const auto& along : {Vec3<double>{1, 0, 0}, Vec3<double>{0, 1, 0}, Vec3<double>{0, 0, 1},
                              normals / length(normals)}) {
      const auto normal = cross(edge, along);
      if (length(normal) > kLeastSine) add({from, normal, shared});
    }
  }

  /// Adds a plane that divides the cell, if it is not known.
  void add(const DividingPlane& plane) {
    constexpr double kSameCosine = 0.999;
    constexpr std::size_t kMost = 24;
    if (planes_.size() == kMost) return;
    const double size = length(plane.normal);
    const auto heightOf = [&](const Vec3<double>& point) {
      return dot(plane.normal, point - plane.point);
    };
    double lowest = 0;
    double highest = 0;
    for (const auto corner : corners_) {
      const double height = heightOf(mesh_.points()[corner]);
      lowest = std::min(lowest, height);
      highest = std::max(highest, height);
    }
    if (!(std::min(-lowest, highest) > near_ * size)) return;
    const bool isKnown = std::ranges::any_of(planes_, [&](const DividingPlane& known) {
      return std::abs(dot(known.normal, plane.normal)) >
                 kSameCosine * length(known.normal) * size &&
             std::abs(heightOf(known.point)) < near_ * size;
    });
    if (!isKnown) planes_.push_back(plane);
  }

  static constexpr std::size_t kMostWalls = 8;

  EditedMesh& mesh_;
  std::uint32_t cell_;
  std::vector<std::uint32_t> walls_;  // the largest first
  std::vector<std::uint32_t> others_;
  std::vector<std::uint32_t> corners_;
  double near_ = 0;  // a length beside which what is nearer is the same
  std::vector<DividingPlane> planes_;
};

}  // namespace

std::vector<DividingPlane> dividingPlanes(EditedMesh& mesh, std::uint32_t cell) {
  return PlanesOfCell(mesh, cell).all();
}

}  // namespace cutwater
