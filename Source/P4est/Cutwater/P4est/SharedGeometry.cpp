#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Io/VtpSurface.hpp>
#include <Cutwater/P4est/Agreement.hpp>
#include <Cutwater/P4est/Detail/NodeMemory.hpp>
#include <Cutwater/P4est/SharedGeometry.hpp>

namespace cutwater {

namespace {

/// The mesh's bytes on rank 0; no bytes on other ranks.
template <std::floating_point T>
Block bytesOf(MPI_Comm comm, FunctionRef<MeshSDF<T>()> make) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  Block bytes;
  agreed(comm, [&] {
    if (rank == 0) bytes = make().toBytes();
  });
  return bytes;
}

template <std::floating_point T>
MeshSDF<T> read(const std::filesystem::path& path, const SharedGeometryOptions& options) {
  if (geometryFileInfo(path)) return MeshSDF<T>::open(path);
  return MeshSDF<T>(readAnySurface(path, options.read).soup, options.solid);
}

}  // namespace

template <std::floating_point T>
SharedGeometry<T>::SharedGeometry(const std::filesystem::path& path, MPI_Comm comm,
                                  const SharedGeometryOptions& options)
    : SharedGeometry(
          comm, [&] { return read<T>(path, options); }, options.ranksPerCopy) {}

template <std::floating_point T>
SharedGeometry<T>::SharedGeometry(MPI_Comm comm, FunctionRef<MeshSDF<T>()> make, int ranksPerCopy)
    : memory_(std::make_unique<detail::NodeMemory>(comm, bytesOf<T>(comm, make).bytes(),
                                                   ranksPerCopy)) {
  // The rank that wrote a copy verifies all of it; the others need not.
  const MeshViewOptions options{.verifyPayload = memory_->isWriter()};
  try {
    agreed(comm, [&] { mesh_.emplace(MeshSDF<T>::view(memory_->block(), options)); });
  } catch (const Error&) {
    mesh_.reset();
    memory_->free();
    throw;
  }
}

template <std::floating_point T>
SharedGeometry<T>::~SharedGeometry() = default;

template class SharedGeometry<float>;
template class SharedGeometry<double>;

}  // namespace cutwater
