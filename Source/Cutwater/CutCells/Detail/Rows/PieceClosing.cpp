#include <Cutwater/CutCells/Detail/Faces/ThinLoops.hpp>
#include <Cutwater/CutCells/Detail/Rows/CutRows.hpp>
#include <Cutwater/CutCells/Detail/Rows/PieceClosing.hpp>

#include <algorithm>
#include <utility>

namespace cutwater {

namespace {

using Loop = EdgeLoops::Loop;

template <typename Cut>
class Closing {
 public:
  explicit Closing(Cut& cut) : cut_(cut), arcs_(pieceCount(cut)) {
    for (std::uint32_t arc = 0; arc < cut.arcs.area.size(); ++arc) {
      for (const auto piece : {cut.arcs.below[arc], cut.arcs.above[arc]}) {
        if (piece < arcs_.size() && rowsOf(cut).meets[cut.pieces.cell[piece]] != 0) {
          arcs_[piece].push_back(arc);
        }
      }
    }
  }

  void run() {
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
      if (isOwn && rowsOf(cut_).meets[cut_.pieces.cell[piece]] != 0) close(piece, walls);
      for (const auto first : firstOfPart) firstPolygon.push_back(closed_.count() + first);
      for (const auto& polygon : walls) closed_.add(polygon);
      part = last;
    }
    firstPolygon.push_back(closed_.count());
    cut_.firstWallPolygon = std::move(firstPolygon);
    cut_.wallPolygons = std::move(closed_);
  }

 private:
  void close(std::uint32_t piece, std::vector<Loop>& walls) {
    EdgeLoops boundary;
    for (const auto arc : arcs_[piece]) {
      boundary.add(cut_.arcPolygons.of(arc), cut_.arcs.below[arc] != piece);
    }
    for (const auto& polygon : walls) boundary.add(polygon, true);
    // What is left of the boundary, as seen from outside, is the rim of a polygon into the fluid.
    for (auto& loop : thinLoops(std::move(boundary))) walls.push_back(std::move(loop));
  }

  Cut& cut_;
  std::vector<std::vector<std::uint32_t>> arcs_;  // of pieces in cells where triangles meet
  CutCells::Polygons closed_;
};

template <typename Cut>
void closeAll(Cut& cut) {
  const auto& meets = rowsOf(cut).meets;
  if (std::ranges::count(meets, 0) == static_cast<std::ptrdiff_t>(meets.size())) return;
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
