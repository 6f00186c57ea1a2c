#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Detail/PairSearch.hpp>
#include <Cutwater/Surface/Detail/SelfIntersectionSearch.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

#include <algorithm>
#include <atomic>
#include <mutex>

namespace cutwater {

namespace {

using CornerIds = std::array<std::uint32_t, 3>;
using Tree = TriangleTree;

template <std::floating_point T>
void requireTriangles(std::span<const Vec3<T>> positions, std::span<const CornerIds> triangles) {
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    for (const auto corner : triangles[i]) {
      require(corner < positions.size(), "findSelfIntersections: a corner is no position",
              Named{"triangle", i}, Named{"corner", corner});
      require(isFinite(positions[corner]), "findSelfIntersections: need finite positions",
              Named{"corner", corner});
    }
  }
}

using Pairs = std::vector<std::uint64_t>;  // of faces, the first one above the other's 32 bits

FacePair facesOf(std::uint64_t pair) {
  return {FaceId{static_cast<std::uint32_t>(pair >> 32U)},
          FaceId{static_cast<std::uint32_t>(pair)}};
}

void sortWithoutRepeats(Pairs& pairs) {
  std::ranges::sort(pairs);
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
}

/// Turns pairs of triangles into pairs of faces, and lists them.
class PairLists {
 public:
  /// `faces` gives the face of each triangle, ascending; if empty, each triangle is a face of its
  /// own.
  PairLists(const PairSearch& search, std::span<const std::uint32_t> faces)
      : search_(search), faces_(faces) {}

  /// All pairs, ascending, or at least `limit` of them.
  [[nodiscard]] Pairs list(std::size_t limit, const SelfIntersectionOptions& options) const {
    std::vector<Pairs> found(search_.tasks());
    std::vector<std::uint8_t> isDone(search_.tasks());
    Pairs all;
    // Tasks end once they have found enough pairs together. Some may be the same pairs of faces:
    // then the tasks that were left out follow.
    bool isComplete = false;
    while (!isComplete && all.size() < limit) {
      std::atomic<std::size_t> total{all.size()};
      parallelFor(search_.tasks(), {.threads = options.threads, .progress = options.progress},
                  [&](std::size_t task, std::size_t) {
                    if (isDone[task] != 0 || total >= limit) return;
                    listOfTask(task, limit, found[task]);
                    total += found[task].size();
                    isDone[task] = 1;
                  });
      for (auto& pairs : found) {
        all.insert(all.end(), pairs.begin(), pairs.end());
        pairs = {};
      }
      sortWithoutRepeats(all);
      isComplete = std::ranges::count(isDone, 0) == 0;
    }
    return all;
  }

  /// The first pairs of all, given some of them.
  [[nodiscard]] Pairs first(std::size_t count, Pairs known, int threads) const {
    known.resize(std::min(count, known.size()));
    std::mutex mutex;
    std::atomic<std::uint32_t> lastWanted{lastOfFace(known.back())};
    const auto take = [&](std::uint32_t a, std::uint32_t b) {
      const std::lock_guard lock(mutex);
      known.push_back(pairOf(a, b));
      sortWithoutRepeats(known);
      known.resize(std::min(count, known.size()));
      if (known.size() == count) lastWanted = lastOfFace(known.back());
      return true;
    };
    if (known.size() < count) lastWanted = kNone;
    parallelFor(search_.tasks(), {.threads = threads, .progress = {}},
                [&](std::size_t task, std::size_t) {
                  search_.run(task, {lastWanted, take});
                });
    return known;
  }

 private:
  [[nodiscard]] std::uint64_t pairOf(std::uint32_t first, std::uint32_t second) const {
    if (faces_.empty()) return std::uint64_t{first} << 32U | second;
    return std::uint64_t{faces_[first]} << 32U | faces_[second];
  }
  /// The last triangle of the first face of a pair.
  [[nodiscard]] std::uint32_t lastOfFace(std::uint64_t pair) const {
    const auto face = index(facesOf(pair).first);
    if (faces_.empty()) return face;
    return static_cast<std::uint32_t>(std::ranges::upper_bound(faces_, face) - faces_.begin()) - 1;
  }
  void listOfTask(std::size_t task, std::size_t limit, Pairs& pairs) const {
    std::size_t room = faces_.empty() ? limit : 2 * limit;
    const auto take = [&](std::uint32_t first, std::uint32_t second) {
      pairs.push_back(pairOf(first, second));
      if (pairs.size() < room) return true;
      sortWithoutRepeats(pairs);
      room = 2 * std::max(limit, pairs.size());
      return pairs.size() < limit;
    };
    const std::atomic<std::uint32_t> lastWanted{kNone};
    search_.run(task, {lastWanted, take});
    sortWithoutRepeats(pairs);
  }

  const PairSearch& search_;
  std::span<const std::uint32_t> faces_;
};

SelfIntersections search(std::span<const Vec3<double>> positions,
                         std::span<const CornerIds> triangles, std::span<const std::uint32_t> faces,
                         const Tree& tree, const SelfIntersectionOptions& options,
                         PairTest::Changed changed = {}) {
  constexpr std::size_t kExamples = Findings<FacePair>::kExamples;
  const std::size_t limit = std::max(options.limit, kExamples);
  const PairTest pairs(positions, triangles, options.threads, changed);
  const PairSearch search(pairs, tree, options.threads);
  const PairLists lists(search, faces);
  auto found = lists.list(limit, options);
  SelfIntersections result;
  result.complete = found.size() < limit;
  result.pairs.count = std::min(found.size(), limit);
  if (!result.complete) found = lists.first(kExamples, std::move(found), options.threads);
  for (std::size_t i = 0; i < std::min(kExamples, found.size()); ++i) {
    result.pairs.examples.push_back(facesOf(found[i]));
  }
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    if (!pairs.hasArea(t)) ++result.skippedTriangles;
  }
  return result;
}

SelfIntersections searchWithOwnTree(std::span<const Vec3<double>> positions,
                                    std::span<const CornerIds> triangles,
                                    std::span<const std::uint32_t> faces,
                                    const SelfIntersectionOptions& options) {
  const auto tree = buildTriangleTree(positions, triangles);
  return search(positions, triangles, faces, tree.tree(), options);
}

}  // namespace

template <std::floating_point T>
SelfIntersections findSelfIntersections(std::span<const Vec3<T>> positions,
                                        std::span<const CornerIds> triangles,
                                        const SelfIntersectionOptions& options) {
  requireTriangles(positions, triangles);
  return searchWithOwnTree(normalizedPositions(positions, triangles), triangles, {}, options);
}

template <std::floating_point T>
SelfIntersections findSelfIntersections(std::span<const Vec3<T>> positions,
                                        std::span<const CornerIds> triangles, const Tree& tree,
                                        const SelfIntersectionOptions& options,
                                        std::span<const std::uint8_t> changed) {
  if constexpr (std::same_as<T, double>) {
    return search(positions, triangles, {}, tree, options, changed);
  } else {
    const std::vector<Vec3<double>> inDouble(positions.begin(), positions.end());
    return search(inDouble, triangles, {}, tree, options, changed);
  }
}

template <std::floating_point T>
SelfIntersections findSelfIntersections(const DcelMesh<T>& mesh,
                                        const SelfIntersectionOptions& options) {
  std::vector<CornerIds> triangles;
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
                                                 std::span<const CornerIds>,
                                                 const SelfIntersectionOptions&);
template SelfIntersections findSelfIntersections(std::span<const Vec3<double>>,
                                                 std::span<const CornerIds>,
                                                 const SelfIntersectionOptions&);
template SelfIntersections findSelfIntersections(std::span<const Vec3<float>>,
                                                 std::span<const CornerIds>, const Tree&,
                                                 const SelfIntersectionOptions&,
                                                 std::span<const std::uint8_t>);
template SelfIntersections findSelfIntersections(std::span<const Vec3<double>>,
                                                 std::span<const CornerIds>, const Tree&,
                                                 const SelfIntersectionOptions&,
                                                 std::span<const std::uint8_t>);
template SelfIntersections findSelfIntersections(const DcelMesh<float>&,
                                                 const SelfIntersectionOptions&);
template SelfIntersections findSelfIntersections(const DcelMesh<double>&,
                                                 const SelfIntersectionOptions&);

}  // namespace cutwater
