#include <Cutwater/CutCells/Detail/Curved/BoxView.hpp>
#include <Cutwater/CutCells/Detail/Curved/CertifiedRows.hpp>
#include <Cutwater/CutCells/Detail/Curved/Certifier.hpp>
#include <Cutwater/CutCells/Detail/CutArguments.hpp>
#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>
#include <Cutwater/Grid/Detail/GridTiles.hpp>

#include <algorithm>
#include <tuple>

namespace cutwater {

namespace {

using Doubtful = CertifiedCells::Doubtful;

void checkOptions(const CertifyOptions& options) {
  require(options.width >= 0 && options.width <= 1, "cut cells: need a width from 0 to 1",
          Named{"width", options.width});
  require(options.boxes > 0, "cut cells: need boxes > 0", Named{"boxes", options.boxes});
}

/// Calls visit(n) for n < count, on several threads.
template <typename Visit>
void forEach(std::size_t count, const CertifyOptions& options, const Visit& visit) {
  parallelFor(count, {.threads = options.threads, .grain = 16},
              [&](std::size_t begin, std::size_t end) {
                for (auto n = begin; n < end; ++n) visit(n);
              });
}

/// The box of a row, and how many pieces it has.
struct CertifiedRow {
  Box<double> box;
  std::size_t pieces = 0;
};
/// Rows of cells or leaves.
template <typename RowAt>
void certifyRows(const Certifier& certifier, std::size_t count, const RowAt& rowAt,
                 const CertifyOptions& options, std::vector<Interval<double>>& shares,
                 std::vector<std::uint32_t>& undecided) {
  shares.resize(count);
  std::vector<char> isUndecided(count);
  forEach(count, options, [&](std::size_t n) {
    const auto row = rowAt(n);
    shares[n] = certifier.shareOf(row.box);
    if (options.pieces) isUndecided[n] = certifier.arePieces(row.box, row.pieces) ? 0 : 1;
  });
  for (std::uint32_t n = 0; n < count; ++n) {
    if (isUndecided[n] != 0) undecided.push_back(n);
  }
}

/// Faces of arcs, which are the same for some that follow each other.
template <typename FaceOf>
[[nodiscard]] std::vector<Interval<double>> certifiedFaces(const Certifier& certifier,
                                                           std::size_t count, const FaceOf& faceOf,
                                                           const CertifyOptions& options) {
  std::vector<Interval<double>> shares(count);
  const auto isAsBefore = [&](std::size_t arc) {
    return arc > 0 && faceOf(arc) == faceOf(arc - 1);
  };
  forEach(count, options, [&](std::size_t arc) {
    if (!isAsBefore(arc)) shares[arc] = certifier.shareOf(faceOf(arc));
  });
  for (std::size_t arc = 1; arc < count; ++arc) {
    if (isAsBefore(arc)) shares[arc] = shares[arc - 1];
  }
  return shares;
}

/// The search for doubtful cells in a box of indices, which is halved while they may be.
class DoubtfulCells {
 public:
  DoubtfulCells(const Certifier& certifier, const CutCells& cells)
      : certifier_(certifier), cells_(cells) {}

  void findIn(const IndexBox& box, Certifier::Around around, std::vector<Doubtful>& found) const {
    const bool isCell = box.count() == 1;
    if (isCell && cells_.rowOf(box.lo) != CutCells::kNoRow) return;
    const Box<double> whole{cells_.boxOf(box.lo).lower, cells_.boxOf(box.hi).upper};
    if (!certifier_.mayBeCut(whole, around)) return;
    if (isCell) {
      if (const auto doubt = certifier_.doubtAt(whole)) found.push_back({box.lo, *doubt});
      return;
    }
    int longest = 0;
    for (const int axis : {1, 2}) {
      if (box.length(axis) > box.length(longest)) longest = axis;
    }
    auto low = box;
    auto high = box;
    along(low.hi, longest) =
        along(box.lo, longest) + static_cast<std::int32_t>(box.length(longest) / 2) - 1;
    along(high.lo, longest) = along(low.hi, longest) + 1;
    findIn(low, around, found);
    findIn(high, around, found);
  }

 private:
  const Certifier& certifier_;
  const CutCells& cells_;
};

std::vector<Doubtful> doubtfulCells(const Certifier& certifier, const CutCells& cells,
                                    const CertifyOptions& options) {
  constexpr detail::Offset kTile{16, 16, 16};
  const DoubtfulCells search(certifier, cells);
  const auto indices = cells.grid.indices();
  const detail::GridTiles tiles(indices, kTile);
  std::vector<std::vector<Doubtful>> found(tiles.count());
  parallelFor(tiles.count(), {.threads = options.threads, .progress = options.progress},
              [&](std::size_t begin, std::size_t end) {
                for (auto n = begin; n < end; ++n) {
                  const auto [first, size] = tiles.tile(n);
                  const IndexBox tile{indices.at(first[0], first[1], first[2]),
                                      indices.at(first[0] + size[0] - 1, first[1] + size[1] - 1,
                                                 first[2] + size[2] - 1)};
                  search.findIn(tile, {}, found[n]);
                }
              });
  std::vector<Doubtful> result;
  for (const auto& some : found) result.insert(result.end(), some.begin(), some.end());
  std::ranges::sort(result, {}, [](const Doubtful& doubt) {
    return std::tuple(doubt.cell.k, doubt.cell.j, doubt.cell.i);
  });
  return result;
}

}  // namespace

void requireInPrecision(const FluidField& field, double plane) {
  require(!field.facts().isSingle || double{static_cast<float>(plane)} == plane,
          "cut cells: need planes in the solid's precision", Named{"plane", plane});
}

CertifiedCells certifiedCells(const FluidField& field, const CutCells& cells,
                              const CutPeriod& period, const CertifyOptions& options) {
  checkOptions(options);
  checkPlanes(cells.grid);
  for (const auto& planes : cells.grid.planes) {
    for (const double plane : planes) requireInPrecision(field, plane);
  }
  const Certifier certifier(field, period, options);
  CertifiedCells result;
  const auto& firstPiece = cells.cells.firstPiece;
  const auto rowAt = [&](std::size_t row) {
    return CertifiedRow{cells.boxOf(cells.cells.index[row]), firstPiece[row + 1] - firstPiece[row]};
  };
  certifyRows(certifier, cells.cellCount, rowAt, options, result.volumeFraction, result.undecided);
  const auto faceOfArc = [&](std::size_t arc) {
    return faceOf(cells.boxOf(cells.arcs.cell[arc]), cells.arcs.axis[arc], false);
  };
  result.aperture = certifiedFaces(certifier, cells.arcs.area.size(), faceOfArc, options);
  result.doubtful = doubtfulCells(certifier, cells, options);
  return result;
}

CertifiedLeaves certifiedLeaves(const FluidField& field, const CutLeaves& leaves,
                                std::span<const Box<double>> boxes, const CertifyOptions& options) {
  checkOptions(options);
  for (const auto& box : boxes) {
    for (int axis = 0; axis < 3; ++axis) {
      requireInPrecision(field, box.lower[axis]);
      requireInPrecision(field, box.upper[axis]);
    }
  }
  const CutPeriod none;
  const Certifier certifier(field, none, options);
  CertifiedLeaves result;
  const auto& cut = leaves.cut;
  const auto rowAt = [&](std::size_t row) {
    return CertifiedRow{cut.box[row], cut.firstPiece[row + 1] - cut.firstPiece[row]};
  };
  certifyRows(certifier, cut.leaf.size(), rowAt, options, result.volumeFraction, result.undecided);

  const auto& arcs = leaves.arcs;
  const auto faceOfArc = [&](std::size_t arc) {
    const auto below = arcs.leafBelow[arc];
    const auto above = arcs.leafAbove[arc];
    const int axis = arcs.axis[arc];
    const auto widthOf = [&](std::uint32_t leaf) { return boxes[leaf].size()[axis]; };
    const bool isBelow = above == CutLeaves::kNoLeaf ||
                         (below != CutLeaves::kNoLeaf && widthOf(below) < widthOf(above));
    return faceOf(boxes[isBelow ? below : above], axis, isBelow);
  };
  result.aperture = certifiedFaces(certifier, arcs.area.size(), faceOfArc, options);

  std::vector<std::optional<Interval<double>>> doubts(boxes.size());
  forEach(boxes.size(), options, [&](std::size_t leaf) {
    if (leaves.rowOf(static_cast<std::uint32_t>(leaf)) != CutLeaves::kNoRow) return;
    Certifier::Around around;
    if (certifier.mayBeCut(boxes[leaf], around)) doubts[leaf] = certifier.doubtAt(boxes[leaf]);
  });
  for (std::uint32_t leaf = 0; leaf < doubts.size(); ++leaf) {
    if (doubts[leaf]) result.doubtful.push_back({leaf, *doubts[leaf]});
  }
  return result;
}

}  // namespace cutwater
