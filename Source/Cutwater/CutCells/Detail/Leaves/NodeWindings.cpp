#include <Cutwater/CutCells/Detail/Leaves/NodeWindings.hpp>

#include <algorithm>
#include <iterator>
#include <utility>

namespace cutwater {

namespace {

/// Numbers from `first` up to, but without, `end`.
struct Range {
  int first = 0;
  int end = 0;
};

/// The planes within a closed interval.
Range planesWithin(std::span<const double> planes, double lower, double upper) {
  const auto at = [&](int n) { return planes[static_cast<std::size_t>(n)]; };
  const int first = lastPlane(planes, lower, [&](int n) { return at(n) < lower; }) + 1;
  Range range{first, first};
  while (range.end < static_cast<int>(planes.size()) && at(range.end) <= upper) ++range.end;
  return range;
}

/// The cells that meet a closed interval.
Range cellsAt(std::span<const double> planes, double lower, double upper) {
  const auto [first, end] = planesWithin(planes, lower, upper);
  return {std::max(first - 1, 0), std::min(end, static_cast<int>(planes.size()) - 1)};
}

/// Adds up what the triangles add on the ways to nodes: from the first one along x, from there
/// along y, and then along z.
class WindingWays {
 public:
  WindingWays(const CutSurface& surface, const GridPlanes& planes)
      : surface_(surface),
        planes_(planes),
        numbers_(planes.sizes()),
        windings_(numbers_.nodeCount()) {}

  void add(std::uint32_t triangle) {
    const auto& box = surface_.box(triangle);
    const auto& [x, y, z] = planes_.positions;
    const auto alongX = planesWithin(x, box.lower.x, box.upper.x);
    const bool isAtFirstZ = box.lower.z <= z.front() && z.front() <= box.upper.z;
    if (isAtFirstZ && box.lower.y <= y.front() && y.front() <= box.upper.y) {
      addAlong(triangle, 0, {0, 0, 0});
    }
    if (alongX.first == alongX.end) return;
    const auto alongY = planesWithin(y, box.lower.y, box.upper.y);
    for (int i = alongX.first; i < alongX.end; ++i) {
      if (isAtFirstZ) addAlong(triangle, 1, {i, 0, 0});
      for (int j = alongY.first; j < alongY.end; ++j) addAlong(triangle, 2, {i, j, 0});
    }
  }

  /// `first`: of the node of lowest indices.
  std::vector<std::int32_t> windings(int first) && {
    const auto& cells = numbers_.cells();
    for (int i = 0; i <= cells[0]; ++i) {
      at({i, 0, 0}) += first;
      for (int j = 0; j <= cells[1]; ++j) {
        if (j > 0) at({i, j, 0}) += at({i, 0, 0});
        for (int k = 1; k <= cells[2]; ++k) at({i, j, k}) += at({i, j, 0});
      }
    }
    return std::move(windings_);
  }

 private:
  [[nodiscard]] std::int32_t& at(const TilePlace& node) { return windings_[numbers_.node(node)]; }

  /// On the way from a node up an axis, to each node there.
  void addAlong(std::uint32_t id, int axis, TilePlace node) {
    const auto triangle = surface_.moved().triangle(id);
    const auto& box = surface_.box(id);
    Vec3<double> place;
    for (int other = 0; other < 3; ++other) {
      place[other] = planes_.at(other, node[asIndex(other)]);
    }
    int rise = 0;
    bool isAbove = false;  // of the box: all nodes from there on have the same below them
    const auto riseTo = [&] {
      if (!isAbove && place[axis] >= box.lower[axis]) rise = riseBelowNode(triangle, place, axis);
      isAbove = place[axis] > box.upper[axis];
      return rise;
    };
    const int before = riseTo();
    for (int n = 1; n <= planes_.cells(axis); ++n) {
      node[asIndex(axis)] = n;
      place[axis] = planes_.at(axis, n);
      at(node) += riseTo() - before;
    }
  }

  const CutSurface& surface_;
  const GridPlanes& planes_;
  TileNumbers numbers_;
  std::vector<std::int32_t> windings_;
};

}  // namespace

std::vector<std::int32_t> nodeWindings(const CutSurface& surface, const GridPlanes& planes,
                                       std::span<const std::uint32_t> triangles, int winding) {
  WindingWays ways(surface, planes);
  for (const auto id : triangles) {
    if (!surface.moved().isBaffle(id)) ways.add(id);
  }
  return std::move(ways).windings(winding);
}

std::vector<std::uint32_t> trianglesAtCells(const CutSurface& surface, const GridPlanes& planes,
                                            std::span<const std::uint32_t> triangles,
                                            const CellMask& wanted) {
  const TileNumbers numbers(planes.sizes());
  const auto isAtCell = [&](std::uint32_t id) {
    const auto& box = surface.box(id);
    std::array<Range, 3> at;
    for (int axis = 0; axis < 3; ++axis) {
      at[asIndex(axis)] =
          cellsAt(planes.positions[asIndex(axis)], box.lower[axis], box.upper[axis]);
    }
    for (int k = at[2].first; k < at[2].end; ++k) {
      for (int j = at[1].first; j < at[1].end; ++j) {
        for (int i = at[0].first; i < at[0].end; ++i) {
          if (wanted[numbers.cell({i, j, k})]) return true;
        }
      }
    }
    return false;
  };
  std::vector<std::uint32_t> result;
  std::ranges::copy_if(triangles, std::back_inserter(result), isAtCell);
  return result;
}

}  // namespace cutwater
