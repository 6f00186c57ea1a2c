#pragma once

#include <Cutwater/Grid/OctreeCells.hpp>
#include <Cutwater/Grid/Refinement.hpp>

#include <optional>

namespace cutwater {

/// Which neighbours differ by one level at most.
enum class Balance : std::uint8_t {
  None,
  Face,
  Edge,    ///< those that share an edge as well
  Corner,  ///< and those that share a corner
};

/// Options of an Octree.
struct OctreeOptions {
  Balance balance = Balance::Corner;
  /// At most this many threads; 0: as many as there are. See ParallelOptions.
  int threads = 0;
  Progress progress = {};
};

/// An AMR mesh around a surface: the leaves of octrees, which cover the domain without overlap.
///
/// Cells are divided from the roots down as the refinement's rules ask, which are those of tag();
/// then as few more as it takes to balance the mesh. It is the same for any number of threads, and
/// knows nothing of the solid but each cell's kind: classify() of its box.
template <std::floating_point T>
class Octree : public OctreeCells<T> {
 public:
  /// @throws Error as Refinement::check(), or if it asks for levels beyond domain.deepest().
  Octree(const SignedDistanceFunction<T>& solid, const OctreeDomain<T>& domain,
         const Refinement<T>& refinement, const OctreeOptions& options = {});

  /// Place in cells() of the cell that holds that cell of a level, or is the first one in it;
  /// nothing outside of the domain. `level` is from 0 to domain().deepest().
  [[nodiscard]] std::optional<std::size_t> find(const Index3& index, int level) const;
  /// Of the cell that holds the point; of those that share it, the one on the upper side.
  [[nodiscard]] std::optional<std::size_t> find(const Vec3<T>& point) const;
};

extern template class Octree<float>;
extern template class Octree<double>;

}  // namespace cutwater
