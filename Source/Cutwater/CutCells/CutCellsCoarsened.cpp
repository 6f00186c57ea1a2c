#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/CutCells/Detail/Moments/MomentRows.hpp>
#include <Cutwater/CutCells/Detail/Moments/Moments.hpp>
#include <Cutwater/CutCells/Detail/Rows/CoarseNodes.hpp>
#include <Cutwater/CutCells/Detail/Rows/OpenRows.hpp>

#include <algorithm>
#include <map>
#include <tuple>

namespace cutwater {

namespace {

/// What arcs between the same two pieces add up to.
struct ArcSum {
  ArcSum(const Vec3<double>& reference, std::size_t monomials)
      : moments(reference), about(reference), all(monomials) {}

  Moments moments;
  Vec3<double> about;
  std::vector<double> all;  ///< the moments that were asked for, about this point
};

/// Joins nodes that meet within a coarse cell to its pieces, and adds up what they say.
class Coarsening {
 public:
  Coarsening(const CutCells& fine, const std::array<int, 3>& ratios, const SpannedAxes& spanned)
      : fine_(fine), ratios_(ratios), nodes_(fine, ratios, spanned) {
    out_.grid = nodes_.grid();
    out_.cells.index = nodes_.cells();
    out_.cellCount = out_.cells.index.size();
    out_.patchNames = fine.patchNames;
  }

  CutCells run() {
    addCorners();
    numberPieces();
    addMeetings();
    addErrors();
    addWallFaces();
    addPieces();
    if (fine_.moments.degree >= 0) addMoments();
    addWallParts();
    addArcs();
    addBodyRuns();
    return std::move(out_);
  }

 private:
  /// A corner is that of the fine cell there.
  void addCorners() {
    for (const auto& coarse : out_.cells.index) {
      const auto first = nodes_.firstOf(coarse);
      unsigned bits = 0;
      for (unsigned corner = 0; corner < 8; ++corner) {
        auto cell = first;
        if ((corner & 1U) != 0) cell.i += ratios_[0] - 1;
        if ((corner & 2U) != 0) cell.j += ratios_[1] - 1;
        if ((corner & 4U) != 0) cell.k += ratios_[2] - 1;
        const auto row = fine_.rowOf(cell);
        const bool isFluid = row == CutCells::kNoRow
                                 ? fine_.classOf(cell) == FluidClass::Fluid
                                 : (fine_.cells.fluidCorners[row] >> corner & 1U) != 0;
        bits |= (isFluid ? 1U : 0U) << corner;
      }
      out_.cells.fluidCorners.push_back(static_cast<std::uint8_t>(bits));
    }
  }
  /// By cell, and in each by the least node.
  void numberPieces() {
    detail::DisjointSets sets(nodes_.count());
    nodes_.forFaces([&](const CoarseNodes::Face& face) {
      if (!face.isBetween) sets.unite(face.below, face.above);
    });
    std::vector<std::uint32_t> roots;
    for (std::uint32_t node = 0; node < nodes_.count(); ++node) {
      if (sets.isRoot(node)) roots.push_back(node);
    }
    std::ranges::stable_sort(roots, {}, [&](std::uint32_t node) { return nodes_.rowOf(node); });
    out_.pieceCount = roots.size();
    std::vector<std::uint32_t> numbers(nodes_.count());
    auto& first = out_.cells.firstPiece;
    for (std::uint32_t piece = 0; piece < roots.size(); ++piece) {
      const auto row = nodes_.rowOf(roots[piece]);
      numbers[roots[piece]] = piece;
      out_.pieces.cell.push_back(row);
      if (first.size() <= row) first.resize(row + std::size_t{1}, piece);
    }
    first.resize(out_.cellCount + 1, static_cast<std::uint32_t>(roots.size()));
    for (std::uint32_t node = 0; node < nodes_.count(); ++node) {
      pieceOf_.push_back(numbers[sets.find(node)]);
    }
  }

  /// Those of fine cells whose planes are the coarse cell's.
  void addWallFaces() {
    out_.pieces.wallFaces.assign(out_.pieceCount, 0);
    out_.cells.wallFaces.assign(out_.cellCount, 0);
    for (std::uint32_t piece = 0; piece < fine_.pieceCount; ++piece) {
      const unsigned kept = fine_.pieces.wallFaces[piece] & nodes_.outerFaces(piece);
      out_.pieces.wallFaces[pieceOf_[piece]] |= static_cast<std::uint8_t>(kept);
      out_.cells.wallFaces[nodes_.rowOf(piece)] |= static_cast<std::uint8_t>(kept);
    }
  }

  void addMeetings() {
    out_.cells.meets.assign(out_.cellCount, 0);
    for (std::uint32_t piece = 0; piece < fine_.pieceCount; ++piece) {
      if (fine_.cells.meets[fine_.pieces.cell[piece]] == 0) continue;
      out_.cells.meets[nodes_.rowOf(piece)] = 1;
    }
  }

  /// Of the finer cells, which have larger shares of their own cells and faces.
  void addErrors() {
    if (fine_.cells.error.empty()) return;
    out_.cells.error.assign(out_.cellCount, 0);
    for (std::uint32_t piece = 0; piece < fine_.pieceCount; ++piece) {
      auto& error = out_.cells.error[nodes_.rowOf(piece)];
      error = std::max(error, fine_.cells.error[fine_.pieces.cell[piece]]);
    }
  }

  [[nodiscard]] Vec3<double> centerOf(std::uint32_t piece) const {
    return out_.boxOf(out_.cells.index[out_.pieces.cell[piece]]).center();
  }

  void addPieces() {
    std::vector<Moments> volumes;
    for (std::uint32_t piece = 0; piece < out_.pieceCount; ++piece) {
      volumes.emplace_back(centerOf(piece));
    }
    auto walls = volumes;
    auto& out = out_.pieces;
    out.wallVector.resize(out_.pieceCount);
    const auto& in = fine_.pieces;
    for (std::uint32_t node = 0; node < nodes_.count(); ++node) {
      const auto piece = pieceOf_[node];
      if (node >= fine_.pieceCount) {
        const auto cell = nodes_.cellOf(node);
        volumes[piece].add(fine_.cellVolume(cell), fine_.boxOf(cell).center());
        continue;
      }
      volumes[piece].add(in.volume[node], in.centroid[node]);
      walls[piece].add(in.wallArea[node], in.wallCentroid[node]);
      out.wallVector[piece] += in.wallVector[node];
    }
    for (std::uint32_t piece = 0; piece < out_.pieceCount; ++piece) {
      const auto& wall = walls[piece];
      out.volume.push_back(volumes[piece].size());
      out.centroid.push_back(volumes[piece].centroid());
      out.wallArea.push_back(wall.size());
      out.wallCentroid.push_back(wall.size() > 0 ? wall.centroid() : out.centroid.back());
    }
  }

  void addMoments() {
    out_.moments.degree = fine_.moments.degree;
    MomentRows rows(out_.pieces, out_.moments);
    for (std::uint32_t node = 0; node < nodes_.count(); ++node) {
      if (node < fine_.pieceCount) {
        rows.addPiece(pieceOf_[node], fine_.pieces, fine_.moments, node);
      } else {
        rows.addBox(pieceOf_[node], fine_.boxOf(nodes_.cellOf(node)));
      }
    }
  }

  void addWallParts() {
    const auto& in = fine_.wallParts;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::pair<Moments, Vec3<double>>> sums;
    for (std::size_t i = 0; i < in.piece.size(); ++i) {
      if (in.piece[i] >= fine_.pieceCount) break;  // beyond the box
      const auto piece = pieceOf_[in.piece[i]];
      auto& [area, vector] =
          sums.try_emplace({piece, in.patch[i]}, Moments(centerOf(piece)), Vec3<double>{})
              .first->second;
      area.add(in.area[i], in.centroid[i]);
      vector += in.vector[i];
    }
    for (const auto& [key, sum] : sums) {
      out_.wallParts.piece.push_back(key.first);
      out_.wallParts.patch.push_back(key.second);
      out_.wallParts.area.push_back(sum.first.size());
      out_.wallParts.vector.push_back(sum.second);
      out_.wallParts.centroid.push_back(sum.first.centroid());
    }
  }

  /// Those between the same two pieces are one, and those of an open patch.
  void addArcs() {
    const auto pieceAt = [&](std::uint32_t node) {
      return node < nodes_.count() ? pieceOf_[node] : node;
    };
    using Order = std::tuple<std::int32_t, std::int32_t, std::int32_t, int>;
    const auto count = fine_.moments.perArc();
    std::map<std::tuple<Order, std::uint32_t, std::uint32_t, std::uint32_t>, ArcSum> sums;
    nodes_.forFaces([&](const CoarseNodes::Face& face) {
      if (!face.isBetween) return;
      const auto& cell = face.cell;
      const std::tuple key(Order(cell.k, cell.j, cell.i, face.axis), pieceAt(face.below),
                           pieceAt(face.above), fine_.openArcs.patchOf(face.arc));
      auto& sum = sums.try_emplace(key, face.centroid, count).first->second;
      sum.moments.add(face.area, face.centroid);
      if (count == 0) return;
      const auto own = momentsOfFace(fine_, face.arc, fine_.boxOf(face.fine), face.axis, sum.about);
      for (std::size_t i = 0; i < count; ++i) sum.all[i] += own[i];
    });
    for (auto& [key, sum] : sums) {
      const auto& [order, below, above, patch] = key;
      const auto& [k, j, i, axis] = order;
      if (patch != CutCells::kNoRow) addOpenRow(out_.arcs.area.size(), patch, out_.openArcs);
      out_.arcs.cell.push_back({i, j, k});
      out_.arcs.axis.push_back(static_cast<std::uint8_t>(axis));
      out_.arcs.below.push_back(below);
      out_.arcs.above.push_back(above);
      out_.arcs.area.push_back(sum.moments.size());
      out_.arcs.centroid.push_back(sum.moments.centroid());
      shift(std::span(sum.all), fine_.moments.degree,
            alongFace(sum.about - out_.arcs.centroid.back(), axis));
      out_.moments.arc.insert(out_.moments.arc.end(), sum.all.begin(), sum.all.end());
    }
  }

  /// Coarse cells that are not cut are as any of their fine cells; the first ones ascend.
  void addBodyRuns() {
    const auto fine = fine_.grid.indices();
    const auto box = out_.grid.indices();
    const auto ratio = [&](std::size_t axis) { return static_cast<std::uint64_t>(ratios_[axis]); };
    auto run = fine_.bodyRuns.begin();
    std::uint64_t number = 0;
    for (std::uint64_t k = 0; k < box.length(2); ++k) {
      for (std::uint64_t j = 0; j < box.length(1); ++j) {
        auto first = (k * ratio(2) * fine.length(1) + j * ratio(1)) * fine.length(0);
        for (std::uint64_t i = 0; i < box.length(0); ++i, ++number, first += ratio(0)) {
          while (run != fine_.bodyRuns.end() && first >= (*run)[1]) ++run;
          if (run == fine_.bodyRuns.end()) return;
          if (first < (*run)[0]) continue;
          if (!out_.bodyRuns.empty() && out_.bodyRuns.back()[1] == number) {
            ++out_.bodyRuns.back()[1];
          } else {
            out_.bodyRuns.push_back({number, number + 1});
          }
        }
      }
    }
  }

  const CutCells& fine_;
  std::array<int, 3> ratios_;
  CoarseNodes nodes_;
  std::vector<std::uint32_t> pieceOf_;  // of each node
  CutCells out_;
};

}  // namespace

CutCells coarsened(const CutCells& cells, const std::array<int, 3>& ratios) {
  const auto spanned = spannedAxes(cells.grid);
  if (spanned == SpannedAxes{}) return Coarsening(cells, ratios, spanned).run();
  const auto joined = withJoinedEnds(cells, spanned);
  auto coarse = Coarsening(joined, ratios, spanned).run();
  separateEnds(coarse, spanned);
  return coarse;
}

}  // namespace cutwater
