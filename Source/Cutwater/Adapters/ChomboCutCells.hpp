#pragma once

// For code that includes Chombo 3.2, in 3D or 2D and either precision.

#include <Cutwater/Adapters/BoxGrids.hpp>
#include <Cutwater/Adapters/SingleValuedCells.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CutCells.hpp>

#include <GeometryService.H>
#include <IrregNode.H>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace cutwater {

/// Options of ChomboCutCells.
struct ChomboOptions {
  double z = 0;  ///< in 2D: of the plane that is cut
  /// In 3D, whether nodes have moments, up to CH_EBIS_ORDER (of 4 at most), as Chombo's operators
  /// of higher order want them. Cutting takes up to twice as long with those of order 2.
  bool moments = false;
  /// See ParallelOptions.
  int threads = 0;
};

/// The cells of a CellCutter or a SolidCutter as Chombo's geometry service, for
/// EBIndexSpace::define(): each connected piece of fluid in a cell is a volume of fluid of its own,
/// with the faces that lead from it.
///
///     const ChomboCutCells cut(CellCutter(hull), domain, origin, dx);
///     Chombo_EBIS::instance()->define(domain, origin, dx, cut);
///
/// It has volume and area fractions and centroids, and moments on request: integrals of monomials
/// of offsets from the middle of the cell, or of the face. Of the normal's derivatives it has none
/// but the normal itself, the mean over the wall, so that getEBNormalMoments() is exact for the
/// area vector and of the first order in dx beyond. All of the domain is cut when it is made. Its
/// functions may be called from within a parallel region.
class ChomboCutCells final : public GeometryService {
 public:
  /// @param cutter  with the domain's period along axes in which it is periodic, and none along
  /// others.
  /// @param domain  of the finest level.
  /// @param origin  the lower corner of cell 0.
  /// @param dx  the width of cells.
  /// @param options  see there.
  /// @throws Error(Argument) for another period, for any in 2D, and as cutting does.
  template <typename Cutter>
  ChomboCutCells(const Cutter& cutter, const ProblemDomain& domain, const RealVect& origin, Real dx,
                 const ChomboOptions& options = {})
      : domain_(domain),
        dx_(dx),
        cells_(cellsOf(cutter, hostDomain(domain, origin, dx, options.z),
                       {.moments = options.moments ? kOrder : -1, .threads = options.threads})),
        arcs_(cells_.pieceCount) {
    for (std::uint32_t arc = 0; arc < cells_.arcs.area.size(); ++arc) {
      for (const auto piece : {cells_.arcs.below[arc], cells_.arcs.above[arc]}) {
        if (piece < cells_.pieceCount) arcs_[piece].push_back(arc);
      }
    }
    for (const bool isMarked : {false, true}) {
      for (std::uint32_t arc = 0; arc < cells_.arcs.area.size(); ++arc) noteWhole(arc, isMarked);
    }
  }

  bool isRegular(const ::Box& region, const ProblemDomain& domain, const RealVect& origin,
                 const Real& dx) const override {
    return InsideOutside(region, domain, origin, dx) == Regular;
  }
  bool isCovered(const ::Box& region, const ProblemDomain& domain, const RealVect& origin,
                 const Real& dx) const override {
    return InsideOutside(region, domain, origin, dx) == Covered;
  }
  using GeometryService::InsideOutside;
  /// Irregular unless all cells are fluid, or all are body.
  /// @throws Error(Argument) for another domain or width than those that were cut.
  InOut InsideOutside(const ::Box& region, const ProblemDomain& domain, const RealVect& /*origin*/,
                      const Real& dx) const override {
    requireOwn(domain, dx);
    const auto box = indicesOf(region);
    if (cells_.grid.indices().contains(box.lo) && cells_.grid.indices().contains(box.hi)) {
      return inOut(classOf(cells_, box));
    }
    const auto first = cells_.classOf(inDomain(box.lo));
    bool isAlike = true;
    forEachIndex(box, [&](const Index3& cell) {
      isAlike = isAlike && cells_.classOf(inDomain(cell)) == first;
    });
    return isAlike ? inOut(first) : Irregular;
  }
  bool canGenerateMultiCells() const override { return true; }
  bool generatesHigherOrderMoments() const override { return cells_.moments.degree >= 0; }

  /// @throws Error(Argument) as InsideOutside().
  // NOLINTNEXTLINE(readability-function-size): its parameters are Chombo's
  void fillGraph(BaseFab<int>& kinds, Vector<IrregNode>& nodes, const ::Box& valid,
                 const ::Box& ghost, const ProblemDomain& domain, const RealVect& /*origin*/,
                 const Real& dx, const DataIndex& /*index*/) const override {
    requireOwn(domain, dx);
    forEachIndex(indicesOf(ghost), [&](const Index3& cell) {
      const auto own = inDomain(cell);
      const auto kind = whole_.contains(keyOf(own)) ? Irregular : inOut(cells_.classOf(own));
      kinds(vectOf(cell), 0) = kind == Regular ? 1 : kind == Covered ? -1 : 0;
    });
    forEachIndex(indicesOf(valid), [&](const Index3& cell) {
      const auto own = inDomain(cell);
      const auto found = whole_.find(keyOf(own));
      if (found != whole_.end()) nodes.push_back(wholeNodeOf(cell, own, found->second));
      const auto row = cells_.rowOf(own);
      if (row == CutCells::kNoRow) return;
      for (auto piece = cells_.cells.firstPiece[row]; piece < cells_.cells.firstPiece[row + 1];
           ++piece) {
        nodes.push_back(nodeOf(cell, row, piece));
      }
    });
  }

 private:
  static constexpr int kOrder = CH_SPACEDIM == 3 ? CH_EBIS_ORDER : -1;  // planes have no moments

  static IntVect vectOf(const Index3& index) {
    IntVect result;
    const auto at = keyOf(index);
    for (int axis = 0; axis < CH_SPACEDIM; ++axis)
      result[axis] = at[static_cast<std::size_t>(axis)];
    return result;
  }
  static IndexBox indicesOf(const ::Box& box) {
    const auto& lo = box.smallEnd();
    const auto& hi = box.bigEnd();
    if constexpr (CH_SPACEDIM == 3) return {{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}};
    return {{lo[0], lo[1], 0}, {hi[0], hi[1], 0}};
  }
  static InOut inOut(FluidClass kind) {
    return kind == FluidClass::Fluid ? Regular : kind == FluidClass::Body ? Covered : Irregular;
  }

  static HostDomain hostDomain(const ProblemDomain& domain, const RealVect& origin, Real dx,
                               double z) {
    const auto width = static_cast<double>(dx);
    HostDomain result{.cells = indicesOf(domain.domainBox()),
                      .origin = {},
                      .width = {width, width, width},
                      .isPlane = CH_SPACEDIM == 2,
                      .z = z};
    for (int axis = 0; axis < CH_SPACEDIM; ++axis) {
      result.origin[axis] = static_cast<double>(origin[axis]);
      result.isPeriodic[static_cast<std::size_t>(axis)] = domain.isPeriodic(axis);
    }
    return result;
  }

  void requireOwn(const ProblemDomain& domain, Real dx) const {
    require(domain == domain_ && dx == dx_, "ChomboCutCells: need the domain that was cut",
            Named{"dx", dx});
  }
  /// The cell of the domain for one that is whole periods away.
  [[nodiscard]] Index3 inDomain(Index3 cell) const {
    const auto box = cells_.grid.indices();
    const std::array at{&cell.i, &cell.j, &cell.k};
    for (int axis = 0; axis < CH_SPACEDIM; ++axis) {
      const auto count = static_cast<int>(box.length(axis));
      if (!domain_.isPeriodic(axis) || count == 0) continue;
      auto& own = *at[static_cast<std::size_t>(axis)];
      const auto lowest = keyOf(box.lo)[static_cast<std::size_t>(axis)];
      own = lowest + ((own - lowest) % count + count) % count;
    }
    return cell;
  }
  /// The offset from the middle of a cell or a face, in widths.
  [[nodiscard]] RealVect offset(const Vec3<double>& from, const Vec3<double>& to) const {
    RealVect result;
    for (int axis = 0; axis < CH_SPACEDIM; ++axis) {
      const double share = (to[axis] - from[axis]) / static_cast<double>(dx_);
      result[axis] = static_cast<Real>(std::clamp(share, -0.5, 0.5));
    }
    return result;
  }

  using Key = std::array<int, 3>;

  static Key keyOf(const Index3& cell) { return {cell.i, cell.j, cell.k}; }
  /// Chombo wants cells that are all fluid to be irregular beside one of several pieces. It would
  /// make them so itself, but its faces between them are closed then (FaceData::setToRegular()).
  /// Notes those of an arc, and once all are known, the arc.
  void noteWhole(std::uint32_t arc, bool isMarked) {
    for (const bool isHigh : {false, true}) {
      const auto side = isHigh ? cells_.arcs.above[arc] : cells_.arcs.below[arc];
      const auto other = isHigh ? cells_.arcs.below[arc] : cells_.arcs.above[arc];
      const auto cell = inDomain(isHigh ? cells_.arcs.cell[arc] : cells_.arcs.cellBelow(arc));
      if (side != CutCells::kWholeCell || cells_.arcs.axis[arc] >= CH_SPACEDIM) continue;
      if (!cells_.grid.indices().contains(cell)) continue;
      if (isMarked) {
        const auto found = whole_.find(keyOf(cell));
        if (found != whole_.end()) found->second.push_back({arc, isHigh});
      } else if (other < cells_.pieces.cell.size()) {
        const auto row = cells_.pieces.cell[other];
        if (cells_.cells.firstPiece[row + 1] > cells_.cells.firstPiece[row] + 1) {
          whole_[keyOf(cell)];
        }
      }
    }
  }
  /// An arc of a cell that is all fluid.
  struct WholeArc {
    std::uint32_t arc = 0;
    bool isAbove = false;  ///< whether the cell is above it
  };
  [[nodiscard]] IrregNode wholeNodeOf(const Index3& cell, const Index3& own,
                                      const std::vector<WholeArc>& arcs) const {
    const auto box = cells_.boxOf(own);
    IrregNode node;
    node.m_cell = vectOf(cell);
    node.m_cellIndex = 0;
    node.m_volFrac = 1;
    node.m_volCentroid = RealVect();
    node.m_bndryCentroid = RealVect();
    node.setMomentsToZero();
    node.m_volumeMoments.setRegular(dx_);
    for (const auto& [arc, isAbove] : arcs) addArc(box, arc, !isAbove, node);
    for (int axis = 0; axis < CH_SPACEDIM; ++axis) {
      for (const bool isHigh : {false, true}) {
        const auto side = IrregNode::index(axis, isHigh ? Side::Hi : Side::Lo);
        if (node.m_arc[side].size() > 0) continue;
        auto across = own;
        const int step = isHigh ? 1 : -1;
        (axis == 0 ? across.i : axis == 1 ? across.j : across.k) += step;
        node.m_arc[side].push_back(targetOf(CutCells::kWholeCell, across));
        node.m_areaFrac[side].push_back(1);
        node.m_faceCentroid[side].push_back(RealVect());
        node.m_faceMoments[side].setRegular(dx_);
      }
    }
    return node;
  }
  [[nodiscard]] IrregNode nodeOf(const Index3& cell, std::uint32_t row, std::uint32_t piece) const {
    const auto box = cells_.boxOf(cells_.cells.index[row]);
    IrregNode node;
    node.m_cell = vectOf(cell);
    node.m_cellIndex = static_cast<int>(piece - cells_.cells.firstPiece[row]);
    node.m_volFrac = static_cast<Real>(cells_.volumeFraction(piece));
    node.m_volCentroid = offset(box.center(), cells_.pieces.centroid[piece]);
    const bool hasWall = cells_.pieces.wallArea[piece] > 0;
    node.m_bndryCentroid =
        offset(box.center(), hasWall ? cells_.pieces.wallCentroid[piece] : box.center());
    node.setMomentsToZero();
    if (generatesHigherOrderMoments()) setMoments(box.center(), piece, node);
    for (const auto arc : arcs_[piece]) addArc(box, arc, cells_.arcs.below[arc] == piece, node);
    for (auto side = 0; side < 2 * CH_SPACEDIM; ++side) {
      const auto count = node.m_arc[side].size();  // Chombo has one for all faces of a side
      if (count > 1) node.m_faceMoments[side] *= 1 / static_cast<Real>(count);
    }
    return node;
  }
  void setMoments(const Vec3<double>& middle, std::uint32_t piece, IrregNode& node) const {
    const auto& pieces = cells_.pieces;
    const auto& moments = cells_.moments;
    addMoments(shifted(moments.ofVolume(piece), pieces.centroid[piece], middle),
               node.m_volumeMoments);
    if (!(pieces.wallArea[piece] > 0)) return;
    addMoments(shifted(moments.ofWall(piece), pieces.wallCentroid[piece], middle),
               node.m_EBMoments);
    const auto normal = pieces.wallVector[piece] / -pieces.wallArea[piece];  // into the fluid
    for (int axis = 0; axis < CH_SPACEDIM; ++axis) {
      node.m_normalPartialDeriv[axis][0] = static_cast<Real>(normal[axis]);  // the one of order 0
    }
  }
  /// Adds a row of CutCells::Moments to those of a volume or a wall, or of a face.
  template <typename Moments>
  static void addMoments(const std::vector<double>& row, Moments& out) {
    const auto& powers = Moments::getMonomialPowers();  // a Vector of Chombo's, without begin()
    for (std::size_t n = 0; n < powers.size(); ++n) {
      const auto& power = powers[n];
      std::size_t place = 0;
      const auto of = [&](int axis) { return static_cast<std::size_t>(power[axis]); };
      if constexpr (std::is_same_v<Moments, decltype(IrregNode::m_volumeMoments)>) {
        place = CutCells::Moments::indexOf(of(0), of(1), of(2));
      } else {
        place = CutCells::Moments::indexOf(of(0), of(1));
      }
      out[power] += static_cast<Real>(row[place]);
    }
  }
  /// Adds it to those between the same two pieces, which are one face to Chombo.
  void addArc(const Box<double>& box, std::uint32_t arc, bool isHigh, IrregNode& node) const {
    const int axis = cells_.arcs.axis[arc];
    if (axis >= CH_SPACEDIM) return;
    const auto side =
        static_cast<std::size_t>(IrregNode::index(axis, isHigh ? Side::Hi : Side::Lo));
    auto middle = box.center();
    middle[axis] = cells_.arcs.centroid[arc][axis];
    const int target = isHigh ? targetOf(cells_.arcs.above[arc], cells_.arcs.cell[arc])
                              : targetOf(cells_.arcs.below[arc], cells_.arcs.cellBelow(arc));
    auto& targets = node.m_arc[side];
    std::size_t n = 0;
    while (n < targets.size() && targets[n] != target) ++n;
    if (n == targets.size()) {
      targets.push_back(target);
      node.m_areaFrac[side].push_back(0);
      node.m_faceCentroid[side].push_back(RealVect());
    }
    const auto area = static_cast<Real>(cells_.aperture(arc));
    const auto centroid = offset(middle, cells_.arcs.centroid[arc]);
    auto& all = node.m_areaFrac[side][n];
    all = std::min(all + area, Real(1));
    for (int dir = 0; dir < CH_SPACEDIM; ++dir) {
      auto& mean = node.m_faceCentroid[side][n][dir];
      mean += area / all * (centroid[dir] - mean);
    }
    if (!generatesHigherOrderMoments()) return;
    addMoments(shifted(cells_.moments.ofArc(arc), axis, cells_.arcs.centroid[arc], middle),
               node.m_faceMoments[side]);
  }
  /// The number of a piece in its cell, which is across a face: -2 for a cell that is all fluid and
  /// regular, -1 beyond the domain.
  [[nodiscard]] int targetOf(std::uint32_t piece, const Index3& across) const {
    const auto cell = inDomain(across);
    if (!cells_.grid.indices().contains(cell) || piece == CutCells::kBeyond) return -1;
    if (piece == CutCells::kWholeCell) return whole_.contains(keyOf(cell)) ? 0 : -2;
    return static_cast<int>(piece - cells_.cells.firstPiece[cells_.pieces.cell[piece]]);
  }

  ProblemDomain domain_;
  Real dx_;
  CutCells cells_;
  std::vector<std::vector<std::uint32_t>> arcs_;  // of each piece
  std::map<Key, std::vector<WholeArc>> whole_;    // cells that are all fluid, but irregular
};

}  // namespace cutwater
