#include <Cutwater/CutCells/Detail/Tiles/CutTiles.hpp>

#include <algorithm>

namespace cutwater {

namespace {

/// Indices from `first` to `last`; none if last < first.
struct Range {
  int first = 0;
  int last = -1;
};

/// The last plane below a value, and the last that is not above it; -1 if there is none.
int lastBelow(std::span<const double> planes, double x) {
  return lastPlane(planes, x, [&](int n) { return planes[static_cast<std::size_t>(n)] < x; });
}
int lastUpTo(std::span<const double> planes, double x) {
  return lastPlane(planes, x, [&](int n) { return planes[static_cast<std::size_t>(n)] <= x; });
}

/// The tiles along an axis that meet the closed interval.
Range tilesWithin(std::span<const double> planes, double lower, double upper) {
  // Cell i touches it if plane i is not above it and plane i + 1 not below.
  const auto cells = static_cast<int>(planes.size()) - 1;
  const int from = lastBelow(planes, lower);
  const int end = (std::max(from, 0) / CutTiles::kWidth + 1) * CutTiles::kWidth;
  if (from >= 0 && end <= cells && upper < planes[static_cast<std::size_t>(end)]) {
    return {from / CutTiles::kWidth, from / CutTiles::kWidth};
  }
  const int to = lastUpTo(planes, upper);
  if (to < 0 || from >= cells) return {};
  return {std::max(from, 0) / CutTiles::kWidth, std::min(to, cells - 1) / CutTiles::kWidth};
}

/// The tiles along an axis whose lowest plane lies in the closed interval.
Range tilesThatBegin(std::span<const double> planes, double lower, double upper) {
  const int width = CutTiles::kWidth;
  const int first = (lastBelow(planes, lower) + width) / width;
  const int lastTile = (static_cast<int>(planes.size()) - 2) / width;
  if (first > lastTile || planes[asIndex(first) * asIndex(width)] > upper) return {};
  return {first, std::min(lastUpTo(planes, upper) / width, lastTile)};
}

}  // namespace

CutTiles::CutTiles(const GridPlanes& planes) : planes_(planes) {
  std::size_t tiles = 1;
  for (int axis = 0; axis < 3; ++axis) {
    sizes_[asIndex(axis)] = (planes.cells(axis) + kWidth - 1) / kWidth;
    tiles *= static_cast<std::size_t>(sizes_[asIndex(axis)]);
  }
  first_.assign(tiles + 1, 0);
}

CutTiles::CutTiles(const CutSurface& surface, const GridPlanes& planes) : CutTiles(planes) {
  // Those in the box, and below it: they decide on windings.
  Box<double> column;
  for (int axis = 0; axis < 3; ++axis) {
    column.lower[axis] = planes.positions[asIndex(axis)].front();
    column.upper[axis] = planes.positions[asIndex(axis)].back();
  }
  column.lower.z = std::min(column.lower.z, surface.boundingBox().lower.z);
  const auto triangles = surface.trianglesIn(column);
  sortTriangles(surface, triangles);
  findWindings(surface, triangles);
}

TilePlace CutTiles::placeOf(std::size_t tile) const {
  const auto n = [](int i) { return static_cast<std::size_t>(i); };
  return {static_cast<int>(tile % n(sizes_[0])),
          static_cast<int>(tile / n(sizes_[0]) % n(sizes_[1])),
          static_cast<int>(tile / n(sizes_[0]) / n(sizes_[1]))};
}

TilePlace CutTiles::firstCell(std::size_t tile) const {
  auto place = placeOf(tile);
  for (auto& i : place) i *= kWidth;
  return place;
}

GridPlanes CutTiles::planesOf(std::size_t tile) const {
  const auto first = firstCell(tile);
  auto result = planes_;
  for (int axis = 0; axis < 3; ++axis) {
    const int cells = std::min(kWidth, planes_.cells(axis) - first[asIndex(axis)]);
    result.positions[asIndex(axis)] = planes_.positions[asIndex(axis)].subspan(
        static_cast<std::size_t>(first[asIndex(axis)]), static_cast<std::size_t>(cells) + 1);
  }
  return result;
}

void CutTiles::sortTriangles(const CutSurface& surface, std::span<const std::uint32_t> triangles) {
  const auto forTiles = [&](std::uint32_t id, auto&& visit) {
    const auto& box = surface.box(id);
    std::array<Range, 3> ranges;
    for (int axis = 0; axis < 3; ++axis) {
      ranges[asIndex(axis)] =
          tilesWithin(planes_.positions[asIndex(axis)], box.lower[axis], box.upper[axis]);
    }
    for (int k = ranges[2].first; k <= ranges[2].last; ++k) {
      for (int j = ranges[1].first; j <= ranges[1].last; ++j) {
        for (int i = ranges[0].first; i <= ranges[0].last; ++i) {
          visit(static_cast<std::uint32_t>(tileAt({i, j, k})));
        }
      }
    }
  };
  std::vector<std::uint32_t> onlyTile;  // of each triangle; kNone if it has several, or none
  onlyTile.reserve(triangles.size());
  for (const auto id : triangles) {
    auto found = kNone;
    int count = 0;
    forTiles(id, [&](std::uint32_t tile) { ++first_[tile + 1], ++count, found = tile; });
    onlyTile.push_back(count == 1 ? found : kNone);
  }
  for (std::size_t tile = 0; tile < count(); ++tile) first_[tile + 1] += first_[tile];
  triangles_.resize(first_.back());
  auto next = first_;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto add = [&](std::uint32_t tile) { triangles_[next[tile]++] = triangles[i]; };
    onlyTile[i] != kNone ? add(onlyTile[i]) : forTiles(triangles[i], add);
  }
}

/// Adds up, along the line up the z axis through each tile's node, what the triangles below add.
void CutTiles::findWindings(const CutSurface& surface, std::span<const std::uint32_t> triangles) {
  windings_.assign(count(), 0);
  const auto& [x, y, z] = planes_.positions;
  const auto at = [](std::span<const double> planes, int tile) {
    return planes[static_cast<std::size_t>(tile) * kWidth];
  };
  for (const auto id : triangles) {
    if (surface.moved().isBaffle(id)) break;  // they are the last ones
    const auto& box = surface.box(id);
    const auto alongX = tilesThatBegin(x, box.lower.x, box.upper.x);
    if (alongX.last < alongX.first) continue;
    const auto alongY = tilesThatBegin(y, box.lower.y, box.upper.y);
    for (int j = alongY.first; j <= alongY.last; ++j) {
      for (int i = alongX.first; i <= alongX.last; ++i) {
        int rise = 0;
        for (int k = 0; k < sizes_[2]; ++k) {
          const double height = at(z, k);
          if (height < box.lower.z) continue;
          // Above the triangle's box, all nodes have the same below them.
          const bool isSame = k > 0 && at(z, k - 1) > box.upper.z;
          if (!isSame) {
            rise = riseBelowNode(surface.moved().triangle(id), {at(x, i), at(y, j), height}, 2);
          }
          windings_[tileAt({i, j, k})] += rise;
        }
      }
    }
  }
  for (auto& winding : windings_) winding += surface.windingOutside();
}

}  // namespace cutwater
