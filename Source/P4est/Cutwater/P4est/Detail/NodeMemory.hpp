#pragma once

#include <Cutwater/Core/Block.hpp>

#include <mpi.h>

namespace cutwater::detail {

/// Bytes of which each compute node has one copy, in a window that its ranks share. They begin at a
/// multiple of BlockWriter::kAlignment.
class NodeMemory {
 public:
  /// Collective. Takes rank 0's bytes, sent once for every other copy; those of other ranks are
  /// ignored. `ranksPerCopy`: at most this many ranks of a node share a copy; 0: all of them.
  /// @throws Error(Limit) on all ranks if a node does not have enough memory.
  NodeMemory(MPI_Comm comm, std::span<const std::byte> bytes, int ranksPerCopy = 0);
  /// Collective over the ranks that share a copy, unless an exception is being thrown. Memory that
  /// a rank's copies of block() still use remains allocated for the rest of the process.
  ~NodeMemory();
  NodeMemory(const NodeMemory&) = delete;
  NodeMemory& operator=(const NodeMemory&) = delete;
  NodeMemory(NodeMemory&&) = delete;
  NodeMemory& operator=(NodeMemory&&) = delete;

  [[nodiscard]] Block block() const { return {users_, bytes_}; }
  /// Whether this rank is the one that wrote its copy.
  [[nodiscard]] bool isWriter() const { return isWriter_; }
  /// Does what the destructor does; for use when all ranks throw an exception.
  void free();

 private:
  void allocate(std::uint64_t size);
  void receive(std::span<const std::byte> bytes, MPI_Comm writers);

  void split(MPI_Comm comm, int ranksPerCopy);

  MPI_Comm sharers_ = MPI_COMM_NULL;
  MPI_Win window_ = MPI_WIN_NULL;
  bool isWriter_ = false;
  int exceptions_;                     // uncaught ones at construction
  std::shared_ptr<const void> users_;  // shared by all copies of the block and this
  std::span<std::byte> bytes_;
};

}  // namespace cutwater::detail
