#include <Cutwater/CutCells/Detail/Curved/CertainShares.hpp>
#include <Cutwater/CutCells/Detail/CutArguments.hpp>
#include <Cutwater/CutCells/Detail/Tiles/GridPlanes.hpp>
#include <Cutwater/Grid/Detail/GridTiles.hpp>

#include <algorithm>
#include <tuple>

namespace cutwater {

namespace {

using Doubtful = CertifiedCells::Doubtful;

class Certifier {
 public:
  Certifier(const FluidField& field, const CutCells& cells, const CertifyOptions& options)
      : field_(field), cells_(cells), options_(options) {}

  [[nodiscard]] Interval<double> shareOf(const Box<double>& box) const {
    return field_.shareOf(box, options_.width, options_.boxes);
  }
  [[nodiscard]] Box<double> faceOf(std::uint32_t arc) const {
    const int axis = cells_.arcs.axis[arc];
    auto box = cells_.boxOf(cells_.arcs.cell[arc]);
    box.upper[axis] = box.lower[axis];
    return box;
  }

  /// Appends the doubtful cells of a box of indices. It is halved while they may be.
  void findDoubtful(const IndexBox& box, const BoxHint& around,
                    std::vector<Doubtful>& found) const {
    const bool isCell = box.count() == 1;
    if (isCell && cells_.rowOf(box.lo) != CutCells::kNoRow) return;
    auto hint = around;
    if (!field_.mayBeCut({cells_.boxOf(box.lo).lower, cells_.boxOf(box.hi).upper}, hint)) return;
    if (isCell) return addIfDoubtful(box.lo, found);
    int longest = 0;
    for (const int axis : {1, 2}) {
      if (box.length(axis) > box.length(longest)) longest = axis;
    }
    auto low = box;
    auto high = box;
    along(low.hi, longest) =
        along(box.lo, longest) + static_cast<std::int32_t>(box.length(longest) / 2) - 1;
    along(high.lo, longest) = along(low.hi, longest) + 1;
    findDoubtful(low, hint, found);
    findDoubtful(high, hint, found);
  }

 private:
  void addIfDoubtful(const Index3& cell, std::vector<Doubtful>& found) const {
    constexpr std::size_t kBoxes = 1000;  // most cells beside the surface need some dozens
    constexpr double kWhole = 1e-12;      // rounding of a sum of volumes
    const auto box = cells_.boxOf(cell);
    auto share = field_.shareOf(box, 0, std::min(kBoxes, options_.boxes));
    const double width = share.upper - share.lower;
    if (width <= kWhole) return;
    if (width > options_.width) share = shareOf(box);
    found.push_back({cell, share});
  }

  const FluidField& field_;
  const CutCells& cells_;
  const CertifyOptions& options_;
};

void checkArguments(const FluidField& field, const CutCells& cells, const CertifyOptions& options) {
  require(options.width >= 0 && options.width <= 1, "cut cells: need a width from 0 to 1",
          Named{"width", options.width});
  require(options.boxes > 0, "cut cells: need boxes > 0", Named{"boxes", options.boxes});
  checkPlanes(cells.grid);
  for (const auto& planes : cells.grid.planes) {
    for (const double plane : planes) requireInPrecision(field, plane);
  }
}

}  // namespace

void requireInPrecision(const FluidField& field, double plane) {
  require(!field.facts().isSingle || double{static_cast<float>(plane)} == plane,
          "cut cells: need planes in the solid's precision", Named{"plane", plane});
}

CertifiedCells certifiedCells(const FluidField& field, const CutCells& cells,
                              const CertifyOptions& options) {
  constexpr detail::Offset kTile{16, 16, 16};
  checkArguments(field, cells, options);
  const Certifier certifier(field, cells, options);
  const ParallelOptions inParallel{.threads = options.threads, .grain = 16};
  CertifiedCells result;

  result.volumeFraction.resize(cells.cellCount);
  parallelFor(cells.cellCount, inParallel, [&](std::size_t begin, std::size_t end) {
    for (auto row = begin; row < end; ++row) {
      result.volumeFraction[row] = certifier.shareOf(cells.boxOf(cells.cells.index[row]));
    }
  });

  const auto& arcs = cells.arcs;
  result.aperture.resize(arcs.area.size());
  const auto isOfFaceBefore = [&](std::size_t arc) {
    return arc > 0 && arcs.cell[arc] == arcs.cell[arc - 1] && arcs.axis[arc] == arcs.axis[arc - 1];
  };
  parallelFor(arcs.area.size(), inParallel, [&](std::size_t begin, std::size_t end) {
    for (auto arc = begin; arc < end; ++arc) {
      if (isOfFaceBefore(arc)) continue;
      result.aperture[arc] = certifier.shareOf(certifier.faceOf(static_cast<std::uint32_t>(arc)));
    }
  });
  for (std::size_t arc = 1; arc < arcs.area.size(); ++arc) {
    if (isOfFaceBefore(arc)) result.aperture[arc] = result.aperture[arc - 1];
  }

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
                  certifier.findDoubtful(tile, {}, found[n]);
                }
              });
  for (const auto& some : found) {
    result.doubtful.insert(result.doubtful.end(), some.begin(), some.end());
  }
  std::ranges::sort(result.doubtful, {}, [](const Doubtful& doubt) {
    return std::tuple(doubt.cell.k, doubt.cell.j, doubt.cell.i);
  });
  return result;
}

}  // namespace cutwater
