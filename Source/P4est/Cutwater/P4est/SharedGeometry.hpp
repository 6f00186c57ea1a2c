#pragma once

#include <Cutwater/Core/FunctionRef.hpp>
#include <Cutwater/Mesh/MeshSDF.hpp>
#include <Cutwater/Surface/ReadSurface.hpp>

#include <memory>
#include <mpi.h>
#include <optional>

namespace cutwater {

namespace detail {
class NodeMemory;
}

/// Options of a SharedGeometry; the same on all ranks.
struct SharedGeometryOptions {
  ReadOptions read = {};      ///< for surfaces; geometry files are used as they are
  MeshSDFOptions solid = {};  ///< likewise
  /// At most this many ranks of a node share one copy; 0: all of them. On nodes with several
  /// memories, the ranks at each may do better with a copy of their own.
  int ranksPerCopy = 0;
};

/// A surface mesh that the ranks of an MPI program share: rank 0 reads and builds it, its bytes are
/// sent once to every node, and the ranks of a node use one copy of them, in a window of shared
/// memory (MPI 3). Each rank's mesh gives the same bits as if it had built its own.
///
/// Constructor and destructor are collective. Copies of the mesh, and Solids made of it, may
/// outlive this object: the node's memory then remains allocated until the process ends.
template <std::floating_point T>
class SharedGeometry {
 public:
  /// From a surface or a file written by MeshSDF::save() or `cutwater prepare`, which rank 0 alone
  /// opens.
  /// @throws Error, the same on all ranks: what readAnySurface() and MeshSDF throw on rank 0;
  /// Error(Limit) if a node does not have enough memory for a copy.
  SharedGeometry(const std::filesystem::path& path, MPI_Comm comm,
                 const SharedGeometryOptions& options = {});
  /// From a mesh that rank 0 alone makes.
  /// @throws Error, the same on all ranks: what `make` throws, and as above.
  SharedGeometry(MPI_Comm comm, FunctionRef<MeshSDF<T>()> make, int ranksPerCopy = 0);

  ~SharedGeometry();
  SharedGeometry(const SharedGeometry&) = delete;
  SharedGeometry& operator=(const SharedGeometry&) = delete;
  SharedGeometry(SharedGeometry&&) = delete;
  SharedGeometry& operator=(SharedGeometry&&) = delete;

  [[nodiscard]] const MeshSDF<T>& mesh() const { return *mesh_; }

 private:
  std::unique_ptr<detail::NodeMemory> memory_;
  std::optional<MeshSDF<T>> mesh_;
};

extern template class SharedGeometry<float>;
extern template class SharedGeometry<double>;

}  // namespace cutwater
