#include <Cutwater/Core/Detail/ParallelBatches.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CutRegions.hpp>
#include <Cutwater/CutCells/Detail/Leaves/LeafGrid.hpp>
#include <Cutwater/Grid/OctreeNodes.hpp>
#include <Cutwater/Polyhedra/Detail/EdgeMeetings.hpp>
#include <Cutwater/Polyhedra/Detail/FaceRows.hpp>
#include <Cutwater/Polyhedra/Detail/FluidCells.hpp>
#include <Cutwater/Polyhedra/Detail/JoinedWalls.hpp>
#include <Cutwater/Polyhedra/Detail/KeptRegions.hpp>
#include <Cutwater/Polyhedra/Detail/MendedCells.hpp>
#include <Cutwater/Polyhedra/Detail/PointNumbers.hpp>
#include <Cutwater/Polyhedra/Detail/SimpleLoops.hpp>
#include <Cutwater/Polyhedra/FluidMesh.hpp>

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace cutwater {

namespace {

constexpr auto kNone = FluidCells::kNone;
constexpr std::array<const char*, 6> kSides{"xMin", "xMax", "yMin", "yMax", "zMin", "zMax"};

/// OpenFOAM, and most others, count by 31 bits.
void requireLabel(std::size_t count, const char* what) {
  if (count <= static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) return;
  throw Error(ErrorKind::Limit, std::string("fluidMesh: too many ") + what);
}

/// Builds a FluidMesh.
template <std::floating_point T>
class MeshOfFluid {
 public:
  MeshOfFluid(const CutLeaves& leaves, const OctreeCells<T>& mesh, const FluidMeshOptions& options)
      : leaves_(leaves),
        grid_(mesh, CutFrame{}),
        nodes_(mesh, {.threads = options.threads}),
        options_(options),
        regions_(leaves, mesh, grid_, options),
        cells_(leaves, grid_, regions_, options.smallest),
        axes_(cells_.rows().leaf.size(), 0),
        numberOfNode_(nodes_.count(), kNone) {}

  FluidMesh made() {
    addArcs();
    addWholeFaces();
    addWalls();
    FluidMesh result;
    result.cells = cells_.rows();
    result.joinedPieces = cells_.joinedPieces();
    result.regions = regions_.volumes();
    result.lostRegions = regions_.lostCount();
    result.lostVolume = regions_.lostVolume();
    result.patches = patches();
    result.faces = faces_.inOrder(result.cells.leaf.size(), points_.points(), result.patches);
    std::erase_if(result.patches, [](const auto& patch) { return patch.faceCount == 0; });
    result.points = std::move(points_).take();
    meetEdgeByEdge(result, options_.threads);
    const bool isExact = leaves_.cut.error.empty();
    result = withMendedCells(std::move(result), {.joins = !options_.wallPolygons,
                                                 .joinsSides = !options_.wallPolygons && !isExact,
                                                 .threads = options_.threads});
    dropUnused(result);
    requireLabel(result.faces.count(), "faces");
    requireLabel(result.points.size(), "points");
    return result;
  }

 private:
  [[nodiscard]] std::vector<FluidMesh::Patch> patches() const {
    std::vector<FluidMesh::Patch> result;
    for (const auto& name : leaves_.patchNames) result.push_back({.name = name});
    for (const auto patch : leaves_.openArcs.patch) {
      result[patch].kind = FluidMesh::PatchKind::Open;
    }
    for (const auto* side : kSides) {
      result.push_back({.name = side, .kind = FluidMesh::PatchKind::Side});
    }
    return result;
  }
  [[nodiscard]] std::uint32_t patchOfSide(int axis, bool isHigh) const {
    return static_cast<std::uint32_t>(leaves_.patchNames.size() + asIndex(2 * axis) +
                                      (isHigh ? 1U : 0U));
  }

  CornerLoop numbered(std::span<const Vec3<double>> polygon) {
    CornerLoop loop;
    for (const auto& point : polygon) loop.push_back(points_.of(point));
    return loop;
  }

  void addArcs() {
    const auto& arcs = leaves_.arcs;
    std::vector<CornerLoop> loops;
    std::size_t open = 0;
    for (std::uint32_t arc = 0; arc < arcs.area.size(); ++arc) {
      const auto below = cells_.beside(arcs.below[arc], arcs.leafBelow[arc]);
      const auto above = cells_.beside(arcs.above[arc], arcs.leafAbove[arc]);
      const bool isOpen = open < leaves_.openArcs.arc.size() && leaves_.openArcs.arc[open] == arc;
      const int axis = arcs.axis[arc];
      const auto patch = isOpen ? leaves_.openArcs.patch[open] : patchOfSide(axis, above == kNone);
      open += isOpen ? 1 : 0;
      if (below == above) continue;  // joined, or left out
      if (!isOpen && below == kNone) requireSide(arcs.leafAbove[arc], axis, false);
      if (!isOpen && above == kNone) requireSide(arcs.leafBelow[arc], axis, true);
      loops.clear();
      divideIntoLoops(numbered(leaves_.arcPolygons.of(arc)), points_.points(), axis, loops);
      for (auto& loop : loops) {
        if (below == kNone) std::ranges::reverse(loop);
        addFace(loop, below == kNone ? above : below, below == kNone ? kNone : above, patch, axis);
      }
    }
  }

  /// Adds one across an axis, see FaceRows.
  void addFace(std::span<const std::uint32_t> loop, std::uint32_t cell, std::uint32_t other,
               std::uint32_t patch, int axis) {
    faces_.add(loop, cell, other, patch);
    for (const auto side : {cell, other}) {
      if (side == kNone) continue;
      axes_[side] |= static_cast<std::uint8_t>(1U << static_cast<unsigned>(axis));
    }
  }

  /// What patches have of the walls of all pieces that were joined in a cell. Points are numbered
  /// and faces added in order, by one thread; polygons are joined by all.
  void addWalls() {
    constexpr std::size_t kRound = 4096;
    constexpr std::size_t kBatch = 16;
    const auto& pieces = leaves_.wallParts.piece;
    std::vector<std::uint32_t> order(pieces.size());
    std::iota(order.begin(), order.end(), std::uint32_t{0});
    std::ranges::stable_sort(order, {}, [&](std::uint32_t part) {
      return std::pair(cells_.ofPiece(pieces[part]), leaves_.wallParts.patch[part]);
    });
    std::vector<CellWall> walls;
    const auto addRound = [&] {
      detail::parallelBatches(walls.size(), kBatch, {.threads = options_.threads},
                              [&](std::size_t first, std::size_t count) {
                                for (auto& wall : std::span(walls).subspan(first, count)) {
                                  joinWall(wall, faces_.countOf(wall.cell), axes_[wall.cell],
                                           points_.points(), options_.wallPolygons);
                                }
                              });
      for (const auto& wall : walls) {
        for (const auto& [patch, loops] : wall.parts) {
          for (const auto& loop : loops) faces_.add(loop, wall.cell, kNone, patch);
        }
      }
      walls.clear();
    };
    for (const auto part : order) {
      const auto cell = cells_.ofPiece(pieces[part]);
      if (cell == kNone) break;
      if (walls.empty() || walls.back().cell != cell) {
        if (walls.size() == kRound) addRound();
        walls.push_back({.cell = cell, .parts = {}});
      }
      auto& parts = walls.back().parts;
      const auto patch = leaves_.wallParts.patch[part];
      if (parts.empty() || parts.back().patch != patch) parts.push_back({patch, {}});
      addPolygons(part, parts.back().loops);
    }
    addRound();
  }
  void addPolygons(std::uint32_t part, std::vector<CornerLoop>& polygons) {
    for (auto n = leaves_.firstWallPolygon[part]; n < leaves_.firstWallPolygon[part + 1]; ++n) {
      auto loop = numbered(leaves_.wallPolygons.of(n));
      std::ranges::reverse(loop);  // out of the fluid
      addSimpleLoops(loop, polygons);
    }
  }

  /// One of a leaf that is all fluid, whose cell has it; across is another such leaf's, or nothing.
  struct WholeFace {
    std::uint32_t leaf;
    int axis;
    bool isHigh;
    std::uint32_t across;
    std::array<std::uint64_t, 4> nodes;  // counterclockwise as seen from outside
  };

  /// Those between leaves that are all fluid, from the finer one, and in the sides of the domain:
  /// found by all threads, and added in order.
  void addWholeFaces() {
    constexpr std::size_t kRound = 65536;
    constexpr std::size_t kBatch = 64;
    std::vector<std::vector<WholeFace>> found(kRound / kBatch);
    const auto leaves = leaves_.classes.size();
    for (std::size_t first = 0; first < leaves; first += kRound) {
      detail::parallelBatches(std::min(kRound, leaves - first), kBatch,
                              {.threads = options_.threads},
                              [&](std::size_t batch, std::size_t count) {
                                findWholeFaces(first + batch, count, found[batch / kBatch]);
                              });
      for (auto& faces : found) {
        for (const auto& face : faces) addWholeFace(face);
        faces.clear();
      }
    }
  }
  void findWholeFaces(std::size_t first, std::size_t count, std::vector<WholeFace>& found) const {
    std::vector<typename OctreeNodes<T>::Corners> corners(count);
    nodes_.corners(first, corners);
    for (std::size_t n = 0; n < count; ++n) {
      const auto leaf = static_cast<std::uint32_t>(first + n);
      const auto cell = cells_.ofLeaf(leaf);
      if (cell == kNone) continue;
      for (int axis = 0; axis < 3; ++axis) {
        for (const bool isHigh : {false, true}) {
          const auto [what, other] = grid_.across(leaf, axis, isHigh);
          if (what == LeafGrid::Across::Finer) continue;
          if (what == LeafGrid::Across::Same && isHigh) continue;  // that leaf's low face
          const bool isSide = what == LeafGrid::Across::Nothing;
          const auto across = isSide ? kNone : cells_.ofLeaf(other);
          if (!isSide && (across == kNone || across == cell)) continue;  // an arc, or joined
          found.push_back({leaf, axis, isHigh, across, around(corners[n], axis, isHigh)});
        }
      }
    }
  }
  static std::array<std::uint64_t, 4> around(const typename OctreeNodes<T>::Corners& corners,
                                             int axis, bool isHigh) {
    const auto first = std::size_t{1} << asIndex((axis + 1) % 3);
    const auto second = std::size_t{1} << asIndex((axis + 2) % 3);
    const auto low = isHigh ? std::size_t{1} << asIndex(axis) : 0;
    std::array nodes{corners[low], corners[low + first], corners[low + first + second],
                     corners[low + second]};
    if (!isHigh) std::ranges::reverse(nodes);
    return nodes;
  }
  void addWholeFace(const WholeFace& face) {
    if (face.across == kNone) requireSide(face.leaf, face.axis, face.isHigh);
    std::array<std::uint32_t, 4> loop{};
    std::ranges::transform(face.nodes, loop.begin(), [&](auto node) { return ofNode(node); });
    addFace(loop, cells_.ofLeaf(face.leaf), face.across, patchOfSide(face.axis, face.isHigh),
            face.axis);
  }
  void requireSide(std::uint32_t leaf, int axis, bool isHigh) const {
    const auto& [index, level, kind] = grid_.leaves()[leaf];
    require(along(index, axis) == (isHigh ? grid_.cells(level, axis) - 1 : 0),
            "fluidMesh: need an octree that fills its domain", Named{"leaf", leaf});
  }
  std::uint32_t ofNode(std::uint64_t node) {
    auto& number = numberOfNode_[node];
    if (number != kNone) return number;
    const auto index = nodes_.index(node);
    Vec3<double> point;
    for (int axis = 0; axis < 3; ++axis) {
      point[axis] = grid_.plane(grid_.deepest(), axis, along(index, axis));
    }
    number = points_.of(point);
    return number;
  }

  /// Numbers points in the order of faces; those that no face has are left out.
  static void dropUnused(FluidMesh& mesh) {
    std::vector<std::uint32_t> number(mesh.points.size(), kNone);
    std::vector<Vec3<double>> kept;
    kept.reserve(mesh.points.size());
    for (auto& corner : mesh.faces.corners) {
      if (number[corner] == kNone) {
        number[corner] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(mesh.points[corner]);
      }
      corner = number[corner];
    }
    mesh.points = std::move(kept);
  }

  const CutLeaves& leaves_;
  LeafGrid grid_;
  OctreeNodes<T> nodes_;
  const FluidMeshOptions& options_;
  KeptRegions regions_;
  FluidCells cells_;
  std::vector<std::uint8_t> axes_;  // of each cell, a mask of those along which it leads on
  std::vector<std::uint32_t> numberOfNode_;
  PointNumbers points_;
  FaceRows faces_;
};

}  // namespace

template <std::floating_point T>
FluidMesh fluidMesh(const CutLeaves& leaves, const OctreeCells<T>& mesh,
                    const FluidMeshOptions& options) {
  require(leaves.classes.size() == mesh.cells().size(), "fluidMesh: need the mesh of these leaves",
          Named{"leaves", leaves.classes.size()}, Named{"cells", mesh.cells().size()});
  require(options.smallest >= 0 && options.smallest <= 1,
          "fluidMesh: need a smallest share from 0 to 1", Named{"smallest", options.smallest});
  require(leaves.pieces.volume.empty() || !leaves.firstWallPolygon.empty(),
          "fluidMesh: need leaves that were cut with their polygons");
  return MeshOfFluid(leaves, mesh, options).made();
}

template FluidMesh fluidMesh(const CutLeaves&, const OctreeCells<float>&, const FluidMeshOptions&);
template FluidMesh fluidMesh(const CutLeaves&, const OctreeCells<double>&, const FluidMeshOptions&);

}  // namespace cutwater
