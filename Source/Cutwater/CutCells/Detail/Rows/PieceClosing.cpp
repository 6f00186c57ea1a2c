#include <Cutwater/CutCells/Detail/Faces/ThinLoops.hpp>
#include <Cutwater/CutCells/Detail/Rows/CutRows.hpp>
#include <Cutwater/CutCells/Detail/Rows/PieceClosing.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace cutwater {

namespace {

using Loop = EdgeLoops::Loop;

template <typename Cut>
class Closing {
 public:
  explicit Closing(Cut& cut) : cut_(cut), arcs_(pieceCount(cut)), isClosed_(arcs_.size()) {
    for (std::uint32_t arc = 0; arc < cut.arcs.area.size(); ++arc) {
      for (const auto piece : {cut.arcs.below[arc], cut.arcs.above[arc]}) {
        if (piece < arcs_.size() && mayHaveGaps(piece)) {
          arcs_[piece].push_back(arc);
        }
      }
    }
  }

  void run() {
    closeWithWalls();
    for (std::uint32_t piece = 0; piece < arcs_.size(); ++piece) {
      if (!arcs_[piece].empty() && isClosed_[piece] == 0) closeWithoutWalls(piece);
    }
    if (!added_.empty()) addToOutlines();
  }

 private:
  /// In cells where triangles meet, and of solids that are no meshes.
  [[nodiscard]] bool mayHaveGaps(std::uint32_t piece) const {
    const auto& rows = rowsOf(cut_);
    return !rows.error.empty() || rows.meets[cut_.pieces.cell[piece]] != 0;
  }

  void closeWithWalls() {
    const auto& pieces = cut_.wallParts.piece;
    std::vector<std::uint64_t> firstPolygon;
    for (std::size_t part = 0; part < pieces.size();) {
      const auto piece = pieces[part];
      auto last = part;
      std::vector<Loop> walls;
      std::vector<std::size_t> firstOfPart;
      for (; last < pieces.size() && pieces[last] == piece; ++last) {
        firstOfPart.push_back(walls.size());
        for (auto n = cut_.firstWallPolygon[last]; n < cut_.firstWallPolygon[last + 1]; ++n) {
          const auto polygon = cut_.wallPolygons.of(n);
          walls.emplace_back(polygon.begin(), polygon.end());
        }
      }
      const bool isOwn = piece < arcs_.size();
      if (isOwn) isClosed_[piece] = 1;
      if (isOwn && mayHaveGaps(piece)) {
        for (auto& loop : gapsOf(piece, walls)) walls.push_back(std::move(loop));
      }
      for (const auto first : firstOfPart) firstPolygon.push_back(closed_.count() + first);
      for (const auto& polygon : walls) closed_.add(polygon);
      part = last;
    }
    firstPolygon.push_back(closed_.count());
    cut_.firstWallPolygon = std::move(firstPolygon);
    cut_.wallPolygons = std::move(closed_);
  }

  /// Rims of polygons into the fluid that close a piece with these walls.
  [[nodiscard]] std::vector<Loop> gapsOf(std::uint32_t piece, std::span<const Loop> walls) const {
    EdgeLoops boundary;
    for (const auto arc : arcs_[piece]) {
      boundary.add(cut_.arcPolygons.of(arc), cut_.arcs.below[arc] != piece);
    }
    for (const auto& polygon : walls) boundary.add(polygon, true);
    // What is left of the boundary, as seen from outside, is such a rim.
    return thinLoops(std::move(boundary));
  }

  void closeWithoutWalls(std::uint32_t piece) {
    const auto isOpen = [&](std::uint32_t arc) {
      return cut_.openArcs.patchOf(arc) != CutCells::kNoRow;
    };
    std::vector<std::uint32_t> open;
    std::ranges::copy_if(arcs_[piece], std::back_inserter(open), isOpen);
    if (open.empty()) return;
    for (auto& gap : gapsOf(piece, {})) {
      const auto distance = [&](std::uint32_t arc) { return distanceFrom(arc, gap); };
      const auto arc = *std::ranges::min_element(open, {}, distance);
      if (cut_.arcs.below[arc] == piece) std::ranges::reverse(gap);
      added_[arc].push_back(std::move(gap));
    }
  }
  /// Of points from the plane of an arc.
  [[nodiscard]] double distanceFrom(std::uint32_t arc, const Loop& points) const {
    const int axis = cut_.arcs.axis[arc];
    double distance = 0;
    for (const auto& p : points) {
      distance = std::max(distance, std::abs(p[axis] - cut_.arcs.centroid[arc][axis]));
    }
    return distance;
  }
  void addToOutlines() {
    CutCells::Polygons outlines;
    for (std::uint32_t arc = 0; arc < cut_.arcs.area.size(); ++arc) {
      const auto outline = cut_.arcPolygons.of(arc);
      const auto added = added_.find(arc);
      if (added == added_.end()) {
        outlines.add(outline);
      } else {
        outlines.add(withLoops({outline.begin(), outline.end()}, added->second));
      }
    }
    cut_.arcPolygons = std::move(outlines);
  }
  /// An outline that goes from the corner nearest to a loop around that, and back.
  static Loop withLoops(Loop outline, std::span<const Loop> loops) {
    for (const auto& loop : loops) {
      const auto way = [&](const Vec3<double>& p) { return lengthSquared(p - loop.front()); };
      const auto at = std::ranges::min_element(outline, {}, way);
      Loop around(loop);
      if (*at != loop.front()) around.push_back(loop.front());
      around.push_back(*at);
      if (*at == loop.front()) around.erase(around.begin());
      outline.insert(at + 1, around.begin(), around.end());
    }
    return outline;
  }

  Cut& cut_;
  std::vector<std::vector<std::uint32_t>> arcs_;  // of pieces in cells where triangles meet
  std::vector<char> isClosed_;                    // pieces with parts of a wall
  CutCells::Polygons closed_;
  std::map<std::uint32_t, std::vector<Loop>> added_;  // to outlines of open patches
};

template <typename Cut>
void closeAll(Cut& cut) {
  const auto& meets = rowsOf(cut).meets;
  const bool meetsNowhere = std::ranges::count(meets, 0) == std::ssize(meets);
  if (meetsNowhere && rowsOf(cut).error.empty()) return;
  Closing(cut).run();
}

}  // namespace

void closePieces(CutCells& cells) {
  closeAll(cells);
}

void closePieces(CutLeaves& leaves) {
  closeAll(leaves);
}

}  // namespace cutwater
