#include <Cutwater/Core/Error.hpp>
#include <Cutwater/P4est/Agreement.hpp>
#include <Cutwater/P4est/Detail/NodeMemory.hpp>

#include <algorithm>
#include <cstring>
#include <exception>

namespace cutwater::detail {

namespace {

/// MPI's counts are of type int.
constexpr std::size_t kChunk = std::size_t{1} << 30U;

int rankIn(MPI_Comm comm) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  return rank;
}

}  // namespace

NodeMemory::NodeMemory(MPI_Comm comm, std::span<const std::byte> bytes, int ranksPerCopy)
    : exceptions_(std::uncaught_exceptions()), users_(std::make_shared<char>()) {
  agreed(comm, [&] {
    require(ranksPerCopy >= 0, "SharedGeometry: need ranks per copy >= 0",
            Named{"ranksPerCopy", ranksPerCopy});
  });
  split(comm, ranksPerCopy);
  MPI_Comm writers = MPI_COMM_NULL;
  MPI_Comm_split(comm, isWriter_ ? 0 : MPI_UNDEFINED, rankIn(comm), &writers);
  std::uint64_t size = bytes.size();
  MPI_Bcast(&size, 1, MPI_UINT64_T, 0, comm);
  try {
    agreed(comm, [&] { allocate(size); });
  } catch (const Error&) {
    if (isWriter_) MPI_Comm_free(&writers);
    free();
    throw;
  }
  MPI_Win_fence(0, window_);
  if (isWriter_) {
    receive(bytes, writers);
    MPI_Comm_free(&writers);
  }
  MPI_Win_fence(0, window_);
}

NodeMemory::~NodeMemory() {
  // A rank that unwinds may be the only one.
  if (std::uncaught_exceptions() == exceptions_) free();
}

void NodeMemory::split(MPI_Comm comm, int ranksPerCopy) {
  // Ordered by rank: rank 0 is the first of its node, and the first of all writers.
  MPI_Comm_split_type(comm, MPI_COMM_TYPE_SHARED, rankIn(comm), MPI_INFO_NULL, &sharers_);
  if (ranksPerCopy > 0) {
    MPI_Comm node = sharers_;
    MPI_Comm_split(node, rankIn(node) / ranksPerCopy, rankIn(comm), &sharers_);
    MPI_Comm_free(&node);
  }
  isWriter_ = rankIn(sharers_) == 0;
}

void NodeMemory::allocate(std::uint64_t size) {
  constexpr auto kAlignment = BlockWriter::kAlignment;
  MPI_Comm_set_errhandler(sharers_, MPI_ERRORS_RETURN);
  const auto own = static_cast<MPI_Aint>(isWriter_ ? size + kAlignment : 0);
  void* memory = nullptr;
  if (MPI_Win_allocate_shared(own, 1, MPI_INFO_NULL, sharers_, &memory, &window_) != MPI_SUCCESS) {
    window_ = MPI_WIN_NULL;
    throw Error(ErrorKind::Limit,
                "no room for " + toText(static_cast<long long>(size)) + " bytes of shared memory");
  }
  MPI_Aint length = 0;
  int unit = 0;
  MPI_Win_shared_query(window_, 0, &length, &unit, &memory);
  // Pages begin at the same bytes on every rank, and so do multiples of any alignment below a page.
  auto room = static_cast<std::size_t>(length);
  memory = std::align(kAlignment, size, memory, room);
  bytes_ = {static_cast<std::byte*>(memory), size};
}

void NodeMemory::receive(std::span<const std::byte> bytes, MPI_Comm writers) {
  if (rankIn(writers) == 0) std::ranges::copy(bytes, bytes_.begin());
  for (std::size_t done = 0; done < bytes_.size(); done += kChunk) {
    const auto some = bytes_.subspan(done, std::min(kChunk, bytes_.size() - done));
    MPI_Bcast(some.data(), static_cast<int>(some.size()), MPI_BYTE, 0, writers);
  }
}

void NodeMemory::free() {
  int isOver = 0;
  MPI_Finalized(&isOver);
  if (isOver != 0 || sharers_ == MPI_COMM_NULL) return;
  const int own = users_.use_count() > 1 ? 1 : 0;
  int isUsed = 0;
  MPI_Allreduce(&own, &isUsed, 1, MPI_INT, MPI_MAX, sharers_);
  if (isUsed == 0 && window_ != MPI_WIN_NULL) MPI_Win_free(&window_);
  MPI_Comm_free(&sharers_);
}

}  // namespace cutwater::detail
