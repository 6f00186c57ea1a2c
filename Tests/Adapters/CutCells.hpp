#pragma once

#include <Cutwater/Core/Parallel.hpp>

#include <array>
#include <atomic>
#include <cmath>
#include <mutex>
#include <utility>
#include <vector>

#include <AMReX_BaseFab.H>
#include <AMReX_EB2_Graph.H>
#include <AMReX_Geometry.H>

namespace cutwater::test {

/// What EB2::Build() does with a geometry shop on one level, as far as cells' types and the volume
/// of the fluid: boxes are sorted by getBoxType(), and those with mixed cells are looked at in a
/// parallel region. Bodies do not go on behind the domain's faces. Cells of less fluid than AMReX's
/// small_volfrac, 1e-14 of them, are covered; it is enough to look at those with one fluid corner.
template <class Shop>
class CutCells {
 public:
  static constexpr int kDim = AMREX_SPACEDIM;

  CutCells(Shop shop, const amrex::Geometry& geometry, int gridSize)
      : shop_(std::move(shop)),
        geometry_(geometry),
        within_(amrex::surroundingNodes(geometry.Domain()).grow(2)) {
    const auto boxes = grids(gridSize);
    parallelFor(boxes.size(), {}, [&](std::size_t begin, std::size_t end) {
      for (auto i = begin; i < end; ++i) build(boxes[i]);
    });
  }

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::size_t mixedGrids() const { return mixedGrids_; }
  /// From the fluid's length on edges along x, and the mean of those of each cell. In 2D the area.
  [[nodiscard]] double fluidVolume() const { return volume_; }
  /// Edges whose intercept is not between their nodes, or that have one although they are not cut.
  [[nodiscard]] std::size_t wrongIntercepts() const { return wrongIntercepts_; }

 private:
  using Real = amrex::Real;
  using EdgeFabs = std::vector<amrex::BaseFab<Real>>;
  using TypeFabs = std::vector<amrex::BaseFab<amrex::EB2::Type_t>>;

  [[nodiscard]] std::vector<amrex::Box> grids(int size) const {
    std::vector<amrex::Box> boxes;
    const auto n = geometry_.Domain().bigEnd().dim3(0);
    for (int k = 0; k <= n.z; k += size) {
      for (int j = 0; j <= n.y; j += size) {
        for (int i = 0; i <= n.x; i += size) {
          amrex::IntVect lo(0);
          const int at[] = {i, j, k};
          for (int dir = 0; dir < kDim; ++dir) lo[dir] = at[dir];
          auto hi = lo;
          for (int dir = 0; dir < kDim; ++dir) hi[dir] += size - 1;
          boxes.push_back(amrex::Box(lo, hi) & geometry_.Domain());
        }
      }
    }
    return boxes;
  }

  void build(const amrex::Box& valid) {
    const auto nodes = amrex::surroundingNodes(amrex::grow(valid, 1));
    const auto kind = shop_.getBoxType(nodes & within_, geometry_, amrex::RunOn::Cpu);
    if (kind == Shop::allregular) add(0, cellVolume() * static_cast<double>(cellsOf(valid)));
    if (kind != Shop::mixedcells) return;
    ++mixedGrids_;
    amrex::BaseFab<Real> levelSet(nodes);
    shop_.fillFab(levelSet, geometry_, amrex::RunOn::Cpu, within_);
    const auto values = static_cast<const amrex::BaseFab<Real>&>(levelSet);
    TypeFabs types;
    EdgeFabs intercepts;
    amrex::Array<amrex::Array4<Real>, kDim> interceptArrays;
    amrex::Array<amrex::Array4<const amrex::EB2::Type_t>, kDim> typeArrays;
    for (int axis = 0; axis < kDim; ++axis) {
      auto edges = nodes;
      edges.growHi(axis, -1);
      types.push_back(typesOf(edges, axis, values.const_array()));
      intercepts.emplace_back(edges);
    }
    for (int axis = 0; axis < kDim; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      interceptArrays[a] = intercepts[a].array();
      typeArrays[a] = types[a].const_array();
    }
    shop_.getIntercept(interceptArrays, typeArrays, values.const_array(), geometry_,
                       amrex::RunOn::Cpu, within_);
    for (int axis = 0; axis < kDim; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      checkIntercepts(axis, typeArrays[a], interceptArrays[a]);
    }
    addCells(valid, values.const_array(), typeArrays[0], interceptArrays);
  }

  template <typename Visit>
  static void forEach(const amrex::Dim3& lo, const amrex::Dim3& hi, Visit visit) {
    for (int k = lo.z; k <= hi.z; ++k) {
      for (int j = lo.y; j <= hi.y; ++j) {
        for (int i = lo.x; i <= hi.x; ++i) visit(i, j, k);
      }
    }
  }

  static amrex::BaseFab<amrex::EB2::Type_t> typesOf(const amrex::Box& edges, int axis,
                                                    const amrex::Array4<const Real>& values) {
    namespace Type = amrex::EB2::Type;
    amrex::BaseFab<amrex::EB2::Type_t> fab(edges);
    const auto types = fab.array();
    forEach(lbound(edges), ubound(edges), [&](int i, int j, int k) {
      const bool fluid = values(i, j, k) < 0;
      const bool next = values(i + (axis == 0), j + (axis == 1), k + (axis == 2)) < 0;
      types(i, j, k) = fluid && next   ? Type::regular
                       : fluid || next ? Type::irregular
                                       : Type::covered;
    });
    return fab;
  }

  void checkIntercepts(int axis, const amrex::Array4<const amrex::EB2::Type_t>& types,
                       const amrex::Array4<Real>& intercepts) {
    forEach(lbound(intercepts), ubound(intercepts), [&](int i, int j, int k) {
      const Real at = intercepts(i, j, k);
      if (types(i, j, k) != amrex::EB2::Type::irregular) {
        wrongIntercepts_ += std::isnan(at) ? 0 : 1;
        return;
      }
      const auto node = static_cast<Real>(axis == 0 ? i : axis == 1 ? j : k);
      const Real lower = geometry_.ProbLo(axis) + node * geometry_.CellSize(axis);
      const Real upper = geometry_.ProbLo(axis) + (node + 1) * geometry_.CellSize(axis);
      wrongIntercepts_ += lower < at && at < upper ? 0 : 1;
    });
  }

  void addCells(const amrex::Box& valid, const amrex::Array4<const Real>& values,
                const amrex::Array4<const amrex::EB2::Type_t>& xTypes,
                const amrex::Array<amrex::Array4<Real>, kDim>& intercepts) {
    std::size_t cut = 0;
    double lengths = 0;
    forEach(lbound(valid), ubound(valid), [&](int i, int j, int k) {
      int fluid = 0;
      for (int edge = 0; edge < kCorners / 2; ++edge) {
        const int jj = j + (edge & 1);
        const int kk = k + (edge >> 1);
        fluid += (values(i, jj, kk) < 0) + (values(i + 1, jj, kk) < 0);
        lengths +=
            fluidLength(i, values(i, jj, kk) < 0, xTypes(i, jj, kk), intercepts[0](i, jj, kk));
      }
      const bool isCut = 0 < fluid && fluid < kCorners;
      cut += isCut && !(fluid == 1 && fluidShare({i, j, k}, values, intercepts) < 1e-14) ? 1 : 0;
    });
    add(cut, lengths / (kCorners / 2) * cellVolume() / geometry_.CellSize(0));
  }

  [[nodiscard]] double fluidLength(int i, bool startsInFluid, amrex::EB2::Type_t type,
                                   Real intercept) const {
    const double h = geometry_.CellSize(0);
    if (type == amrex::EB2::Type::regular) return h;
    if (type == amrex::EB2::Type::covered) return 0;
    const double before = intercept - (geometry_.ProbLo(0) + i * h);
    return startsInFluid ? before : h - before;
  }

  /// The part of a cell that is fluid at one corner only: a simplex.
  [[nodiscard]] double fluidShare(const std::array<int, 3>& cell,
                                  const amrex::Array4<const Real>& values,
                                  const amrex::Array<amrex::Array4<Real>, kDim>& intercepts) const {
    auto corner = cell;
    for (int n = 0; n < kCorners; ++n) {
      const std::array<int, 3> at{cell[0] + (n & 1), cell[1] + (n >> 1 & 1), cell[2] + (n >> 2)};
      if (values(at[0], at[1], at[2]) < 0) corner = at;
    }
    double share = 1;
    for (std::size_t axis = 0; axis < kDim; ++axis) {
      auto edge = corner;
      edge[axis] = cell[axis];
      const int dir = static_cast<int>(axis);
      const double h = geometry_.CellSize(dir);
      const double node = geometry_.ProbLo(dir) + corner[axis] * h;
      const double length = std::abs(intercepts[axis](edge[0], edge[1], edge[2]) - node);
      share *= length / h / static_cast<double>(axis + 1);
    }
    return share;
  }

  static std::size_t cellsOf(const amrex::Box& box) {
    std::size_t n = 1;
    for (int dir = 0; dir < kDim; ++dir) n *= static_cast<std::size_t>(box.length(dir));
    return n;
  }
  [[nodiscard]] double cellVolume() const {
    double volume = 1;
    for (int dir = 0; dir < kDim; ++dir) volume *= geometry_.CellSize(dir);
    return volume;
  }
  void add(std::size_t cut, double volume) {
    const std::lock_guard lock(mutex_);
    count_ += cut;
    volume_ += volume;
  }

  static constexpr int kCorners = 1 << kDim;

  Shop shop_;
  amrex::Geometry geometry_;
  amrex::Box within_;
  std::mutex mutex_;
  std::size_t count_ = 0;
  double volume_ = 0;
  std::atomic<std::size_t> mixedGrids_ = 0;
  std::atomic<std::size_t> wrongIntercepts_ = 0;
};

}  // namespace cutwater::test
