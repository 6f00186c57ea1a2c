#pragma once

// For code that includes AMReX: EB2 as of October 2024, in 3D or 2D and either precision.

#include <Cutwater/Adapters/Amrex.hpp>
#include <Cutwater/Adapters/BoxGrids.hpp>
#include <Cutwater/Adapters/SingleValuedCells.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/CutCells/CutCells.hpp>

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <AMReX_EB2.H>
#include <AMReX_MultiFab.H>
#include <AMReX_iMultiFab.H>

namespace cutwater {

/// Options of buildEB().
struct AmrexOptions {
  /// How many coarse levels there are at most, each of half as many cells. The last one is that
  /// which has an odd number of cells, or beyond which no fluid would be left.
  int coarseLevels = 30;
  /// Cells with a smaller share of fluid are covered, as eb2.small_volfrac says elsewhere.
  double smallest = std::is_same_v<amrex::Real, float> ? 1e-5 : 1e-14;
  /// How many cells beyond the domain each level knows, where the geometry is not periodic.
  int beyond = 16;
  /// Cells are held in boxes of up to as many cells along each axis, where any is cut.
  int boxes = 16;
  double z = 0;  ///< in 2D: of the plane that is cut
  /// See ParallelOptions.
  int threads = 0;
};

/// A level of AMReX's that holds the fields of SingleValuedCells.
class AmrexLevel final : public amrex::EB2::Level {
 public:
  AmrexLevel(const amrex::EB2::IndexSpace* space, const amrex::Geometry& geometry,
             SingleValuedCells cells, const AmrexOptions& options)
      : amrex::EB2::Level(space, geometry), cells_(std::move(cells)) {
    m_ngrow = amrex::IntVect(0);
    for (int axis = 0; axis < AMREX_SPACEDIM; ++axis) {
      if (geometry.isPeriodic(axis)) continue;
      m_ngrow[axis] = std::min(options.beyond, geometry.Domain().length(axis));
    }
    defineGrids(options.boxes);
    m_ok = true;
    m_allregular = m_grids.empty();
    if (m_allregular) return;
    defineFields();
    const auto& own = m_volfrac.IndexArray();
    parallelFor(own.size(), {.threads = options.threads}, [&](std::size_t begin, std::size_t end) {
      for (auto n = begin; n < end; ++n) fill(own[n]);
    });
    buildCellFlag();
  }

  /// What the fields were made of.
  [[nodiscard]] const SingleValuedCells& cells() const { return cells_; }

 private:
  static constexpr int kGhosts = 2;

  void defineGrids(int largest) {
    const auto& domain = m_geom.Domain();
    amrex::BoxList boxes(domain);
    boxes.maxSize(largest);
    amrex::BoxList cut;
    amrex::BoxList covered;
    for (auto box : boxes) {
      const auto kind = cells_.classify(detail::amrexIndices(box));
      if (kind == FluidClass::Fluid) continue;
      for (int axis = 0; axis < AMREX_SPACEDIM; ++axis) {
        const auto atLow = box.smallEnd(axis) == domain.smallEnd(axis);
        const auto atHigh = box.bigEnd(axis) == domain.bigEnd(axis);
        if (atLow) box.growLo(axis, m_ngrow[axis]);
        if (atHigh) box.growHi(axis, m_ngrow[axis]);
      }
      (kind == FluidClass::Body ? covered : cut).push_back(box);
    }
    if (!cut.isEmpty()) m_grids = amrex::BoxArray(std::move(cut));
    if (!covered.isEmpty()) m_covered_grids = amrex::BoxArray(std::move(covered));
  }

  void defineFields() {
    m_dmap = amrex::DistributionMapping(m_grids);
    const auto define = [&](auto& field, const amrex::IntVect& nodal, int components) {
      field.define(amrex::convert(m_grids, nodal), m_dmap, components, kGhosts);
    };
    const amrex::IntVect cell(0);
    define(m_cellflag, cell, 1);
    define(m_volfrac, cell, 1);
    define(m_centroid, cell, AMREX_SPACEDIM);
    define(m_bndryarea, cell, 1);
    define(m_bndrycent, cell, AMREX_SPACEDIM);
    define(m_bndrynorm, cell, AMREX_SPACEDIM);
    for (int axis = 0; axis < AMREX_SPACEDIM; ++axis) {
      amrex::IntVect face(0);
      face[axis] = 1;
      amrex::IntVect edge(1);
      edge[axis] = 0;
      define(m_areafrac[axis], face, 1);
      define(m_facecent[axis], face, AMREX_SPACEDIM - 1);
      define(m_edgecent[axis], edge, 1);
    }
    define(m_levelset, amrex::IntVect(1), 1);
  }

  /// A component of a field as a view.
  static GridView<amrex::Real> viewOf(amrex::MultiFab& field, int grid, int component = 0) {
    const auto array = field.array(grid);
    const auto lo = amrex::lbound(array);
    return GridView<amrex::Real>::contiguous(&array(lo.x, lo.y, lo.z, component),
                                             detail::amrexIndices(array));
  }
  static std::array<GridView<amrex::Real>, 3> viewsOf(amrex::MultiFab& field, int grid) {
    std::array<GridView<amrex::Real>, 3> views;
    for (int n = 0; n < field.nComp(); ++n) {
      views[static_cast<std::size_t>(n)] = viewOf(field, grid, n);
    }
    return views;
  }

  void fill(int grid) {
    const auto flags = m_cellflag.array(grid);
    const auto box = detail::amrexIndices(flags);
    std::vector<FluidClass> kinds(box.count());
    SingleValuedFields<amrex::Real> fields{
        .kind = GridView<FluidClass>::contiguous(kinds.data(), box),
        .volumeFraction = viewOf(m_volfrac, grid),
        .centroid = viewsOf(m_centroid, grid),
        .wallArea = viewOf(m_bndryarea, grid),
        .wallCentroid = viewsOf(m_bndrycent, grid),
        .wallNormal = viewsOf(m_bndrynorm, grid),
        .aperture = {},
        .faceCentroid = {},
        .edgeCentroid = {},
        .levelSet = viewOf(m_levelset, grid)};
    for (int axis = 0; axis < AMREX_SPACEDIM; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      fields.aperture[a] = viewOf(m_areafrac[axis], grid);
      const auto centroid = viewsOf(m_facecent[axis], grid);
      fields.faceCentroid[a] = {centroid[0], centroid[1]};
      fields.edgeCentroid[a] = viewOf(m_edgecent[axis], grid);
    }
    cells_.fill(box, fields);
    auto kind = kinds.begin();
    forEachIndex(box, [&](const Index3& at) { setFlag(flags(at.i, at.j, at.k), *kind++); });
  }
  /// buildCellFlag() then finds what is connected.
  static void setFlag(amrex::EBCellFlag& flag, FluidClass kind) {
    flag = kind == FluidClass::Body ? amrex::EBCellFlag::TheCoveredCell()
                                    : amrex::EBCellFlag::TheDefaultCell();
    if (kind == FluidClass::Cut) flag.setSingleValued();
  }

  SingleValuedCells cells_;
};

/// A level that is all regular, coarser than those that are known.
class AmrexRegularLevel final : public amrex::EB2::Level {
 public:
  AmrexRegularLevel(const amrex::EB2::IndexSpace* space, const amrex::Geometry& geometry,
                    const amrex::EB2::Level& finer)
      : amrex::EB2::Level(space, geometry) {
    m_allregular = true;
    m_ok = true;
    m_has_eb_info = false;
    buildCutCellMask(finer);
  }
};

/// AMReX's index space of cut cells: every level has the fields that its solvers use.
class AmrexIndexSpace final : public amrex::EB2::IndexSpace {
 public:
  /// Cuts the cells of a geometry's domain, with polygons.
  using Cut = std::function<CutCells(const amrex::Geometry&)>;

  AmrexIndexSpace(Cut cut, const amrex::Geometry& finest, const AmrexOptions& options)
      : cut_(std::move(cut)), options_(options) {
    levels_ = levelsFrom(finest, options.coarseLevels);
  }

  /// @throws Error(Argument) for a domain of which there is no level.
  const amrex::EB2::Level& getLevel(const amrex::Geometry& geometry) const override {
    return levelOf(geometry.Domain());
  }
  /// @throws Error(Argument) as getLevel().
  const amrex::Geometry& getGeometry(const amrex::Box& domain) const override {
    return levelOf(domain).Geom();
  }
  const amrex::Box& coarsestDomain() const override { return levels_.back()->Geom().Domain(); }
  /// Levels finer than the finest, which are cut: those that are there stay as they are.
  void addFineLevels(int count) override {
    if (count <= 0) return;
    auto finer = levelsFrom(amrex::refine(levels_.front()->Geom(), 1 << count), count - 1);
    levels_.insert(levels_.begin(), std::make_move_iterator(finer.begin()),
                   std::make_move_iterator(finer.end()));
  }
  /// Levels coarser than the finest that are all regular, in place of those that are cut, for
  /// meshes whose coarse levels must not know of the body.
  void addRegularCoarseLevels(int count) override {
    for (int level = 0; level < count; ++level) {
      const amrex::EB2::Level* finer = levels_.front().get();
      if (!regular_.empty()) finer = regular_.back().get();
      regular_.push_back(
          std::make_unique<AmrexRegularLevel>(this, amrex::coarsen(finer->Geom(), 2), *finer));
    }
  }

  /// The cells of a level, with what was covered: SingleValuedCells::lost().
  /// @throws Error(Argument) as getLevel(), and for a level that is all regular.
  [[nodiscard]] const SingleValuedCells& cells(const amrex::Geometry& geometry) const {
    require(find(regular_, geometry.Domain()) == nullptr,
            "AmrexIndexSpace: a level that is all regular has no cells");
    const auto* level = find(levels_, geometry.Domain());
    require(level != nullptr, "AmrexIndexSpace: no level has this domain");
    return level->cells();
  }
  /// How many levels coarser than this one AMReX's multigrid may use, for
  /// LPInfo::setMaxCoarseningLevel(). Where covering closes faces on a coarse level alone, as
  /// beside plates thinner than its cells, AMReX has no Dirichlet condition for them, and its
  /// cycles may grow: the last of these levels is before the first on which those are more than a
  /// tenth of the cells with a wall. @throws Error(Argument) as cells().
  [[nodiscard]] int multigridLevels(const amrex::Geometry& geometry) const {
    constexpr double kMost = 0.1;
    static_cast<void>(cells(geometry));  // for its errors
    int count = 0;
    bool isCoarser = false;
    for (const auto& level : levels_) {
      if (isCoarser && level->cells().newWallShare() > kMost) break;
      count += isCoarser ? 1 : 0;
      isCoarser = isCoarser || level->Geom().Domain() == geometry.Domain();
    }
    return count;
  }
  /// The patches of walls on this level. The last one is what was covered.
  [[nodiscard]] const std::vector<std::string>& patchNames(const amrex::Geometry& geometry) const {
    return cells(geometry).cells().patchNames;
  }

  /// Sets the area that each patch has of the wall of each cell, in the geometry's units, a
  /// component for each of patchNames(). It is the wall's own area, not that of its vector.
  /// @throws Error(Argument) as cells(), and unless there are as many components.
  void fillPatchAreas(amrex::MultiFab& areas, const amrex::Geometry& geometry) const {
    require(areas.nComp() == static_cast<int>(patchNames(geometry).size()),
            "AmrexIndexSpace: need a component for each patch", Named{"components", areas.nComp()},
            Named{"patches", patchNames(geometry).size()});
    areas.setVal(0);
    forWallParts(areas, geometry,
                 [&](const Index3& at, std::uint32_t patch, double area,
                     const amrex::Array4<amrex::Real>& array) {
                   array(at.i, at.j, at.k, static_cast<int>(patch)) =
                       static_cast<amrex::Real>(area);
                 });
  }
  /// Sets the patch that has the largest part of the wall of each cell, as an index of
  /// patchNames(); -1 where there is no wall. @throws Error(Argument) as cells().
  void fillPatches(amrex::iMultiFab& patches, const amrex::Geometry& geometry) const {
    patches.setVal(-1);
    Index3 last;
    double largest = -1;
    forWallParts(
        patches, geometry,
        [&](const Index3& at, std::uint32_t patch, double area, const amrex::Array4<int>& array) {
          auto& value = array(at.i, at.j, at.k);
          if (value >= 0 && at == last && area <= largest) return;
          value = static_cast<int>(patch);
          last = at;
          largest = area;
        });
  }

 private:
  using Levels = std::vector<std::unique_ptr<AmrexLevel>>;

  Levels levelsFrom(const amrex::Geometry& finest, int coarse) const {
    Levels levels;
    auto geometry = finest;
    SingleValuedCells cells(cut_(finest), {.smallest = options_.smallest,
                                           .isPlane = AMREX_SPACEDIM == 2,
                                           .threads = options_.threads});
    const auto isBody = [&] {
      return cells.classify(detail::amrexIndices(geometry.Domain())) == FluidClass::Body;
    };
    require(!isBody(), "buildEB: all of the domain is body: is the fluid on the other side?");
    for (;;) {
      levels.push_back(std::make_unique<AmrexLevel>(this, geometry, cells, options_));
      if (static_cast<int>(levels.size()) > coarse || !cells.canCoarsen()) return levels;
      cells = cells.coarser();
      geometry = amrex::coarsen(geometry, 2);
      if (isBody()) return levels;
    }
  }
  /// The level of a domain; null if there is none.
  template <typename Kind>
  static const Kind* find(const std::vector<std::unique_ptr<Kind>>& levels,
                          const amrex::Box& domain) {
    const auto found = std::find_if(levels.begin(), levels.end(), [&](const auto& level) {
      return level->Geom().Domain() == domain;
    });
    return found == levels.end() ? nullptr : found->get();
  }
  [[nodiscard]] const amrex::EB2::Level& levelOf(const amrex::Box& domain) const {
    if (const auto* regular = find(regular_, domain)) return *regular;
    const auto* level = find(levels_, domain);
    require(level != nullptr, "AmrexIndexSpace: no level has this domain",
            Named{"cells along x", domain.length(0)});
    return *level;
  }

  /// Calls visit(cell, patch, area, array) for the parts of walls in the cells of a field.
  template <typename Field, typename Visit>
  void forWallParts(Field& field, const amrex::Geometry& geometry, const Visit& visit) const {
    const auto& cut = cells(geometry).cells();
    const auto& parts = cut.wallParts;
    for (amrex::MFIter grid(field); grid.isValid(); ++grid) {
      const auto array = field.array(grid);
      const auto box = detail::amrexIndices(array);
      for (std::size_t n = 0; n < parts.piece.size(); ++n) {
        const auto& at = cut.cells.index[cut.pieces.cell[parts.piece[n]]];
        if (box.contains(at)) visit(at, parts.patch[n], parts.area[n], array);
      }
    }
  }

  Cut cut_;
  AmrexOptions options_;
  Levels levels_;  // from the finest to the coarsest
  std::vector<std::unique_ptr<AmrexRegularLevel>> regular_;
};

namespace detail {

/// A geometry's domain; in 2D in the plane at z.
inline HostDomain amrexDomain(const amrex::Geometry& geometry, double z) {
  HostDomain domain{.cells = amrexIndices(geometry.Domain()),
                    .origin = {},
                    .width = {},
                    .isPlane = AMREX_SPACEDIM == 2,
                    .z = z};
  for (int axis = 0; axis < AMREX_SPACEDIM; ++axis) {
    domain.origin[axis] = static_cast<double>(geometry.ProbLo(axis));
    domain.width[axis] = static_cast<double>(geometry.CellSize(axis));
    domain.isPeriodic[static_cast<std::size_t>(axis)] = geometry.isPeriodic(axis);
  }
  return domain;
}

}  // namespace detail

/// Makes AMReX's index space of a CellCutter's or a SolidCutter's cells, and pushes it, so that
/// makeEBFabFactory() and the solvers use it as they use one that EB2::Build() has made. AMReX
/// owns it from then on.
///
/// @param cutter  with the domain's period along axes in which the geometry is periodic, and none
/// along others.
/// @param geometry  of the finest level.
/// @param options  see there.
/// @throws Error(Argument) for another period, for any in 2D, where no fluid is in the domain, as
/// cutting does, and unless options are in their ranges.
template <typename Cutter>
const AmrexIndexSpace& buildEB(const Cutter& cutter, const amrex::Geometry& geometry,
                               const AmrexOptions& options = {}) {
  require(options.coarseLevels >= 0 && options.beyond >= 0 && options.boxes >= 1,
          "buildEB: need no negative numbers, and boxes of a cell at least");
  const auto cut = [cutter, options](const amrex::Geometry& domain) {
    return cellsOf(cutter, detail::amrexDomain(domain, options.z),
                   {.polygons = AMREX_SPACEDIM == 3, .threads = options.threads});
  };
  auto space = std::make_unique<AmrexIndexSpace>(cut, geometry, options);
  const auto& result = *space;
  amrex::EB2::IndexSpace::push(space.release());
  return result;
}

}  // namespace cutwater
