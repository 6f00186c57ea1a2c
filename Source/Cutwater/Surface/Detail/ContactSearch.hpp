#pragma once

#include <Cutwater/Core/Vec3.hpp>
#include <Cutwater/Triangles/Search/TriangleTree.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// How the triangles of a surface meet in more than the corners and edges that they share.
struct SurfaceContacts {
  /// Where counting ends.
  static constexpr std::size_t kMost = 1'000'000;

  /// Pairs of triangles that pass through or lie on one another: see meetWithin(). At most kMost;
  /// so many are also stated if more than kMost pairs touch.
  std::size_t overlaps = 0;
  /// Per triangle, bit i: its edge from corner i to the next lies on one line with an edge, not the
  /// same, of another triangle that it touches, as at a T-junction; bit 3 + i: and has a part of
  /// this one in common with it, but not both ends. Bits 0 to 2 for triangles without area.
  /// Incomplete if there are overlaps.
  std::vector<std::uint8_t> touchedEdges;

  [[nodiscard]] static bool isTouched(std::uint8_t edges, std::size_t edge) {
    return (edges >> edge & 1U) != 0;
  }
  [[nodiscard]] static bool isTouchedInPart(std::uint8_t edges, std::size_t edge) {
    return isTouched(edges, 3 + edge);
  }
};

/// Decides every pair of triangles that might meet, exactly. Of the tree over the triangles, only
/// the grouping is used. The largest coordinate must be about 1: see ExactPredicates.hpp. The
/// overlaps do not depend on the number of threads. If `changed` is given, one value for each
/// triangle, only pairs of which at least one is not 0 are decided.
template <std::floating_point T>
[[nodiscard]] SurfaceContacts findContacts(std::span<const Vec3<T>> positions,
                                           std::span<const std::array<std::uint32_t, 3>> triangles,
                                           const TriangleTree& tree,
                                           std::span<const std::uint8_t> changed = {});

/// The same, with a tree of its own.
template <std::floating_point T>
[[nodiscard]] SurfaceContacts findContacts(std::span<const Vec3<T>> positions,
                                           std::span<const std::array<std::uint32_t, 3>> triangles);

/// Per triangle, not 0 if another one may come within `clearance` of it: one with which it shares
/// no corner, or one with which it does and that meets it elsewhere. Also where nobody looked,
/// because very many triangles lie together; all, if more than SurfaceContacts::kMost pairs do.
/// Triangles without area count for nothing. As findContacts().
[[nodiscard]] std::vector<std::uint8_t> findCloseTriangles(
    std::span<const Vec3<double>> positions,
    std::span<const std::array<std::uint32_t, 3>> triangles, const TriangleTree& tree,
    double clearance);

}  // namespace cutwater
