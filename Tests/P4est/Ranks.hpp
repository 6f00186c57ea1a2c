#pragma once

#include <Cutwater/Core/Error.hpp>

#include <cstddef>
#include <functional>
#include <memory>
#include <mpi.h>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "Support/TemporaryFolder.hpp"

namespace cutwater::test {

inline int ownRank(MPI_Comm comm = MPI_COMM_WORLD) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  return rank;
}
inline int rankCount(MPI_Comm comm = MPI_COMM_WORLD) {
  int size = 0;
  MPI_Comm_size(comm, &size);
  return size;
}

/// All ranks' values, rank after rank, on every rank.
template <typename Value>
std::vector<Value> gathered(std::span<const Value> own) {
  const int bytes = static_cast<int>(own.size_bytes());
  std::vector<int> counts(static_cast<std::size_t>(rankCount()));
  MPI_Allgather(&bytes, 1, MPI_INT, counts.data(), 1, MPI_INT, MPI_COMM_WORLD);
  std::vector<int> offsets;
  int sum = 0;
  for (const int count : counts) {
    offsets.push_back(sum);
    sum += count;
  }
  std::vector<Value> all(static_cast<std::size_t>(sum) / sizeof(Value));
  MPI_Allgatherv(own.data(), bytes, MPI_BYTE, all.data(), counts.data(), offsets.data(), MPI_BYTE,
                 MPI_COMM_WORLD);
  return all;
}

inline std::string fromRank0(std::string text) {
  auto length = static_cast<int>(text.size());
  MPI_Bcast(&length, 1, MPI_INT, 0, MPI_COMM_WORLD);
  text.resize(static_cast<std::size_t>(length));
  MPI_Bcast(text.data(), length, MPI_CHAR, 0, MPI_COMM_WORLD);
  return text;
}

/// A folder that all ranks see; made and removed by rank 0.
class SharedFolder : public Folder {
 public:
  SharedFolder() : SharedFolder(ownRank() == 0 ? std::make_unique<TemporaryFolder>() : nullptr) {}
  ~SharedFolder() { MPI_Barrier(MPI_COMM_WORLD); }
  SharedFolder(const SharedFolder&) = delete;
  SharedFolder& operator=(const SharedFolder&) = delete;
  SharedFolder(SharedFolder&&) = delete;
  SharedFolder& operator=(SharedFolder&&) = delete;

 private:
  explicit SharedFolder(std::unique_ptr<TemporaryFolder> own)
      : Folder(fromRank0(own ? own->path().string() : "")), own_(std::move(own)) {}

  std::unique_ptr<TemporaryFolder> own_;  // rank 0's
};

/// That the work throws on every rank, and the same everywhere. Returns the text.
inline std::string expectAgreedError(ErrorKind kind, const std::function<void()>& work) {
  std::string text;
  try {
    work();
    ADD_FAILURE() << "rank " << ownRank() << ": nothing was thrown";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    text = error.what();
  }
  EXPECT_EQ(text, fromRank0(text));
  return text;
}

}  // namespace cutwater::test
