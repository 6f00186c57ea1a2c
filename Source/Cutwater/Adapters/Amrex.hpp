#pragma once

// For code that includes AMReX: EB2 as of October 2024, in 3D or 2D and either precision.

#include <Cutwater/Adapters/NodeLevelSet.hpp>
#include <Cutwater/Core/IndexBox.hpp>
#include <Cutwater/Grid/Tag.hpp>

#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <AMReX_Array4.H>
#include <AMReX_BaseFab.H>
#include <AMReX_Box.H>
#include <AMReX_EB2_Graph.H>
#include <AMReX_Geometry.H>
#include <AMReX_MFIter.H>
#include <AMReX_TagBox.H>

namespace cutwater {

namespace detail {

/// The point; in 2D, in the plane at z.
inline Vec3<amrex::Real> amrexPoint(const amrex::RealArray& p, [[maybe_unused]] amrex::Real z) {
#if AMREX_SPACEDIM == 3
  return {p[0], p[1], p[2]};
#else
  return {p[0], p[1], z};
#endif
}

/// The level; in 2D, one layer in the plane at z, as thin as the smallest normal number.
inline Level<amrex::Real> amrexLevel(const amrex::Geometry& geometry, Centering centering,
                                     [[maybe_unused]] amrex::Real z) {
#if AMREX_SPACEDIM == 3
  return {{geometry.ProbLo(0), geometry.ProbLo(1), geometry.ProbLo(2)},
          {geometry.CellSize(0), geometry.CellSize(1), geometry.CellSize(2)},
          centering};
#else
  return {{geometry.ProbLo(0), geometry.ProbLo(1), z},
          {geometry.CellSize(0), geometry.CellSize(1), std::numeric_limits<amrex::Real>::min()},
          centering};
#endif
}

/// The indices of a Box or an Array4; one layer in 2D.
template <typename Extent>
IndexBox amrexIndices(const Extent& extent) {
  const auto lo = amrex::lbound(extent);
  const auto hi = amrex::ubound(extent);
  return {{lo.x, lo.y, lo.z}, {hi.x, hi.y, hi.z}};
}

/// In an Array4 x varies fastest, without gaps.
template <typename Value>
GridView<Value> amrexView(const amrex::Array4<Value>& array) {
  const auto lo = amrex::lbound(array);
  return GridView<Value>::contiguous(&array(lo.x, lo.y, lo.z), amrexIndices(array));
}

/// Sets the tags of the box's marked cells; x varies fastest in `marks`.
inline void setTags(const amrex::Array4<amrex::TagBox::TagType>& tags, const IndexBox& box,
                    const std::vector<std::uint8_t>& marks) {
  auto mark = marks.begin();
  forEachIndex(box, [&](const Index3& at) {
    if (*mark++ != 0) tags(at.i, at.j, at.k) = amrex::TagBox::SET;
  });
}

}  // namespace detail

/// A FluidDomain as AMReX's implicit function, negative in the fluid, for EB2::makeShop() and other
/// functions that take one. In 2D it is evaluated in the plane at z.
class AmrexFunction {
 public:
  explicit AmrexFunction(FluidDomain<amrex::Real> domain, amrex::Real z = 0)
      : domain_(std::move(domain)), z_(z) {}

  /// The level set: negative in the fluid.
  amrex::Real operator()(const amrex::RealArray& p) const {
    return domain_.levelSet(detail::amrexPoint(p, z_));
  }

 private:
  FluidDomain<amrex::Real> domain_;
  amrex::Real z_;
};

/// A FluidDomain as the geometry shop of EB2::Build(). Unlike a shop around AmrexFunction, it
/// classifies boxes with certainty, without sampling, and cuts edges where the surface crosses
/// them, without iteration. In 2D it is evaluated in the plane at z.
///
///     const AmrexShop shop({hull, FluidSide::Outside, {0.1, 0.1, 0.1}});
///     amrex::EB2::Build(shop, geometry, 0, 0);
///
/// Copies share the solid. Its functions may be called from within a parallel region.
class AmrexShop {
 public:
  /// What EB2 requires of a shop, under EB2's names.
  using FunctionType = AmrexFunction;
  using EdgeArray = amrex::Array4<amrex::Real>;
  using EdgeArrays = amrex::Array<EdgeArray, AMREX_SPACEDIM>;
  using TypeArray = amrex::Array4<amrex::EB2::Type_t const>;
  using TypeArrays = amrex::Array<TypeArray, AMREX_SPACEDIM>;
  using NodeArray = amrex::Array4<amrex::Real const>;

  // NOLINTBEGIN(readability-identifier-naming)
  /// Results of getBoxType(), under AMReX's names: all fluid, cut or undecided, all body.
  static constexpr int allregular = -1;
  static constexpr int mixedcells = 0;
  static constexpr int allcovered = 1;
  // NOLINTEND(readability-identifier-naming)

  explicit AmrexShop(FluidDomain<amrex::Real> domain, amrex::Real z = 0)
      : domain_(std::move(domain)), z_(z) {}

  /// Its functions run on the host only.
  static constexpr bool isGPUable() noexcept { return false; }

  /// Classifies a box of nodes: allregular and allcovered only if no surface touches it.
  int getBoxType(const amrex::Box& nodes, const amrex::Geometry& geometry,
                 amrex::RunOn /*runOn*/) const {
    const NodeLevelSet<amrex::Real> levelSet(domain_, levelOf(geometry));
    switch (levelSet.classify(detail::amrexIndices(nodes))) {
      case FluidClass::Fluid:
        return allregular;
      case FluidClass::Body:
        return allcovered;
      default:
        return mixedcells;
    }
  }

  /// Sets the level set at nodes, see NodeLevelSet::fill(); those outside the box `within` get the
  /// value of its nearest node.
  void fillFab(amrex::BaseFab<amrex::Real>& levelSet, const amrex::Geometry& geometry,
               amrex::RunOn /*runOn*/, const amrex::Box& within) const {
    const NodeLevelSet<amrex::Real> nodes(domain_, levelOf(geometry), detail::amrexIndices(within));
    const auto array = levelSet.array();
    nodes.fill(detail::amrexIndices(array), detail::amrexView(array));
  }

  /// Sets where edges along each axis are cut, as coordinates on it; NaN for edges whose type is
  /// not irregular.
  void getIntercept(const EdgeArrays& intercepts, const TypeArrays& types,
                    const NodeArray& levelSet, const amrex::Geometry& geometry,
                    amrex::RunOn /*runOn*/, const amrex::Box& within) const {
    const NodeLevelSet<amrex::Real> nodes(domain_, levelOf(geometry), detail::amrexIndices(within));
    for (int axis = 0; axis < AMREX_SPACEDIM; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      setIntercepts<Step::Cut>(nodes, axis, types[a], levelSet, intercepts[a]);
    }
  }

  /// Called after AMReX has covered cells by setting nodes to 0: moves the surface to these nodes,
  /// and to the body's nodes where no intercept was known.
  void updateIntercept(const EdgeArrays& intercepts, const TypeArrays& types,
                       const NodeArray& levelSet, const amrex::Geometry& geometry) const {
    const NodeLevelSet<amrex::Real> nodes(domain_, levelOf(geometry));
    for (int axis = 0; axis < AMREX_SPACEDIM; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      setIntercepts<Step::Update>(nodes, axis, types[a], levelSet, intercepts[a]);
    }
  }

 private:
  enum class Step { Cut, Update };

  [[nodiscard]] Level<amrex::Real> levelOf(const amrex::Geometry& geometry) const {
    return detail::amrexLevel(geometry, Centering::Node, z_);
  }

  template <Step step>
  static void setIntercepts(const NodeLevelSet<amrex::Real>& nodes, int axis,
                            const TypeArray& types, const NodeArray& levelSet,
                            const EdgeArray& intercepts) {
    const auto [lo, hi] = detail::amrexIndices(intercepts);
    for (int k = lo.k; k <= hi.k; ++k) {
      for (int j = lo.j; j <= hi.j; ++j) {
        for (int i = lo.i; i <= hi.i; ++i) {
          auto& intercept = intercepts(i, j, k);
          if (types(i, j, k) == amrex::EB2::Type::irregular) {
            const auto edge = edgeAt({i, j, k}, axis, levelSet);
            intercept =
                step == Step::Cut ? nodes.intercept(edge) : nodes.intercept(edge, intercept);
          } else if (step == Step::Cut) {
            intercept = std::numeric_limits<amrex::Real>::quiet_NaN();
          }
        }
      }
    }
  }

  static NodeEdge<amrex::Real> edgeAt(const Index3& node, int axis, const NodeArray& levelSet) {
    NodeEdge<amrex::Real> edge{node, axis, levelSet(node.i, node.j, node.k), 0};
    const auto next = edge.next();
    edge.atNext = levelSet(next.i, next.j, next.k);
    return edge;
  }

  FluidDomain<amrex::Real> domain_;
  amrex::Real z_;
};

/// Sets the tags of cells to be refined and leaves others unchanged, as AmrCore::ErrorEst()
/// requires. `level` is the number of the geometry's level. The tags do not depend on the grids; in
/// 2D they are those of the plane at z.
/// @throws Error as tag().
inline void tagCells(const Refinement<amrex::Real>& refinement,
                     const SignedDistanceFunction<amrex::Real>& solid, amrex::TagBoxArray& tags,
                     const amrex::Geometry& geometry, int level, amrex::Real z = 0) {
  const auto cells = detail::amrexLevel(geometry, Centering::Cell, z);
  std::vector<std::uint8_t> marks;
  for (amrex::MFIter grid(tags); grid.isValid(); ++grid) {
    const auto box = detail::amrexIndices(grid.validbox());
    marks.resize(box.count());
    const auto view = GridView<std::uint8_t>::contiguous(marks.data(), box);
    tag(refinement, solid, {cells, box}, level, view);
    detail::setTags(tags.array(grid), box, marks);
  }
}

}  // namespace cutwater
