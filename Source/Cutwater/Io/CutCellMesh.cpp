#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/CutCells/CutLeaves.hpp>
#include <Cutwater/Grid/OctreeCells.hpp>
#include <Cutwater/Io/PointData.hpp>

#include <algorithm>
#include <array>
#include <tuple>
#include <type_traits>
#include <utility>

// Cut cells as polyhedra.

namespace cutwater {

namespace {

constexpr std::uint8_t kHexahedron = 12;
constexpr std::uint8_t kPolyhedron = 42;

auto inOrder(const Vec3<double>& p) {
  return std::tie(p.x, p.y, p.z);
}

/// Each of many points once, in ascending order.
class DistinctPoints {
 public:
  void add(std::span<const Vec3<double>> points) {
    points_.insert(points_.end(), points.begin(), points.end());
  }
  void sort() {
    std::ranges::sort(points_, {}, inOrder);
    points_.erase(std::unique(points_.begin(), points_.end()), points_.end());
  }
  [[nodiscard]] std::uint64_t numberOf(const Vec3<double>& p) const {
    const auto found = std::ranges::lower_bound(points_, inOrder(p), {}, inOrder);
    return static_cast<std::uint64_t>(found - points_.begin());
  }
  [[nodiscard]] std::vector<Vec3<double>> take() && { return std::move(points_); }

 private:
  std::vector<Vec3<double>> points_;
};

/// The corners of a hexahedron in VTK's order.
std::array<Vec3<double>, 8> cornersOf(const Box<double>& box) {
  std::array<Vec3<double>, 8> corners;
  constexpr std::array<int, 8> kOrder{0, 1, 3, 2, 4, 5, 7, 6};
  std::ranges::transform(kOrder, corners.begin(), [&](int n) { return box.corner(n); });
  return corners;
}

/// What a polyhedron says of its cell.
struct CellName {
  Index3 index;
  std::int32_t leaf = 0;  ///< of octrees
  std::int32_t level = 0;
  Box<double> box;
};

/// What cut cells are asked for, beside their rows.
class CellsOfGrid {
 public:
  explicit CellsOfGrid(const CutCells& cells) : cells_(cells) {}

  [[nodiscard]] const CutCells& cut() const { return cells_; }
  [[nodiscard]] std::size_t pieceCount() const { return cells_.pieceCount; }
  [[nodiscard]] const std::vector<std::uint32_t>& firstPiece() const {
    return cells_.cells.firstPiece;
  }
  [[nodiscard]] CellName name(std::uint32_t row) const { return named(cells_.cells.index[row]); }
  /// Those that are all fluid.
  [[nodiscard]] std::vector<CellName> whole() const {
    std::vector<CellName> result;
    const auto box = cells_.grid.indices();
    for (std::uint32_t k = 0; k < box.length(2); ++k) {
      for (std::uint32_t j = 0; j < box.length(1); ++j) {
        for (std::uint32_t i = 0; i < box.length(0); ++i) {
          const auto cell = box.at(i, j, k);
          if (cells_.classOf(cell) == FluidClass::Fluid) result.push_back(named(cell));
        }
      }
    }
    return result;
  }

 private:
  [[nodiscard]] CellName named(const Index3& index) const {
    return {.index = index, .leaf = 0, .level = 0, .box = cells_.boxOf(index)};
  }

  const CutCells& cells_;
};

/// The same of leaves.
template <std::floating_point T>
class LeavesOfOctree {
 public:
  LeavesOfOctree(const CutLeaves& leaves, const OctreeCells<T>& mesh)
      : leaves_(leaves), mesh_(mesh) {}

  [[nodiscard]] const CutLeaves& cut() const { return leaves_; }
  [[nodiscard]] std::size_t pieceCount() const { return leaves_.pieces.cell.size(); }
  [[nodiscard]] const std::vector<std::uint32_t>& firstPiece() const {
    return leaves_.cut.firstPiece;
  }
  [[nodiscard]] CellName name(std::uint32_t row) const { return named(leaves_.cut.leaf[row]); }
  [[nodiscard]] std::vector<CellName> whole() const {
    std::vector<CellName> result;
    for (std::uint32_t leaf = 0; leaf < leaves_.classes.size(); ++leaf) {
      if (leaves_.classes[leaf] == FluidClass::Fluid) result.push_back(named(leaf));
    }
    return result;
  }

 private:
  /// Between planes as its neighbours have them.
  [[nodiscard]] CellName named(std::uint32_t leaf) const {
    const auto& [index, level, kind] = mesh_.cells()[leaf];
    const auto grid = mesh_.domain().level(level);
    const Index3 next{index.i + 1, index.j + 1, index.k + 1};
    return {.index = index,
            .leaf = static_cast<std::int32_t>(leaf),
            .level = level,
            .box = {Vec3<double>(grid.cell(index).lower), Vec3<double>(grid.cell(next).lower)}};
  }

  const CutLeaves& leaves_;
  const OctreeCells<T>& mesh_;
};

template <typename Cells>
class MeshOfCells {
 public:
  explicit MeshOfCells(const Cells& from)
      : from_(from), cells_(from.cut()), arcs_(from.pieceCount()) {
    require(from.pieceCount() == 0 || !cells_.firstWallPolygon.empty(),
            "cutCellMesh: need cells that were cut with their polygons");
    for (std::uint32_t arc = 0; arc < cells_.arcs.area.size(); ++arc) {
      for (const auto piece : {cells_.arcs.below[arc], cells_.arcs.above[arc]}) {
        if (piece < from.pieceCount()) arcs_[piece].push_back(arc);
      }
    }
  }

  PointData made(bool wholeCells) {
    if (wholeCells) whole_ = from_.whole();
    gatherPoints();
    std::size_t wall = 0;
    for (std::uint32_t piece = 0; piece < from_.pieceCount(); ++piece) addPiece(piece, wall);
    for (const auto& cell : whole_) addWhole(cell);
    mesh_.mesh = DataMesh::Unstructured;
    mesh_.points = std::move(points_).take();
    mesh_.patchNames = cells_.patchNames;
    mesh_.cellArrays = {
        {"fraction", std::move(fraction_)},  {"volume", std::move(volume_)},
        {"wall_area", std::move(wallArea_)}, {"wall_vector", std::move(wallVector_), 3},
        {"patch", std::move(patch_)},        {"pieces", std::move(pieces_)},
        {"cell", std::move(cell_), 3}};
    if constexpr (kIsOctree) {
      mesh_.cellArrays.push_back({"leaf", std::move(leaf_)});
      mesh_.cellArrays.push_back({"level", std::move(level_)});
    }
    return std::move(mesh_);
  }

 private:
  void gatherPoints() {
    points_.add(cells_.arcPolygons.points);
    points_.add(cells_.wallPolygons.points);
    for (const auto& cell : whole_) points_.add(cornersOf(cell.box));
    points_.sort();
  }

  /// `wall`: the first part of the piece's wall; moves on to that of the next piece.
  void addPiece(std::uint32_t piece, std::size_t& wall) {
    const auto firstFace = mesh_.cells.faces.size();
    mesh_.cells.faces.push_back(0);
    corners_.clear();
    for (const auto arc : arcs_[piece]) {
      addFace(cells_.arcPolygons.of(arc), cells_.arcs.below[arc] == piece, firstFace);
    }
    const auto& parts = cells_.wallParts;
    std::int32_t patch = -1;
    double most = 0;
    for (; wall < parts.piece.size() && parts.piece[wall] == piece; ++wall) {
      for (auto n = cells_.firstWallPolygon[wall]; n < cells_.firstWallPolygon[wall + 1]; ++n) {
        addFace(cells_.wallPolygons.of(n), false, firstFace);
      }
      if (parts.area[wall] <= most && patch >= 0) continue;
      most = parts.area[wall];
      patch = static_cast<std::int32_t>(parts.patch[wall]);
    }
    std::ranges::sort(corners_);
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    endCell(kPolyhedron);
    mesh_.cells.faceEnds.push_back(static_cast<std::int64_t>(mesh_.cells.faces.size()));
    const auto row = cells_.pieces.cell[piece];
    addValues(from_.name(row), cells_.volumeFraction(piece), cells_.pieces.volume[piece],
              cells_.pieces.wallArea[piece], cells_.pieces.wallVector[piece], patch);
    pieces_.push_back(
        static_cast<std::int32_t>(from_.firstPiece()[row + 1] - from_.firstPiece()[row]));
  }
  /// Faces are counterclockwise as seen from outside.
  void addFace(std::span<const Vec3<double>> polygon, bool isOutward, std::size_t firstFace) {
    if (polygon.size() < 3) return;
    auto& faces = mesh_.cells.faces;
    ++faces[firstFace];
    faces.push_back(polygon.size());
    for (std::size_t n = 0; n < polygon.size(); ++n) {
      const auto& p = polygon[isOutward ? n : polygon.size() - 1 - n];
      faces.push_back(points_.numberOf(p));
      corners_.push_back(faces.back());
    }
  }
  void addWhole(const CellName& cell) {
    corners_.clear();
    for (const auto& p : cornersOf(cell.box)) corners_.push_back(points_.numberOf(p));
    endCell(kHexahedron);
    mesh_.cells.faceEnds.push_back(-1);
    const auto size = cell.box.size();
    addValues(cell, 1, size.x * size.y * size.z, 0, {}, -1);
    pieces_.push_back(1);
  }
  void endCell(std::uint8_t kind) {
    mesh_.cells.kinds.push_back(kind);
    mesh_.cells.corners.insert(mesh_.cells.corners.end(), corners_.begin(), corners_.end());
    mesh_.cells.offsets.push_back(mesh_.cells.corners.size());
  }
  void addValues(const CellName& cell, double fraction, double volume, double wallArea,
                 const Vec3<double>& wallVector, std::int32_t patch) {
    fraction_.push_back(fraction);
    volume_.push_back(volume);
    wallArea_.push_back(wallArea);
    patch_.push_back(patch);
    for (int axis = 0; axis < 3; ++axis) wallVector_.push_back(wallVector[axis]);
    cell_.insert(cell_.end(), {cell.index.i, cell.index.j, cell.index.k});
    if constexpr (kIsOctree) {
      leaf_.push_back(cell.leaf);
      level_.push_back(cell.level);
    }
  }

  using Cut = std::remove_cvref_t<decltype(std::declval<Cells>().cut())>;
  static constexpr bool kIsOctree = std::is_same_v<Cut, CutLeaves>;

  const Cells& from_;
  const Cut& cells_;
  std::vector<std::vector<std::uint32_t>> arcs_;  // of each piece
  std::vector<CellName> whole_;
  DistinctPoints points_;
  std::vector<std::uint64_t> corners_;  // of the cell at hand
  PointData mesh_;
  std::vector<double> fraction_;
  std::vector<double> volume_;
  std::vector<double> wallArea_;
  std::vector<double> wallVector_;
  std::vector<std::int32_t> patch_;
  std::vector<std::int32_t> pieces_;
  std::vector<std::int32_t> cell_;
  std::vector<std::int32_t> leaf_;
  std::vector<std::int32_t> level_;
};

}  // namespace

PointData cutCellMesh(const CutCells& cells, bool wholeCells) {
  return MeshOfCells(CellsOfGrid(cells)).made(wholeCells);
}

template <std::floating_point T>
PointData cutCellMesh(const CutLeaves& leaves, const OctreeCells<T>& mesh, bool wholeLeaves) {
  require(leaves.classes.size() == mesh.cells().size(),
          "cutCellMesh: need the octree whose leaves were cut",
          Named{"leaves", leaves.classes.size()}, Named{"cells", mesh.cells().size()});
  return MeshOfCells(LeavesOfOctree(leaves, mesh)).made(wholeLeaves);
}

template PointData cutCellMesh(const CutLeaves&, const OctreeCells<float>&, bool);
template PointData cutCellMesh(const CutLeaves&, const OctreeCells<double>&, bool);

}  // namespace cutwater
