#include <Cutwater/Core/Checksum.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/P4est/Agreement.hpp>

#include <mpi.h>
#include <span>
#include <string>

#include "Amr.hpp"
#include "Options/OutputFile.hpp"
#include "Report/Failure.hpp"

namespace {

using cutwater::tool::failed;
using cutwater::tool::kFailed;

constexpr const char* kName = "cutwater-mpi";

/// Ranks with other options would wait for one another without end.
void requireSameWords(int argc, const char* const* argv) {
  std::string words;
  for (int i = 1; i < argc; ++i) words.append(argv[i]) += '\0';
  cutwater::requireSame(MPI_COMM_WORLD, cutwater::xxHash64(std::as_bytes(std::span(words))),
                        "the ranks have different command lines");
}

/// The same on all ranks; the first one reports.
int run(int argc, const char* const* argv, bool isFirst) {
  cutwater::tool::Program program(
      kName, "AMR meshes around surface meshes on many processes (MPI). Links p4est, which is GPL.",
      "Example:\n"
      "  mpirun -n 4 cutwater-mpi amr hull.stl --level 8 -o hull.pvtu\n"
      "\n"
      "Exit status: 0 done; 1 a file or a surface is not what it must be; 2 wrong usage.");
  if (!isFirst) program.beSilent();
  cutwater::tool::addDistributedAmr(program, MPI_COMM_WORLD);
  try {
    requireSameWords(argc, argv);
    return program.run(argc, argv);
  } catch (const cutwater::Error& error) {  // all ranks have it
    return isFirst ? failed(kName, error.what(), kFailed) : kFailed;
  }
}

}  // namespace

int main(int argc, char** argv) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  cutwater::tool::removeOutputsOnSignals();
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  try {
    const int status = run(argc, argv, rank == 0);
    MPI_Finalize();
    return status;
  } catch (const std::exception& error) {  // of this rank alone; the others would wait for it
    MPI_Abort(MPI_COMM_WORLD, failed(kName, error.what(), kFailed));
  }
  return kFailed;
}
