#include <Cutwater/Polyhedra/Detail/CellFaces.hpp>
#include <Cutwater/Polyhedra/Detail/FaceQuality.hpp>
#include <Cutwater/Polyhedra/Detail/JoinedPolygons.hpp>
#include <Cutwater/Polyhedra/Detail/JoinedWalls.hpp>

#include <algorithm>
#include <utility>

namespace cutwater {

namespace {

using Loops = std::vector<CornerLoop>;

class WallJoining {
 public:
  explicit WallJoining(std::span<const Vec3<double>> points) : points_(points) {}

  /// Those of polygons that `mayJoin` allows.
  [[nodiscard]] Loops joined(const Loops& polygons,
                             FunctionRef<bool(std::size_t, std::size_t)> mayJoin) const {
    auto loops = joinedPolygons(polygons, mayJoin);
    std::erase_if(loops, [&](const CornerLoop& loop) { return isOnAxis(loop); });
    return loops;
  }
  [[nodiscard]] Loops allJoined(const Loops& polygons) const {
    return joined(polygons, [](std::size_t, std::size_t) { return true; });
  }
  [[nodiscard]] Loops kept(const Loops& polygons) const {
    return joined(polygons,
                  [&](std::size_t, std::size_t other) { return isWithoutArea(polygons[other]); });
  }
  /// Joined where their normals lie on the same side along some axes.
  [[nodiscard]] Loops joinedBySides(const Loops& polygons, unsigned axes) const {
    std::vector<unsigned> side;
    for (const auto& polygon : polygons) {
      const auto area = areaOf(polygon);
      side.push_back(0);
      for (int axis = 0; axis < 3; ++axis) {
        if (area[axis] > 0) side.back() |= axes & bitOf(axis);
      }
    }
    return joined(polygons, [&](std::size_t polygon, std::size_t other) {
      return side[polygon] == side[other];
    });
  }
  /// Of the axes along which a cell leads nowhere, a mask of those along which it has no extent
  /// either, if these are its wall: their area vectors add up to nothing that way, so that nothing
  /// is left of a wall that is one face, such as the inside of a dent.
  [[nodiscard]] unsigned flatAxes(const std::vector<Loops>& wall, unsigned axes) const {
    constexpr unsigned kAll = 7;
    if (axes == kAll) return 0;
    Vec3<double> seen;
    for (const auto& loops : wall) {
      for (const auto& loop : loops) seen += abs(areaOf(loop));
    }
    const double most = std::max({seen.x, seen.y, seen.z});
    unsigned flat = 0;
    for (int axis = 0; axis < 3; ++axis) {
      if (seen[axis] * kMostAspectRatio < most) flat |= bitOf(axis) & ~axes;
    }
    return flat;
  }

 private:
  static unsigned bitOf(int axis) { return 1U << static_cast<unsigned>(axis); }

  [[nodiscard]] Vec3<double> areaOf(const CornerLoop& loop) const {
    return faceMoments(loop, [&](std::uint32_t n) { return points_[n]; }).area;
  }
  [[nodiscard]] bool isOnAxis(const CornerLoop& loop) const {
    Box<double> bounds;
    for (const auto corner : loop) bounds.extend(points_[corner]);
    const auto size = bounds.size();
    return std::min({size.x + size.y, size.y + size.z, size.z + size.x}) == 0;
  }
  [[nodiscard]] bool isWithoutArea(const CornerLoop& polygon) const {
    constexpr double kNothing = 1e-14;  // of the square of its extent
    double extent = 0;
    for (const auto corner : polygon) {
      extent = std::max(extent, lengthSquared(points_[corner] - points_[polygon.front()]));
    }
    return length(areaOf(polygon)) <= kNothing * extent;
  }

  std::span<const Vec3<double>> points_;
};

}  // namespace

void joinWall(CellWall& wall, std::size_t others, unsigned axes,
              std::span<const Vec3<double>> points, bool keepsPolygons) {
  const WallJoining joining(points);
  std::vector<Loops> faces;
  for (const auto& [patch, polygons] : wall.parts) {
    faces.push_back(keepsPolygons ? joining.kept(polygons) : joining.allJoined(polygons));
    const bool isFew = faces.back().size() + others < kFewestFaces;
    if (isFew && !keepsPolygons) faces.back() = joining.kept(polygons);
    others += faces.back().size();
  }
  const auto flat = keepsPolygons ? 0 : joining.flatAxes(faces, axes);
  for (std::size_t n = 0; n < faces.size(); ++n) {
    auto& loops = wall.parts[n].loops;
    loops = flat == 0 ? std::move(faces[n]) : joining.joinedBySides(loops, flat);
  }
}

}  // namespace cutwater
