#pragma once

#include <Cutwater/Grid/OctreeDomain.hpp>
#include <Cutwater/Grid/Refinement.hpp>

#include <optional>

namespace cutwater {

/// A cell of an octree mesh: a level's cell by its global index.
struct OctreeCell {
  Index3 index;
  std::uint8_t level = 0;
  BoxClass kind = BoxClass::Unknown;

  bool operator==(const OctreeCell&) const = default;
};

/// Which neighbours differ by one level at most.
enum class Balance : std::uint8_t {
  None,
  Face,
  Edge,    ///< those that share an edge as well
  Corner,  ///< and those that share a corner
};

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
class Octree {
 public:
  /// @throws Error as Refinement::check(), or if it asks for levels beyond domain.deepest().
  Octree(const SignedDistanceFunction<T>& solid, const OctreeDomain<T>& domain,
         const Refinement<T>& refinement, const OctreeOptions& options = {});

  [[nodiscard]] const OctreeDomain<T>& domain() const { return domain_; }
  /// In the order of their Morton codes: neighbours in space are mostly neighbours in the list.
  [[nodiscard]] std::span<const OctreeCell> cells() const { return cells_; }
  /// The finest level that there may be cells of.
  [[nodiscard]] int deepest() const { return static_cast<int>(levels_.size()) - 1; }
  /// How many cells there are of each kind.
  [[nodiscard]] std::size_t count(BoxClass kind) const;

  [[nodiscard]] Vec3<T> center(const OctreeCell& cell) const {
    return levels_[cell.level].position(cell.index);
  }
  [[nodiscard]] Box<T> box(const OctreeCell& cell) const {
    return levels_[cell.level].cell(cell.index);
  }

  /// Place in cells() of the cell that holds that cell of a level, or is the first one in it;
  /// nothing outside of the domain.
  [[nodiscard]] std::optional<std::size_t> find(const Index3& index, int level) const;
  /// Of the cell that holds the point.
  [[nodiscard]] std::optional<std::size_t> find(const Vec3<T>& point) const;

 private:
  OctreeDomain<T> domain_;
  std::vector<Level<T>> levels_;
  std::vector<OctreeCell> cells_;
};

extern template class Octree<float>;
extern template class Octree<double>;

}  // namespace cutwater
