#include <Cutwater/Grid/Detail/TileTriangles.hpp>

#include <map>

namespace cutwater::detail {

namespace {

/// Makes the triangles of a mesh from the polygons of cells.
class PolygonMesher {
 public:
  explicit PolygonMesher(const std::vector<Vec3<double>>& points) : points_(points) {}

  /// `ids`: points at the polygon's corners. `middle`: the point in its middle, if it needs one.
  void add(const CellPolygon& polygon, std::span<const std::uint32_t> ids,
           const std::uint32_t* middle, std::vector<Triangle>& triangles) const {
    const auto n = static_cast<std::size_t>(polygon.count);
    if (middle != nullptr) {
      for (std::size_t i = 0; i < n; ++i) triangles.push_back({ids[i], ids[(i + 1) % n], *middle});
      return;
    }
    std::array<Vec3<double>, CellPolygon::kMost> positions;
    for (std::size_t i = 0; i < n; ++i) positions[i] = points_[ids[i]];
    PolygonTriangles found;
    const int count = triangulate(polygon, positions, found);
    for (std::size_t t = 0; t < static_cast<std::size_t>(count); ++t) {
      const auto id = [&](std::size_t corner) {
        return ids[static_cast<std::size_t>(found[t][corner])];
      };
      triangles.push_back({id(0), id(1), id(2)});
    }
  }

 private:
  const std::vector<Vec3<double>>& points_;
};

/// The polygons that close the surface where the grid ends: the inside parts of its six sides.
template <std::floating_point T>
class GridEnds {
 public:
  GridEnds(const SurfaceGrid<T>& grid, const SurfaceTiles<T>& tiles,
           std::vector<Vec3<double>>& points)
      : grid_(grid), tiles_(tiles), points_(points) {}

  void close(std::vector<Triangle>& triangles) {
    for (int face = 0; face < 6; ++face) closeSide(face, triangles);
  }

 private:
  void closeSide(int face, std::vector<Triangle>& triangles) {
    const auto axis = static_cast<std::size_t>(face / 2);
    const auto u = (axis + 1) % 3;
    const auto v = (axis + 2) % 3;
    NodeOffset cell{};
    cell[axis] = (face & 1) != 0 ? grid_.count(axis) - 2 : 0;
    for (cell[v] = 0; cell[v] + 1 < grid_.count(v); ++cell[v]) {
      for (cell[u] = 0; cell[u] + 1 < grid_.count(u); ++cell[u]) closeCell(cell, face, triangles);
    }
  }

  void closeCell(const NodeOffset& cell, int face, std::vector<Triangle>& triangles) {
    unsigned inside = 0;
    for (const int corner : cubeFace(face)) {
      if (tiles_.isInside(cornerOf(cell, corner))) inside |= 1U << static_cast<unsigned>(corner);
    }
    if (inside == 0) return;
    unsigned joined = ambiguousFaces(inside) & (1U << static_cast<unsigned>(face));
    if (joined != 0 && !grid_.isJoined(cell, face)) joined = 0;
    std::array<CellPolygon, 2> polygons;
    const int count = facePolygons(inside, joined, face, polygons);
    for (std::size_t n = 0; n < static_cast<std::size_t>(count); ++n) {
      std::array<std::uint32_t, CellPolygon::kMost> ids{};
      for (std::size_t i = 0; i < static_cast<std::size_t>(polygons[n].count); ++i) {
        ids[i] = pointOf(cell, polygons[n].corners[i]);
      }
      PolygonMesher(points_).add(polygons[n], ids, nullptr, triangles);
    }
  }

  std::uint32_t pointOf(const NodeOffset& cell, int corner) {
    if (corner < 12) {
      const auto edge = cubeEdge(corner);
      return tiles_.edgePoint(cornerOf(cell, edge.corner), edge.axis);
    }
    const auto node = cornerOf(cell, corner - 12);
    const auto next = static_cast<std::uint32_t>(points_.size());
    const auto [entry, isNew] = nodes_.try_emplace(node, next);
    if (isNew) points_.emplace_back(grid_.position(node));
    return entry->second;
  }

  const SurfaceGrid<T>& grid_;
  const SurfaceTiles<T>& tiles_;
  std::vector<Vec3<double>>& points_;
  std::map<NodeOffset, std::uint32_t> nodes_;
};

/// The part of the mesh in a tile.
struct MeshPart {
  std::vector<Triangle> triangles;
  std::vector<Vec3<double>> features;  // numbered after the points of all tiles
  std::vector<std::size_t> fans;       // triangles whose last corner is a feature
};

template <std::floating_point T>
class TileMesher {
 public:
  TileMesher(const SurfaceTiles<T>& tiles, const std::vector<Vec3<double>>& points,
             const SharpFeatures<T>& features, const SurfaceGrid<T>& grid)
      : tiles_(tiles), points_(points), features_(features), grid_(grid) {}

  [[nodiscard]] MeshPart mesh(std::size_t n) const {
    MeshPart part;
    const auto& tile = tiles_.tiles()[n];
    const auto& first = tile.first();
    auto middle = tiles_.firstPoint(n) + static_cast<std::uint32_t>(tile.edgePointCount());
    for (const auto& [cell, inside, joined] : tile.cutCells()) {
      const NodeOffset inGrid{first[0] + cell[0], first[1] + cell[1], first[2] + cell[2]};
      // Cells whose polygons share two sides could be joined twice.
      const bool maySharpen = features_.areWanted() && ambiguousFaces(inside) == 0;
      std::array<CellPolygon, 4> polygons;
      const int count = surfacePolygons(inside, joined, polygons);
      for (std::size_t p = 0; p < static_cast<std::size_t>(count); ++p) {
        std::array<std::uint32_t, CellPolygon::kMost> corners{};
        const std::span ids(corners.data(), static_cast<std::size_t>(polygons[p].count));
        for (std::size_t i = 0; i < ids.size(); ++i) {
          const auto edge = cubeEdge(polygons[p].corners[i]);
          ids[i] = tiles_.edgePoint(cornerOf(inGrid, edge.corner), edge.axis);
        }
        if (maySharpen && addSharp(ids, inGrid, inside, part)) continue;
        const bool isSplit = needsMiddle(polygons[p]);
        PolygonMesher(points_).add(polygons[p], ids, isSplit ? &middle : nullptr, part.triangles);
        middle += isSplit ? 1 : 0;
      }
    }
    return part;
  }

 private:
  /// Adds a fan about the feature, if there is one.
  bool addSharp(std::span<const std::uint32_t> ids, const NodeOffset& cell, unsigned inside,
                MeshPart& part) const {
    std::array<Vec3<double>, CellPolygon::kMost> positions;
    for (std::size_t i = 0; i < ids.size(); ++i) positions[i] = points_[ids[i]];
    const Box<double> box{Vec3<double>(grid_.position(cell)),
                          Vec3<double>(grid_.position(cornerOf(cell, 7)))};
    const auto isFreeBeyond = [&](const CellFace& face) {
      return isUncutBeyond(face, cell, inside);
    };
    const auto feature =
        features_.pointIn(std::span(positions.data(), ids.size()), box, isFreeBeyond);
    if (!feature) return false;
    const auto id = static_cast<std::uint32_t>(points_.size() + part.features.size());
    part.features.push_back(*feature);
    for (std::size_t i = 0; i < ids.size(); ++i) {
      part.fans.push_back(part.triangles.size());
      part.triangles.push_back({ids[i], ids[(i + 1) % ids.size()], id});
    }
    return true;
  }

  /// Whether there is a cell beyond the face, with all its nodes of the same sign.
  [[nodiscard]] bool isUncutBeyond(const CellFace& face, const NodeOffset& cell,
                                   unsigned inside) const {
    const auto axis = static_cast<std::size_t>(face.axis);
    if (face.isUpper ? cell[axis] + 2 >= grid_.count(axis) : cell[axis] == 0) return false;
    const bool isInside = ((inside >> (face.isUpper ? 1U << axis : 0U)) & 1U) != 0;
    for (unsigned corner = 0; corner < 8; ++corner) {
      if (((corner >> axis) & 1U) != (face.isUpper ? 1U : 0U)) continue;
      auto beyond = cornerOf(cell, static_cast<int>(corner));
      beyond[axis] += face.isUpper ? 1U : ~0U;
      if ((((inside >> corner) & 1U) != 0) != isInside) return false;
      if ((grid_.solid.signedDistance(grid_.position(beyond)) < 0) != isInside) return false;
    }
    return true;
  }

  const SurfaceTiles<T>& tiles_;
  const std::vector<Vec3<double>>& points_;
  const SharpFeatures<T>& features_;
  const SurfaceGrid<T>& grid_;
};

/// Joins the parts, and appends their features to the points.
std::vector<Triangle> joined(std::vector<MeshPart>& parts, std::vector<Vec3<double>>& points) {
  const std::size_t edgePoints = points.size();
  std::vector<Triangle> result;
  std::vector<std::size_t> fans;
  for (auto& [triangles, features, partFans] : parts) {
    const std::size_t before = points.size() - edgePoints;
    for (const auto n : partFans) {
      triangles[n][2] += static_cast<std::uint32_t>(before);
      fans.push_back(result.size() + n);
    }
    result.insert(result.end(), triangles.begin(), triangles.end());
    points.insert(points.end(), features.begin(), features.end());
    triangles = {};
  }
  joinFeatures(result, fans, points);
  return result;
}

}  // namespace

template <std::floating_point T>
std::vector<Triangle> tileTriangles(const SurfaceGrid<T>& grid, const SurfaceTiles<T>& tiles,
                                    const SharpFeatures<T>& features,
                                    std::vector<Vec3<double>>& points,
                                    const ParallelOptions& options) {
  const TileMesher<T> mesher(tiles, points, features, grid);
  std::vector<MeshPart> parts(tiles.tiles().size());
  parallelFor(parts.size(), options, [&](std::size_t begin, std::size_t end) {
    for (auto n = begin; n < end; ++n) parts[n] = mesher.mesh(n);
  });
  return joined(parts, points);
}

template <std::floating_point T>
void closeGridEnds(const SurfaceGrid<T>& grid, const SurfaceTiles<T>& tiles,
                   std::vector<Vec3<double>>& points, std::vector<Triangle>& triangles) {
  GridEnds<T>(grid, tiles, points).close(triangles);
}

template std::vector<Triangle> tileTriangles(const SurfaceGrid<float>&, const SurfaceTiles<float>&,
                                             const SharpFeatures<float>&,
                                             std::vector<Vec3<double>>&, const ParallelOptions&);
template std::vector<Triangle> tileTriangles(const SurfaceGrid<double>&,
                                             const SurfaceTiles<double>&,
                                             const SharpFeatures<double>&,
                                             std::vector<Vec3<double>>&, const ParallelOptions&);
template void closeGridEnds(const SurfaceGrid<float>&, const SurfaceTiles<float>&,
                            std::vector<Vec3<double>>&, std::vector<Triangle>&);
template void closeGridEnds(const SurfaceGrid<double>&, const SurfaceTiles<double>&,
                            std::vector<Vec3<double>>&, std::vector<Triangle>&);

}  // namespace cutwater::detail
