#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Grid/Detail/SharpFeatures.hpp>
#include <Cutwater/Grid/Detail/SurfaceBlocks.hpp>
#include <Cutwater/Grid/Isosurface.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace cutwater {

namespace {

using detail::cornerOf;
using detail::NodeOffset;
using Triangle = std::array<std::uint32_t, 3>;

/// Makes the triangles of a mesh from the polygons of cells.
class PolygonMesher {
 public:
  explicit PolygonMesher(const std::vector<Vec3<double>>& points) : points_(points) {}

  /// `ids`: points at the polygon's corners. `middle`: the point in its middle, if it needs one.
  void add(const detail::CellPolygon& polygon, std::span<const std::uint32_t> ids,
           const std::uint32_t* middle, std::vector<Triangle>& triangles) const {
    const auto n = static_cast<std::size_t>(polygon.count);
    if (middle != nullptr) {
      for (std::size_t i = 0; i < n; ++i) triangles.push_back({ids[i], ids[(i + 1) % n], *middle});
      return;
    }
    std::array<Vec3<double>, detail::CellPolygon::kMost> positions;
    for (std::size_t i = 0; i < n; ++i) positions[i] = points_[ids[i]];
    detail::PolygonTriangles found;
    const int count = detail::triangulate(polygon, positions, found);
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
  GridEnds(const detail::SurfaceGrid<T>& grid, const detail::SurfaceBlocks<T>& blocks,
           std::vector<Vec3<double>>& points)
      : grid_(grid), blocks_(blocks), points_(points) {}

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
    for (const int corner : detail::cubeFace(face)) {
      if (blocks_.isInside(cornerOf(cell, corner))) inside |= 1U << static_cast<unsigned>(corner);
    }
    if (inside == 0) return;
    unsigned joined = detail::ambiguousFaces(inside) & (1U << static_cast<unsigned>(face));
    if (joined != 0 && !grid_.isJoined(cell, face)) joined = 0;
    std::array<detail::CellPolygon, 2> polygons;
    const int count = detail::facePolygons(inside, joined, face, polygons);
    for (std::size_t n = 0; n < static_cast<std::size_t>(count); ++n) {
      std::array<std::uint32_t, detail::CellPolygon::kMost> ids{};
      for (std::size_t i = 0; i < static_cast<std::size_t>(polygons[n].count); ++i) {
        ids[i] = pointOf(cell, polygons[n].corners[i]);
      }
      PolygonMesher(points_).add(polygons[n], ids, nullptr, triangles);
    }
  }

  std::uint32_t pointOf(const NodeOffset& cell, int corner) {
    if (corner < 12) {
      const auto edge = detail::cubeEdge(corner);
      return blocks_.edgePoint(cornerOf(cell, edge.corner), edge.axis);
    }
    const auto node = cornerOf(cell, corner - 12);
    const auto next = static_cast<std::uint32_t>(points_.size());
    const auto [entry, isNew] = nodes_.try_emplace(node, next);
    if (isNew) points_.emplace_back(grid_.position(node));
    return entry->second;
  }

  const detail::SurfaceGrid<T>& grid_;
  const detail::SurfaceBlocks<T>& blocks_;
  std::vector<Vec3<double>>& points_;
  std::map<NodeOffset, std::uint32_t> nodes_;
};

/// The part of the mesh in a block.
struct MeshPart {
  std::vector<Triangle> triangles;
  std::vector<Vec3<double>> features;  // numbered after the points of all blocks
  std::vector<std::size_t> fans;       // triangles whose last corner is a feature
};

template <std::floating_point T>
class BlockMesher {
 public:
  BlockMesher(const detail::SurfaceBlocks<T>& blocks, const std::vector<Vec3<double>>& points,
              const detail::SharpFeatures<T>& features, const detail::SurfaceGrid<T>& grid)
      : blocks_(blocks), points_(points), features_(features), grid_(grid) {}

  [[nodiscard]] MeshPart mesh(std::size_t n) const {
    MeshPart part;
    const auto& block = blocks_.blocks()[n];
    const auto& first = block.first();
    auto middle = blocks_.firstPoint(n) + static_cast<std::uint32_t>(block.edgePointCount());
    for (const auto& [cell, inside, joined] : block.cutCells()) {
      const NodeOffset inGrid{first[0] + cell[0], first[1] + cell[1], first[2] + cell[2]};
      // Cells whose polygons share two sides could be joined twice.
      const bool maySharpen = features_.areWanted() && detail::ambiguousFaces(inside) == 0;
      std::array<detail::CellPolygon, 4> polygons;
      const int count = detail::surfacePolygons(inside, joined, polygons);
      for (std::size_t p = 0; p < static_cast<std::size_t>(count); ++p) {
        std::array<std::uint32_t, detail::CellPolygon::kMost> corners{};
        const std::span ids(corners.data(), static_cast<std::size_t>(polygons[p].count));
        for (std::size_t i = 0; i < ids.size(); ++i) {
          const auto edge = detail::cubeEdge(polygons[p].corners[i]);
          ids[i] = blocks_.edgePoint(cornerOf(inGrid, edge.corner), edge.axis);
        }
        if (maySharpen && addSharp(ids, inGrid, inside, part)) continue;
        const bool isSplit = detail::needsMiddle(polygons[p]);
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
    std::array<Vec3<double>, detail::CellPolygon::kMost> positions;
    for (std::size_t i = 0; i < ids.size(); ++i) positions[i] = points_[ids[i]];
    const Box<double> box{Vec3<double>(grid_.position(cell)),
                          Vec3<double>(grid_.position(cornerOf(cell, 7)))};
    const auto isFreeBeyond = [&](const detail::CellFace& face) {
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
  [[nodiscard]] bool isUncutBeyond(const detail::CellFace& face, const NodeOffset& cell,
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

  const detail::SurfaceBlocks<T>& blocks_;
  const std::vector<Vec3<double>>& points_;
  const detail::SharpFeatures<T>& features_;
  const detail::SurfaceGrid<T>& grid_;
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
  detail::joinFeatures(result, fans, points);
  return result;
}

void addTriangles(const std::vector<Triangle>& triangles, PolygonSoup& soup) {
  if (triangles.size() >= kNone || soup.points.size() >= kNone) {
    throw Error(ErrorKind::Limit, "isosurface: more than 2^32 - 2 triangles or points");
  }
  soup.patches.assign(triangles.size(), 0);
  soup.offsets.reserve(triangles.size() + 1);
  soup.corners.reserve(3 * triangles.size());
  for (const auto& triangle : triangles) {
    soup.corners.insert(soup.corners.end(), triangle.begin(), triangle.end());
    soup.offsets.push_back(soup.corners.size());
  }
}

/// Gives the first `count` triangles the patches of the solid, and the others a patch of their own.
template <std::floating_point T>
void setPatches(const SignedDistanceFunction<T>& solid, PolygonSoup& soup, std::size_t count,
                int threads) {
  if (soup.patchNames.size() > 1) {
    parallelFor(count, {.threads = threads, .grain = 256}, [&](std::size_t begin, std::size_t end) {
      for (auto n = begin; n < end; ++n) {
        const auto corner = [&](std::size_t i) { return soup.points[soup.polygon(n)[i]]; };
        const auto middle = (1.0 / 3) * (corner(0) + corner(1) + corner(2));
        soup.patches[n] = solid.owner(Vec3<T>(middle)).patch;
      }
    });
  }
  if (count == soup.patches.size()) return;
  const auto ends = static_cast<std::uint32_t>(soup.patchNames.size());
  soup.patchNames.emplace_back("end of grid");
  std::fill(soup.patches.begin() + static_cast<std::ptrdiff_t>(count), soup.patches.end(), ends);
}

}  // namespace

template <std::floating_point T>
PolygonSoup isosurface(const SignedDistanceFunction<T>& solid, const GridPatch<T>& nodes,
                       const IsosurfaceOptions& options) {
  require(nodes.level.centering() == Centering::Node, "isosurface: need a level of nodes");
  for (int axis = 0; axis < 3; ++axis) {
    require(nodes.indices.length(axis) >= 2, "isosurface: need two nodes along each axis",
            Named{"axis", axis});
    if (nodes.indices.length(axis) > std::size_t{1} << 31U) {
      throw Error(ErrorKind::Limit, "isosurface: more than 2^31 nodes along an axis");
    }
  }
  require(options.tolerance >= 1e-9 && options.tolerance <= 0.5,
          "isosurface: need 1e-9 <= tolerance <= 0.5", Named{"tolerance", options.tolerance});
  require(options.featureAngle > 0, "isosurface: need featureAngle > 0",
          Named{"featureAngle", options.featureAngle});
  require(options.threads >= 0, "isosurface: need threads >= 0", Named{"threads", options.threads});

  const detail::SurfaceGrid<T> grid{solid, nodes, options.tolerance};
  const ParallelOptions parallel{.threads = options.threads, .progress = options.progress};
  detail::SurfaceBlocks<T> blocks(grid, parallel);
  PolygonSoup result;
  blocks.takePoints(result.points);

  const detail::SharpFeatures<T> features(solid, options.featureAngle);
  const BlockMesher<T> mesher(blocks, result.points, features, grid);
  std::vector<MeshPart> parts(blocks.blocks().size());
  parallelFor(parts.size(), {.threads = options.threads}, [&](std::size_t begin, std::size_t end) {
    for (auto n = begin; n < end; ++n) parts[n] = mesher.mesh(n);
  });
  auto triangles = joined(parts, result.points);
  const std::size_t count = triangles.size();
  GridEnds<T>(grid, blocks, result.points).close(triangles);
  addTriangles(triangles, result);
  result.patchNames = solid.patchNames();
  setPatches(solid, result, count, options.threads);
  return result;
}

template <std::floating_point T>
GridPatch<T> nodesAround(const Box<T>& box, T spacing) {
  require(!box.empty() && isFinite(box.lower) && isFinite(box.upper),
          "nodesAround: need a box that is finite and not empty");
  require(spacing > 0 && std::isfinite(spacing), "nodesAround: need a positive, finite spacing",
          Named{"spacing", spacing});
  std::array<std::int32_t, 3> count{};
  Vec3<T> origin;
  for (int axis = 0; axis < 3; ++axis) {
    const T cells = std::ceil(box.size()[axis] / spacing) + 2;
    require(cells < T(0x1p31) - 128, "nodesAround: need less than 2^31 nodes along each axis",
            Named{"axis", axis}, Named{"spacing", spacing});
    count[static_cast<std::size_t>(axis)] = static_cast<std::int32_t>(cells) + 1;
    origin[axis] = box.center()[axis] - T(0.5) * cells * spacing;
  }
  return {Level<T>(origin, {spacing, spacing, spacing}, Centering::Node),
          IndexBox::ofSize(count[0], count[1], count[2])};
}

template PolygonSoup isosurface(const SignedDistanceFunction<float>&, const GridPatch<float>&,
                                const IsosurfaceOptions&);
template PolygonSoup isosurface(const SignedDistanceFunction<double>&, const GridPatch<double>&,
                                const IsosurfaceOptions&);
template GridPatch<float> nodesAround(const Box<float>&, float);
template GridPatch<double> nodesAround(const Box<double>&, double);

}  // namespace cutwater
