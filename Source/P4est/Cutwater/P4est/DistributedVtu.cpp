#include <Cutwater/Core/Detail/OutputFile.hpp>
#include <Cutwater/Io/VtkFiles.hpp>
#include <Cutwater/P4est/Agreement.hpp>
#include <Cutwater/P4est/DistributedVtu.hpp>

#include <optional>

namespace cutwater {

std::filesystem::path piecePath(const std::filesystem::path& path, int rank, int size) {
  const auto number = std::to_string(rank);
  const auto digits = std::to_string(size - 1).size();
  return path.parent_path() /
         (path.stem().string() + "_" + std::string(digits - number.size(), '0') + number + ".vtu");
}

template <std::floating_point T>
void writePvtu(const std::filesystem::path& path, const DistributedOctree<T>& mesh,
               std::span<const VtkArray> arrays, const VtuOptions& options) {
  const auto comm = mesh.communicator();
  int rank = 0;
  int size = 0;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &size);
  std::optional<OutputFile> file;
  agreed(comm, [&] {
    file.emplace(piecePath(path, rank, size));
    detail::writeVtu(*file, mesh.local(), arrays, options);
  });
  agreed(comm, [&] { file->commit(); });
  agreed(comm, [&] {
    if (rank != 0) return;
    std::vector<std::string> pieces;
    for (int r = 0; r < size; ++r) pieces.push_back(piecePath(path, r, size).filename().string());
    writePvtu<T>(path, pieces, arrays);
  });
}

template void writePvtu(const std::filesystem::path&, const DistributedOctree<float>&,
                        std::span<const VtkArray>, const VtuOptions&);
template void writePvtu(const std::filesystem::path&, const DistributedOctree<double>&,
                        std::span<const VtkArray>, const VtuOptions&);

}  // namespace cutwater
