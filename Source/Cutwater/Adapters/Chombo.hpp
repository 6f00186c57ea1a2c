#pragma once

// For code that includes Chombo 3.2, in 3D or 2D and either precision.

#include <Cutwater/Adapters/BoxGrids.hpp>
#include <Cutwater/Adapters/FluidDomain.hpp>
#include <Cutwater/Adapters/SingleValuedCells.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/CutCells.hpp>

#include <BaseIF.H>
#include <GeometryService.H>
#include <IrregNode.H>
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace cutwater {

/// A FluidDomain as Chombo's implicit function, negative in the fluid. In 2D it is evaluated in the
/// plane at z. Boxes are classified with certainty, which Chombo requests through
/// fastIntersection() and InsideOutside().
///
///     const ChomboIF function({hull, FluidSide::Outside, {0.1, 0.1, 0.1}});
///     GeometryShop shop(function, 0, dx * RealVect::Unit);
class ChomboIF final : public BaseIF {
 public:
  explicit ChomboIF(FluidDomain<Real> domain, Real z = 0) : domain_(std::move(domain)), z_(z) {}

  // Overloads that follow from those below.
  using BaseIF::fastIntersection;
  using BaseIF::InsideOutside;
  using BaseIF::value;

  Real value(const RealVect& point) const override { return domain_.levelSet(pointOf(point)); }

#ifndef USE_STCVECTOR  // otherwise it is the type above
  Real value(const IndexTM<Real, GLOBALDIM>& point) const override {
    return domain_.levelSet(pointOf(point));
  }
#endif

  /// The value, or a first derivative. Higher orders are left to Chombo, which ends the program: a
  /// signed distance need not have such derivatives.
  Real value(const IndexTM<int, GLOBALDIM>& derivative,
             const IndexTM<Real, GLOBALDIM>& point) const override {
    int order = 0;
    int axis = 0;
    for (int i = 0; i < GLOBALDIM; ++i) {
      order += derivative[i];
      if (derivative[i] > 0) axis = i;
    }
    if (order == 0) return domain_.levelSet(pointOf(point));
    if (order == 1) return domain_.gradient(pointOf(point))[axis];
    return BaseIF::value(derivative, point);
  }

  bool fastIntersection(const RealVect& /*low*/, const RealVect& /*high*/) const override {
    return true;
  }

  /// Returns Regular and Covered only if no surface touches the closed box.
  GeometryService::InOut InsideOutside(const RealVect& low, const RealVect& high) const override {
    switch (domain_.classify(Box<Real>{pointOf(low), pointOf(high)})) {
      case FluidClass::Fluid:
        return GeometryService::Regular;
      case FluidClass::Body:
        return GeometryService::Covered;
      default:
        return GeometryService::Irregular;
    }
  }

  /// A copy, which shares the solid. The caller deletes it.
  BaseIF* newImplicitFunction() const override {
    return new ChomboIF(*this);
  }

 private:
  template <typename Point>
  [[nodiscard]] Vec3<Real> pointOf(const Point& p) const {
    if constexpr (CH_SPACEDIM == 3) return {p[0], p[1], p[2]};
    return {p[0], p[1], z_};
  }

  FluidDomain<Real> domain_;
  Real z_;  // of the plane, in 2D
};

/// Options of ChomboCutCells.
struct ChomboOptions {
  double z = 0;  ///< in 2D: of the plane that is cut
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
/// It has volume and area fractions and centroids; of higher moments it has none, so
/// generatesHigherOrderMoments() is false. All of the domain is cut when it is made. Its functions
/// may be called from within a parallel region.
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
                       {.threads = options.threads})),
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
    forCells(box, [&](const Index3& cell) {
      isAlike = isAlike && cells_.classOf(inDomain(cell)) == first;
    });
    return isAlike ? inOut(first) : Irregular;
  }
  bool canGenerateMultiCells() const override { return true; }
  bool generatesHigherOrderMoments() const override { return false; }

  /// @throws Error(Argument) as InsideOutside().
  // NOLINTNEXTLINE(readability-function-size): its parameters are Chombo's
  void fillGraph(BaseFab<int>& kinds, Vector<IrregNode>& nodes, const ::Box& valid,
                 const ::Box& ghost, const ProblemDomain& domain, const RealVect& /*origin*/,
                 const Real& dx, const DataIndex& /*index*/) const override {
    requireOwn(domain, dx);
    forCells(indicesOf(ghost), [&](const Index3& cell) {
      const auto own = inDomain(cell);
      const auto kind = whole_.contains(keyOf(own)) ? Irregular : inOut(cells_.classOf(own));
      kinds(vectOf(cell), 0) = kind == Regular ? 1 : kind == Covered ? -1 : 0;
    });
    forCells(indicesOf(valid), [&](const Index3& cell) {
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
  static IntVect vectOf(const Index3& index) {
    IntVect result;
    const std::array<int, 3> at{index.i, index.j, index.k};
    for (int axis = 0; axis < CH_SPACEDIM; ++axis) {
      result[axis] = at[static_cast<std::size_t>(axis)];
    }
    return result;
  }
  static IndexBox indicesOf(const ::Box& box) {
    const auto& lo = box.smallEnd();
    const auto& hi = box.bigEnd();
    if constexpr (CH_SPACEDIM == 3) return {{lo[0], lo[1], lo[2]}, {hi[0], hi[1], hi[2]}};
    return {{lo[0], lo[1], 0}, {hi[0], hi[1], 0}};
  }
  template <typename Visit>
  static void forCells(const IndexBox& box, const Visit& visit) {
    for (int k = box.lo.k; k <= box.hi.k; ++k) {
      for (int j = box.lo.j; j <= box.hi.j; ++j) {
        for (int i = box.lo.i; i <= box.hi.i; ++i) visit(Index3{i, j, k});
      }
    }
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
    const auto wrap = [&](std::int32_t& at, std::int32_t lowest, std::int32_t highest, int axis) {
      if (axis >= CH_SPACEDIM || !domain_.isPeriodic(axis)) return;
      const auto count = highest - lowest + 1;
      at = lowest + ((at - lowest) % count + count) % count;
    };
    wrap(cell.i, box.lo.i, box.hi.i, 0);
    wrap(cell.j, box.lo.j, box.hi.j, 1);
    wrap(cell.k, box.lo.k, box.hi.k, 2);
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
    for (const auto arc : arcs_[piece]) addArc(box, arc, cells_.arcs.below[arc] == piece, node);
    return node;
  }
  void addArc(const Box<double>& box, std::uint32_t arc, bool isHigh, IrregNode& node) const {
    const int axis = cells_.arcs.axis[arc];
    if (axis >= CH_SPACEDIM) return;
    const auto side = IrregNode::index(axis, isHigh ? Side::Hi : Side::Lo);
    auto middle = box.center();
    middle[axis] = cells_.arcs.centroid[arc][axis];
    node.m_arc[side].push_back(isHigh
                                   ? targetOf(cells_.arcs.above[arc], cells_.arcs.cell[arc])
                                   : targetOf(cells_.arcs.below[arc], cells_.arcs.cellBelow(arc)));
    node.m_areaFrac[side].push_back(static_cast<Real>(cells_.aperture(arc)));
    node.m_faceCentroid[side].push_back(offset(middle, cells_.arcs.centroid[arc]));
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
