#include <Cutwater/Bvh/Detail/BvhBuilder.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Detail/SelfIntersectionSearch.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>
#include <Cutwater/Triangles/TriangleIntersection.hpp>

#include <algorithm>
#include <atomic>

namespace cutwater {

namespace {

using Corners = std::array<std::uint32_t, 3>;
using Tree = TriangleTree;

template <std::floating_point T>
void requireTriangles(std::span<const Vec3<T>> positions, std::span<const Corners> triangles) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const auto corner : triangles[i]) {
      require(corner < positions.size(), "findSelfIntersections: a corner is no position",
              Named{"triangle", i}, Named{"corner", corner});
      require(isFinite(positions[corner]), "findSelfIntersections: need finite positions",
              Named{"corner", corner});
    }
  }
}

class IntersectionSearch {
 public:
  /// `faces` gives the face of each triangle, ascending; if empty, each triangle is a face of its
  /// own. The boxes and the tree may be in units of their own.
  IntersectionSearch(std::span<const Vec3<double>> positions, std::span<const Corners> triangles,
                     std::span<const std::uint32_t> faces, std::span<const Box<double>> boxes,
                     const Tree& tree)
      : positions_(positions), triangles_(triangles), faces_(faces), boxes_(boxes), tree_(tree) {
    flat_.reserve(triangles.size());
    for (const auto& [a, b, c] : triangles) {
      flat_.push_back(!hasArea({positions[a], positions[b], positions[c]}));
    }
  }

  SelfIntersections run(const SelfIntersectionOptions& options) const {
    // Ranges are handed out in ascending order and processed to their end, or up to the limit. So,
    // where the limit ends the search, the processed ranges hold the first examples, and the count
    // is the limit.
    const std::size_t limit = std::max(options.limit, Findings<FacePair>::kExamples);
    std::vector<Findings<FacePair>> found((triangles_.size() + kTrianglesPerTask - 1) /
                                          kTrianglesPerTask);
    std::atomic<std::size_t> total{0};
    parallelFor(
        triangles_.size(),
        {.threads = options.threads, .grain = kTrianglesPerTask, .progress = options.progress},
        [&](std::size_t begin, std::size_t end) {
          if (total < limit)
            total += searchRange(begin, end, limit, found[begin / kTrianglesPerTask]);
        });
    SelfIntersections result;
    for (const auto& part : found) result.pairs.add(part);
    result.complete = result.pairs.count < limit;
    result.pairs.count = std::min(result.pairs.count, limit);
    result.skippedTriangles = static_cast<std::size_t>(std::ranges::count(flat_, true));
    return result;
  }

 private:
  static constexpr std::size_t kTrianglesPerTask = 256;

  [[nodiscard]] std::uint32_t faceOf(std::size_t triangle) const {
    return faces_.empty() ? static_cast<std::uint32_t>(triangle) : faces_[triangle];
  }
  [[nodiscard]] bool startsFace(std::size_t triangle) const {
    return triangle == 0 || triangle == triangles_.size() ||
           faceOf(triangle) != faceOf(triangle - 1);
  }

  /// Finds the pairs whose first face starts in the range; returns their number.
  std::size_t searchRange(std::size_t begin, std::size_t end, std::size_t limit,
                          Findings<FacePair>& found) const {
    std::vector<std::uint32_t> partners;
    std::size_t i = begin;
    while (i < end && !startsFace(i)) ++i;
    while (i < end && found.count < limit) {
      const FaceId face{faceOf(i)};
      partners.clear();
      do {
        collectPartners(static_cast<std::uint32_t>(i++), partners);
      } while (!startsFace(i));
      for (const auto partner : partners) found.add({face, FaceId{partner}});
    }
    return found.count;
  }

  /// Adds the faces of later triangles that this one meets, in order and without duplicates.
  void collectPartners(std::uint32_t triangle, std::vector<std::uint32_t>& partners) const {
    if (flat_[triangle]) return;
    const std::size_t before = partners.size();
    const auto& box = boxes_[triangle];
    tree_.overlapping(OrientedBox<double>::of(box), [&](std::span<const std::uint32_t> slots) {
      for (const auto other : slots) {
        if (other == kNone) break;
        if (other > triangle && box.overlaps(boxes_[other]) && !flat_[other] &&
            intersect(positions_, triangles_[triangle], triangles_[other])) {
          partners.push_back(faceOf(other));
        }
      }
      return true;
    });
    if (partners.size() == before) return;
    std::ranges::sort(partners);
    partners.erase(std::unique(partners.begin(), partners.end()), partners.end());
  }

  std::span<const Vec3<double>> positions_;
  std::span<const Corners> triangles_;
  std::span<const std::uint32_t> faces_;
  std::span<const Box<double>> boxes_;
  const Tree& tree_;
  std::vector<bool> flat_;  ///< triangles without area
};

SelfIntersections searchWithOwnTree(std::span<const Vec3<double>> positions,
                                    std::span<const Corners> triangles,
                                    std::span<const std::uint32_t> faces,
                                    const SelfIntersectionOptions& options) {
  const auto boxes = triangleBoxes(positions, triangles);
  const auto arrays = buildBvh<Tree::kArity, Tree::kLeafWidth>(boxes);
  return IntersectionSearch(positions, triangles, faces, boxes, arrays.tree()).run(options);
}

}  // namespace

template <std::floating_point T>
SelfIntersections findSelfIntersections(std::span<const Vec3<T>> positions,
                                        std::span<const Corners> triangles,
                                        const SelfIntersectionOptions& options) {
  requireTriangles(positions, triangles);
  return searchWithOwnTree(normalizedPositions(positions, triangles), triangles, {}, options);
}

template <std::floating_point T>
SelfIntersections findSelfIntersections(std::span<const Vec3<T>> positions,
                                        std::span<const Corners> triangles, const Tree& tree,
                                        const SelfIntersectionOptions& options) {
  requireTriangles(positions, triangles);
  const auto boxes = triangleBoxes(positions, triangles);
  return IntersectionSearch(normalizedPositions(positions, triangles), triangles, {}, boxes, tree)
      .run(options);
}

template <std::floating_point T>
SelfIntersections findSelfIntersections(const DcelMesh<T>& mesh,
                                        const SelfIntersectionOptions& options) {
  std::vector<Corners> triangles;
  std::vector<std::uint32_t> faces;
  for (const FaceId face : mesh.faces()) {
    for (const auto& [a, b, c] : mesh.triangles(face)) {
      triangles.push_back({index(a), index(b), index(c)});
      faces.push_back(index(face));
    }
  }
  return searchWithOwnTree(normalizedPositions<T>(mesh.positions(), triangles), triangles, faces,
                           options);
}

template SelfIntersections findSelfIntersections(std::span<const Vec3<float>>,
                                                 std::span<const Corners>,
                                                 const SelfIntersectionOptions&);
template SelfIntersections findSelfIntersections(std::span<const Vec3<double>>,
                                                 std::span<const Corners>,
                                                 const SelfIntersectionOptions&);
template SelfIntersections findSelfIntersections(std::span<const Vec3<float>>,
                                                 std::span<const Corners>, const Tree&,
                                                 const SelfIntersectionOptions&);
template SelfIntersections findSelfIntersections(std::span<const Vec3<double>>,
                                                 std::span<const Corners>, const Tree&,
                                                 const SelfIntersectionOptions&);
template SelfIntersections findSelfIntersections(const DcelMesh<float>&,
                                                 const SelfIntersectionOptions&);
template SelfIntersections findSelfIntersections(const DcelMesh<double>&,
                                                 const SelfIntersectionOptions&);

}  // namespace cutwater
