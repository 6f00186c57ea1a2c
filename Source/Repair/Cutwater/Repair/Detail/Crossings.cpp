#include <Cutwater/Bvh/LinearBVH.hpp>
#include <Cutwater/Repair/Detail/Crossings.hpp>
#include <Cutwater/Surface/SelfIntersections.hpp>
#include <Cutwater/Surface/Triangulation.hpp>

namespace cutwater::detail {
namespace {

using CornerIds = std::array<std::uint32_t, 3>;

/// The box of a face, as an element of a tree.
struct BoxedFace {
  Box<double> box;
  [[nodiscard]] const Box<double>& boundingBox() const { return box; }
  [[nodiscard]] double distance(const Vec3<double>& p) const {
    return length(max(max(box.lower - p, p - box.upper), Vec3<double>{}));
  }
};

Box<double> boxOf(const PolygonSoup& soup, const CornerIds& corners) {
  Box<double> box;
  for (const auto corner : corners) box.extend(soup.points[corner]);
  return box;
}

std::size_t countPairs(const PolygonSoup& soup, std::span<const CornerIds> triangles) {
  return findSelfIntersections<double>(soup.points, triangles).pairs.count;
}

}  // namespace

std::size_t crossingsOfLast(const PolygonSoup& soup, std::size_t count) {
  const auto triangulation = triangulate(soup);
  std::vector<CornerIds> last;
  std::vector<CornerIds> others;
  for (std::size_t i = 0; i < triangulation.triangles.size(); ++i) {
    const auto& [a, b, c] = triangulation.triangles[i];
    const bool isLast = triangulation.polygons[i] + count >= soup.polygonCount();
    (isLast ? last : others).push_back({index(a), index(b), index(c)});
  }
  std::vector<BoxedFace> boxes;
  for (const auto& corners : last) boxes.push_back({boxOf(soup, corners)});
  const LinearBVH<double, BoxedFace> tree(std::move(boxes));
  std::vector<CornerIds> near;
  for (const auto& corners : others) {
    tree.overlapping(boxOf(soup, corners), [&](std::uint32_t) {
      near.push_back(corners);
      return false;
    });
  }
  const auto without = countPairs(soup, near);
  near.insert(near.end(), last.begin(), last.end());
  return countPairs(soup, near) - without;
}

}  // namespace cutwater::detail
