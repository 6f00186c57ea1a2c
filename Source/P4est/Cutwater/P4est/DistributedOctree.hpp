#pragma once

#include <Cutwater/CutCells/CellCutter.hpp>
#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Grid/OctreeFill.hpp>

#include <limits>
#include <memory>
#include <mpi.h>

struct p8est;

namespace cutwater {

/// Options of a DistributedOctree; the same on all ranks, but for `threads`.
struct DistributedOctreeOptions {
  Balance balance = Balance::Corner;
  /// Weight, in the partition among ranks, of a cell that the surface may meet; other cells weigh
  /// 1.
  int cutWeight = 1;
  /// An Error of kind Limit is thrown before there are more cells than this on all ranks together.
  std::size_t maxCells = std::numeric_limits<std::size_t>::max();
  /// At most this many threads on each rank; 0: as many as there are. See ParallelOptions.
  int threads = 0;
};

/// The cut leaves of one rank: see DistributedOctree::cut().
struct DistributedCut {
  /// Where an arc leads to a leaf of another rank.
  struct Rim {
    std::uint32_t arc = 0;   ///< its row in `leaves`; the side that is kBeyond there
    std::uint64_t leaf = 0;  ///< its number among the leaves of all ranks
    /// The number of the piece among those of that leaf, from 0, or CutLeaves::kWholeCell.
    std::uint32_t piece = 0;
    bool operator==(const Rim&) const = default;
  };

  CutLeaves leaves;       ///< of this rank, by their index in DistributedOctree::local()
  std::vector<Rim> rims;  ///< in the order of arcs
};

/// The mesh of an Octree, distributed over the ranks of an MPI program: p4est's forest of octrees
/// (Burstedde, Wilcox and Ghattas 2011, "p4est: scalable algorithms for parallel adaptive mesh
/// refinement on forests of octrees"), one tree for each root of the domain.
///
/// The cells, their order, kinds and coordinates are those of Octree to the bit, on any number of
/// ranks: each rank has a contiguous part of them, which may be empty. Cells are divided level by
/// level; those of each level are partitioned again before the rules are applied to them. Each rank
/// holds the list of all roots, a few hundred bytes each.
///
/// Constructors, and functions documented as such, are collective: all ranks call them, with the
/// same arguments but for the number of threads. The communicator must outlive the mesh.
template <std::floating_point T>
class DistributedOctree {
 public:
  /// Collective. The solid must be the same on all ranks: see SharedGeometry.
  /// @throws Error, the same on all ranks: if they have different domains, refinements, options, or
  /// solids with different bounding boxes; as Octree; if there are levels beyond p4est's 18 or more
  /// than 2^24 roots, or more cells than options.maxCells, or the weight is not in 1 ... 1000.
  DistributedOctree(const SignedDistanceFunction<T>& solid, const OctreeDomain<T>& domain,
                    const Refinement<T>& refinement, MPI_Comm comm,
                    const DistributedOctreeOptions& options = {});

  /// This rank's cells. fill() accepts them just as those of an Octree.
  [[nodiscard]] const OctreeCells<T>& local() const { return *local_; }
  /// Index of this rank's first cell among all cells, which are ordered as in an Octree.
  [[nodiscard]] std::uint64_t firstNumber() const { return firstNumber_; }
  /// Number of cells on all ranks together.
  [[nodiscard]] std::uint64_t cellCount() const { return cellCount_; }
  [[nodiscard]] MPI_Comm communicator() const { return comm_; }

  /// checksum() of all ranks' cells and values, equal to that of an Octree with them. Collective.
  [[nodiscard]] std::uint64_t checksum(const OctreeTargets<T>& values) const;
  /// p8est_checksum() of levels and positions, returned on all ranks. Collective.
  [[nodiscard]] std::uint32_t forestChecksum() const;

  /// Cuts this rank's leaves: rows are those that CellCutter::cut() gives for all leaves, to the
  /// bit, on any number of ranks, but for the order of numbers, and arcs to leaves of other ranks
  /// are told by `rims`. Sums over ranks are those of the whole. Collective. The cutter must be of
  /// the same solid on all ranks; ranks cut leaves of others that touch theirs once more, and send
  /// no rows.
  /// @throws Error(Argument), the same on all ranks, for a mesh without balance, and as
  /// CellCutter::cut().
  [[nodiscard]] DistributedCut cut(const CellCutter& cutter, const CutOptions& options = {}) const;

  /// The forest, for p4est's ghost layers, node numbers and iterators. It must not be changed;
  /// p8est_copy() makes a copy that may be. It has no user data.
  [[nodiscard]] p8est* forest() const { return forest_.get(); }

 private:
  MPI_Comm comm_;
  Balance balance_;
  std::shared_ptr<p8est> forest_;
  std::uint64_t firstNumber_ = 0;
  std::uint64_t cellCount_ = 0;
  std::optional<OctreeCells<T>> local_;
};

extern template class DistributedOctree<float>;
extern template class DistributedOctree<double>;

}  // namespace cutwater
