#include <Cutwater/Core/Error.hpp>
#include <Cutwater/P4est/Agreement.hpp>

#include <array>
#include <chrono>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <thread>

namespace cutwater {

namespace {

std::optional<Error> errorOf(FunctionRef<void()> work) {
  try {
    work();
    return {};
  } catch (const Error& error) {
    return error;
  } catch (const std::bad_alloc&) {
    return Error(ErrorKind::Limit, "out of memory");
  } catch (const std::exception& error) {
    return Error(ErrorKind::Argument, error.what());
  }
}

/// The least of all ranks' values of each number. During a long wait it yields the core to others,
/// such as rank 0's threads, which read a surface while the other ranks wait: MPI's own waiting
/// does not.
std::array<std::uint64_t, 2> leastOf(const std::array<std::uint64_t, 2>& own, MPI_Comm comm) {
  constexpr int kTries = 1000;
  std::array<std::uint64_t, 2> least{};
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Iallreduce(own.data(), least.data(), 2, MPI_UINT64_T, MPI_MIN, comm, &request);
  int isDone = 0;
  for (int tries = 0; isDone == 0; ++tries) {
    if (tries > kTries) std::this_thread::sleep_for(std::chrono::microseconds(500));
    MPI_Test(&request, &isDone, MPI_STATUS_IGNORE);
  }
  MPI_Wait(&request, MPI_STATUS_IGNORE);
  return least;
}

}  // namespace

void agreed(MPI_Comm comm, FunctionRef<void()> work) {
  const auto error = errorOf(work);
  int rank = 0;
  int size = 0;
  MPI_Comm_rank(comm, &rank);
  MPI_Comm_size(comm, &size);
  const auto own = static_cast<std::uint64_t>(error ? rank : size);
  const auto first = static_cast<int>(leastOf({own, 0}, comm).front());
  if (first == size) return;
  std::string text = rank == first ? error->what() : "";
  std::array<int, 2> kindAndLength{};
  if (rank == first)
    kindAndLength = {static_cast<int>(error->kind()), static_cast<int>(text.size())};
  MPI_Bcast(kindAndLength.data(), 2, MPI_INT, first, comm);
  text.resize(static_cast<std::size_t>(kindAndLength[1]));
  MPI_Bcast(text.data(), kindAndLength[1], MPI_CHAR, first, comm);
  throw Error(static_cast<ErrorKind>(kindAndLength[0]), text);
}

void requireSame(MPI_Comm comm, std::uint64_t checksum, const std::string& message) {
  const auto [least, complementOfMost] = leastOf({checksum, ~checksum}, comm);
  if (least != ~complementOfMost) throw Error(ErrorKind::Argument, message);
}

}  // namespace cutwater
