#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CutCells.hpp>
#include <Cutwater/Io/PointData.hpp>

#include <algorithm>
#include <array>
#include <tuple>

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

class MeshOfCells {
 public:
  explicit MeshOfCells(const CutCells& cells) : cells_(cells), arcs_(cells.pieceCount) {
    require(cells.pieceCount == 0 || !cells.firstWallPolygon.empty(),
            "cutCellMesh: need cells that were cut with their polygons");
    for (std::uint32_t arc = 0; arc < cells.arcs.area.size(); ++arc) {
      for (const auto piece : {cells.arcs.below[arc], cells.arcs.above[arc]}) {
        if (piece < cells.pieceCount) arcs_[piece].push_back(arc);
      }
    }
  }

  PointData made(bool wholeCells) {
    if (wholeCells) findWholeCells();
    gatherPoints();
    std::size_t wall = 0;
    for (std::uint32_t piece = 0; piece < cells_.pieceCount; ++piece) addPiece(piece, wall);
    for (const auto& cell : whole_) addWhole(cell);
    mesh_.mesh = DataMesh::Unstructured;
    mesh_.points = std::move(points_).take();
    mesh_.patchNames = cells_.patchNames;
    mesh_.cellArrays = {
        {"fraction", std::move(fraction_)},  {"volume", std::move(volume_)},
        {"wall_area", std::move(wallArea_)}, {"wall_vector", std::move(wallVector_), 3},
        {"patch", std::move(patch_)},        {"pieces", std::move(pieces_)},
        {"cell", std::move(cell_), 3}};
    return std::move(mesh_);
  }

 private:
  void findWholeCells() {
    const auto box = cells_.grid.indices();
    for (std::uint32_t k = 0; k < box.length(2); ++k) {
      for (std::uint32_t j = 0; j < box.length(1); ++j) {
        for (std::uint32_t i = 0; i < box.length(0); ++i) {
          const auto cell = box.at(i, j, k);
          if (cells_.classOf(cell) == FluidClass::Fluid) whole_.push_back(cell);
        }
      }
    }
  }
  void gatherPoints() {
    points_.add(cells_.arcPolygons.points);
    points_.add(cells_.wallPolygons.points);
    for (const auto& cell : whole_) points_.add(cornersOf(cells_.boxOf(cell)));
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
    addValues(cells_.cells.index[row], cells_.volumeFraction(piece), cells_.pieces.volume[piece],
              cells_.pieces.wallArea[piece], cells_.pieces.wallVector[piece], patch);
    pieces_.push_back(
        static_cast<std::int32_t>(cells_.cells.firstPiece[row + 1] - cells_.cells.firstPiece[row]));
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
  void addWhole(const Index3& cell) {
    corners_.clear();
    for (const auto& p : cornersOf(cells_.boxOf(cell))) corners_.push_back(points_.numberOf(p));
    endCell(kHexahedron);
    mesh_.cells.faceEnds.push_back(-1);
    addValues(cell, 1, cells_.cellVolume(cell), 0, {}, -1);
    pieces_.push_back(1);
  }
  void endCell(std::uint8_t kind) {
    mesh_.cells.kinds.push_back(kind);
    mesh_.cells.corners.insert(mesh_.cells.corners.end(), corners_.begin(), corners_.end());
    mesh_.cells.offsets.push_back(mesh_.cells.corners.size());
  }
  void addValues(const Index3& cell, double fraction, double volume, double wallArea,
                 const Vec3<double>& wallVector, std::int32_t patch) {
    fraction_.push_back(fraction);
    volume_.push_back(volume);
    wallArea_.push_back(wallArea);
    patch_.push_back(patch);
    for (int axis = 0; axis < 3; ++axis) wallVector_.push_back(wallVector[axis]);
    cell_.insert(cell_.end(), {cell.i, cell.j, cell.k});
  }

  const CutCells& cells_;
  std::vector<std::vector<std::uint32_t>> arcs_;  // of each piece
  std::vector<Index3> whole_;
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
};

}  // namespace

PointData cutCellMesh(const CutCells& cells, bool wholeCells) {
  return MeshOfCells(cells).made(wholeCells);
}

}  // namespace cutwater
