#pragma once

#include <Cutwater/Core/Parallel.hpp>
#include <Cutwater/Grid/OctreeCells.hpp>
#include <Cutwater/Grid/Refinement.hpp>

#include <limits>
#include <optional>

namespace cutwater {

/// Which neighbours differ by at most one level.
enum class Balance : std::uint8_t {
  None,
  Face,
  Edge,    ///< also those that share an edge
  Corner,  ///< also those that share a corner
};

/// Options of an Octree.
struct OctreeOptions {
  Balance balance = Balance::Corner;
  /// An Error of kind Limit is thrown before there are more cells than this: see estimate().
  std::size_t maxCells = std::numeric_limits<std::size_t>::max();
  /// At most this many threads; 0: as many as there are. See ParallelOptions.
  int threads = 0;
  Progress progress = {};
};

/// An AMR mesh around a surface: the leaves of octrees, which cover the domain without overlap.
///
/// Cells are divided from the roots down according to the refinement's rules, just as in tag();
/// then as few others as balancing needs. The mesh is the same for any number of threads. All it
/// stores of the solid is each cell's kind: classify() of its box.
template <std::floating_point T>
class Octree : public OctreeCells<T> {
 public:
  /// @throws Error as Refinement::check(), or if it asks for levels beyond domain.deepest(); of
  /// kind Limit if there are more cells than options.maxCells.
  Octree(const SignedDistanceFunction<T>& solid, const OctreeDomain<T>& domain,
         const Refinement<T>& refinement, const OctreeOptions& options = {});

  /// Index in cells() of the cell that contains the given cell of a level, or, if that is divided,
  /// of the first cell in it. No value outside the domain. `level` is from 0 to domain().deepest().
  [[nodiscard]] std::optional<std::size_t> find(const Index3& index, int level) const;
  /// Index of the cell that contains the point; if several share it, of the one on the upper side.
  [[nodiscard]] std::optional<std::size_t> find(const Vec3<T>& point) const;
};

extern template class Octree<float>;
extern template class Octree<double>;

}  // namespace cutwater
