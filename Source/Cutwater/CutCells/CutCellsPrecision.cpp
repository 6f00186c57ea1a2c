#include <Cutwater/CutCells/CutCells.hpp>

namespace cutwater {

namespace {

/// The vectors that close the pieces of the box, by the rounded open parts.
template <typename T>
std::vector<Vec3<double>> closingVectors(const CutCells& cells, const std::vector<T>& areas) {
  std::vector<Vec3<double>> result(cells.pieceCount);
  for (std::size_t a = 0; a < areas.size(); ++a) {
    const int axis = cells.arcs.axis[a];
    const auto below = cells.arcs.below[a];
    const auto above = cells.arcs.above[a];
    if (below < cells.pieceCount) result[below][axis] -= double{areas[a]};
    if (above < cells.pieceCount) result[above][axis] += double{areas[a]};
  }
  return result;
}

Vec3<double> centerOfFace(const CutCells& cells, std::size_t arc) {
  const int axis = cells.arcs.axis[arc];
  const auto box = cells.boxOf(cells.arcs.cell[arc]);
  auto center = box.center();
  center[axis] = box.lower[axis];
  return center;
}

/// Lets the parts of each piece's wall add up to it, by the largest of them.
template <typename T>
void closeParts(const CutCells& cells, CutNumbers<T>& numbers) {
  const auto& piece = cells.wallParts.piece;
  auto& vectors = numbers.wallParts.vector;
  for (std::size_t first = 0, last = 0; first < piece.size(); first = last) {
    auto largest = first;
    Vec3<double> rest(numbers.pieces.wallVector[piece[first]]);
    for (; last < piece.size() && piece[last] == piece[first]; ++last) {
      if (cells.wallParts.area[last] > cells.wallParts.area[largest]) largest = last;
      rest = rest - Vec3<double>(vectors[last]);
    }
    vectors[largest] = Vec3<T>(Vec3<double>(vectors[largest]) + rest);
  }
}

}  // namespace

template <std::floating_point T>
CutNumbers<T> inPrecision(const CutCells& cells) {
  CutNumbers<T> result;
  for (std::size_t a = 0; a < cells.arcs.area.size(); ++a) {
    result.arcs.area.push_back(static_cast<T>(cells.arcs.area[a]));
    result.arcs.centroid.push_back(Vec3<T>(cells.arcs.centroid[a] - centerOfFace(cells, a)));
  }
  const auto closing = closingVectors(cells, result.arcs.area);
  const auto centerOf = [&](std::uint32_t piece) {
    return cells.boxOf(cells.cells.index[cells.pieces.cell[piece]]).center();
  };
  const auto& pieces = cells.pieces;
  for (std::uint32_t p = 0; p < pieces.volume.size(); ++p) {
    const auto center = centerOf(p);
    auto& out = result.pieces;
    out.volume.push_back(static_cast<T>(pieces.volume[p]));
    out.centroid.push_back(Vec3<T>(pieces.centroid[p] - center));
    out.wallArea.push_back(static_cast<T>(pieces.wallArea[p]));
    out.wallVector.push_back(Vec3<T>(p < cells.pieceCount ? closing[p] : pieces.wallVector[p]));
    out.wallCentroid.push_back(Vec3<T>(pieces.wallCentroid[p] - center));
  }
  const auto& parts = cells.wallParts;
  for (std::size_t n = 0; n < parts.piece.size(); ++n) {
    result.wallParts.area.push_back(static_cast<T>(parts.area[n]));
    result.wallParts.vector.push_back(Vec3<T>(parts.vector[n]));
    result.wallParts.centroid.push_back(Vec3<T>(parts.centroid[n] - centerOf(parts.piece[n])));
  }
  closeParts(cells, result);
  return result;
}

template CutNumbers<float> inPrecision(const CutCells&);
template CutNumbers<double> inPrecision(const CutCells&);

}  // namespace cutwater
