#pragma once

#include <Cutwater/Core/Box.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace cutwater {

/// Whether two triangles of a surface meet in more than what they share, as intersect() decides it,
/// for many pairs.
///
/// Most pairs whose boxes meet are neighbours at a vertex. Where a vertex's triangles, seen along
/// one of the axes, lie around it once, without overlaps, no two of them meet elsewhere. This is
/// decided once per vertex, so such pairs cost next to nothing.
class PairTest {
 public:
  using Corners = std::array<std::uint32_t, 3>;

  /// Which triangles are to be tested against all; the others are not tested among themselves.
  /// Empty: all are.
  using Changed = std::span<const std::uint8_t>;

  /// The arrays must outlive this object; for positions, see ExactPredicates.hpp. `clearance`: two
  /// triangles without a common corner are taken to meet unless they are farther apart for certain.
  PairTest(std::span<const Vec3<double>> positions, std::span<const Corners> triangles,
           int threads = 0, Changed changed = {}, double clearance = 0);

  [[nodiscard]] std::size_t triangles() const { return triangles_.size(); }
  [[nodiscard]] const Corners& corners(std::uint32_t t) const { return triangles_[t]; }
  [[nodiscard]] const Vec3<double>& position(std::uint32_t vertex) const {
    return positions_[vertex];
  }
  /// Boxes of triangles that meet do.
  [[nodiscard]] Box<double> box(std::uint32_t t) const;
  /// False for triangles of three collinear points.
  [[nodiscard]] bool hasArea(std::uint32_t t) const { return views_[t].bits != 0; }
  [[nodiscard]] bool isChanged(std::uint32_t t) const {
    return changed_.empty() || changed_[t] != 0;
  }
  [[nodiscard]] bool areAllChanged() const { return changed_.empty(); }
  /// Whether it is known that no two triangles at the vertex meet elsewhere.
  [[nodiscard]] bool isFlat(std::uint32_t vertex) const { return isFlat_[vertex] != 0; }
  /// Whether the pair is to be tested, and meets. Both triangles must have area.
  [[nodiscard]] bool meet(std::uint32_t a, std::uint32_t b) const;

 private:
  /// The triangles at each vertex: `list` from `begins[v]` up to `begins[v + 1]`.
  struct Stars {
    std::vector<std::uint32_t> begins;
    std::vector<std::uint32_t> list;
  };
  [[nodiscard]] Stars stars() const;
  /// A triangle as seen along the axes.
  struct Views {
    /// Bit k: the corners run counterclockwise as seen along axis k; bit 3 + k: they run clockwise;
    /// kHasArea. Those of axes are missing where rounding leaves it open.
    std::uint8_t bits = 0;
    /// For each axis, bit i: the triangle's angle at corner i begins below the first axis of that
    /// view and ends above it, or on it.
    std::array<std::uint8_t, 3> passes{};
  };
  [[nodiscard]] Views viewsOf(const Corners& triangle) const;
  /// Whether these triangles, all those at the vertex, lie around it as said above.
  [[nodiscard]] bool liesFlat(std::uint32_t vertex, std::span<const std::uint32_t> star) const;

  std::span<const Vec3<double>> positions_;
  std::span<const Corners> triangles_;
  Changed changed_;
  double clearance_;
  std::vector<Views> views_;          ///< per triangle
  std::vector<std::uint8_t> isFlat_;  ///< per vertex; where unknown, 0
};

}  // namespace cutwater
