#pragma once

#include <Cutwater/Grid/Octree.hpp>
#include <Cutwater/Grid/OctreeChecksum.hpp>

#include <memory>
#include <mpi.h>

struct p8est;

namespace cutwater {

/// Options of a DistributedOctree; the same on all ranks.
struct DistributedOctreeOptions {
  Balance balance = Balance::Corner;
  /// How many other cells a cell that the surface may meet counts for when ranks get their shares.
  int cutWeight = 1;
  /// Of each rank; 0: as many as there are. See ParallelOptions.
  int threads = 0;
};

/// The mesh that Octree is, over the ranks of an MPI program: p4est's forest of octrees (Burstedde,
/// Wilcox and Ghattas 2011, "p4est: scalable algorithms for parallel adaptive mesh refinement on
/// forests of octrees"), one tree for each root of the domain.
///
/// The cells, their order, kinds and coordinates are those of Octree to the bit, on any number of
/// ranks: each has a stretch of them, which may be empty. Cells are divided level by level, those
/// of each level shared out anew before they are judged. Each rank holds the list of all roots, a
/// few hundred bytes each.
///
/// Constructors and functions that say so are collective: all ranks call them, and give the
/// same arguments. The communicator must outlive the mesh.
template <std::floating_point T>
class DistributedOctree {
 public:
  /// Collective. The solid is the same on all ranks: see SharedGeometry.
  /// @throws Error, the same on all ranks: as Octree; if levels beyond p4est's 18 or more than 2^24
  /// roots are asked for, or the weight is not in 1 ... 1000.
  DistributedOctree(const SignedDistanceFunction<T>& solid, const OctreeDomain<T>& domain,
                    const Refinement<T>& refinement, MPI_Comm comm,
                    const DistributedOctreeOptions& options = {});

  /// This rank's cells. fill() takes them as it does those of an Octree.
  [[nodiscard]] const OctreeCells<T>& local() const { return *local_; }
  /// Of this rank's first cell in the list of all, that of an Octree.
  [[nodiscard]] std::uint64_t firstNumber() const { return firstNumber_; }
  /// On all ranks.
  [[nodiscard]] std::uint64_t cellCount() const { return cellCount_; }
  [[nodiscard]] MPI_Comm communicator() const { return comm_; }

  /// checksum() of all ranks' cells and values, that of an Octree of them. Collective.
  [[nodiscard]] std::uint64_t checksum(const OctreeTargets<T>& values) const;
  /// p8est_checksum(), of levels and places, on all ranks. Collective.
  [[nodiscard]] std::uint32_t forestChecksum() const;

  /// For p4est's ghost layers, node numbers and iterators. Not to be changed: p8est_copy() makes a
  /// forest that is. It has no user data.
  [[nodiscard]] p8est* forest() const { return forest_.get(); }

 private:
  MPI_Comm comm_;
  std::shared_ptr<p8est> forest_;
  std::uint64_t firstNumber_ = 0;
  std::uint64_t cellCount_ = 0;
  std::optional<OctreeCells<T>> local_;
};

extern template class DistributedOctree<float>;
extern template class DistributedOctree<double>;

}  // namespace cutwater
