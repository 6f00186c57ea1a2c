#include <Cutwater/Surface/Cleaning/CleaningSteps.hpp>
#include <Cutwater/Surface/Cleaning/Detail/SoupEdits.hpp>
#include <Cutwater/Surface/Detail/CanonicalCycle.hpp>
#include <Cutwater/Surface/Detail/IndexTable.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace cutwater {
namespace {

using Cycle = detail::CanonicalCycle<std::uint32_t>;

/// Number of faces with the same corners, by orientation: forward, backward.
struct EqualFaces {
  std::array<std::uint32_t, 2> count{};
  std::array<std::uint32_t, 2> seen{};
};

bool hasDistinctCorners(std::span<const std::uint32_t> polygon,
                        std::vector<std::uint32_t>& sorted) {
  sorted.assign(polygon.begin(), polygon.end());
  std::ranges::sort(sorted);
  return std::ranges::adjacent_find(sorted) == sorted.end();
}

/// Removes the faces for which goes(face, equals, way) returns true; equals.seen[way] equal ones
/// precede the face.
template <typename Goes>
Correction removeEqualFaces(PolygonSoup& soup, Goes goes) {
  const auto faces = static_cast<std::uint32_t>(soup.polygonCount());
  const auto cycleOf = [&](std::uint32_t i) { return Cycle(soup.polygon(i)); };
  std::vector<std::uint32_t> firstOf(faces, kNone);
  std::vector<EqualFaces> equals(faces);
  std::vector<std::uint32_t> sorted;
  detail::IndexTable table;
  for (std::uint32_t i = 0; i < faces; ++i) {
    if (!hasDistinctCorners(soup.polygon(i), sorted)) continue;
    const Cycle cycle = cycleOf(i);
    firstOf[i] = table.findOrInsert(
        i, [&](std::uint32_t j) { return cycleOf(j).hash(); },
        [&](std::uint32_t j) { return cycleOf(j) == cycle; });
    ++equals[firstOf[i]].count[cycle.isForward() ? 0 : 1];
  }
  Correction correction;
  std::vector<bool> keep(faces, true);
  for (std::uint32_t i = 0; i < faces; ++i) {
    if (firstOf[i] == kNone) continue;
    const std::size_t way = cycleOf(i).isForward() ? 0 : 1;
    auto& those = equals[firstOf[i]];
    keep[i] = !goes(i, those, way);
    ++those.seen[way];
    if (!keep[i]) correction.add(detail::middleOf(soup, i), detail::extentOf(soup, i));
  }
  detail::keepPolygons(soup, keep);
  return correction;
}

/// The edges with an odd number of faces.
class OddEdges {
 public:
  explicit OddEdges(const PolygonSoup& soup) : edges_(detail::openEdgesOf(soup)) {
    std::erase_if(edges_, [](const OpenEdge& edge) { return edge.multiplicity % 2 == 0; });
  }

  /// Whether more than half of the polygon's edges are odd.
  [[nodiscard]] bool areMostOf(std::span<const std::uint32_t> polygon) const {
    std::size_t odd = 0;
    std::uint32_t from = polygon.back();
    for (const auto to : polygon) {
      const std::pair ends(std::min(from, to), std::max(from, to));
      if (std::ranges::binary_search(edges_, ends, {}, [](const OpenEdge& edge) {
            return std::pair(edge.lower, edge.upper);
          })) {
        ++odd;
      }
      from = to;
    }
    return 2 * odd > polygon.size();
  }

 private:
  std::vector<OpenEdge> edges_;  // sorted by their ends
};

}  // namespace

Correction removeDuplicateFaces(PolygonSoup& soup) {
  Correction all = removeEqualFaces(soup, [](std::uint32_t, const EqualFaces& equals,
                                             std::size_t way) { return equals.seen[way] > 0; });
  for (;;) {  // terminates, as every round removes faces
    const OddEdges odd(soup);
    const Correction more =
        removeEqualFaces(soup, [&](std::uint32_t face, const EqualFaces& equals, std::size_t way) {
          return equals.seen[1 - way] > 0 && odd.areMostOf(soup.polygon(face));
        });
    if (!more) return all;
    all.add(more);
  }
}

Correction cancelOppositeFaces(PolygonSoup& soup) {
  return removeEqualFaces(soup, [](std::uint32_t, const EqualFaces& equals, std::size_t way) {
    const auto count = equals.count[way];
    return equals.seen[way] >= count - std::min(count, equals.count[1 - way]);
  });
}

}  // namespace cutwater
