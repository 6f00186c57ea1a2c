#include <Cutwater/Core/Error.hpp>

#include <CLI/CLI.hpp>
#include <iostream>
#include <mpi.h>
#include <string>

#include "Amr.hpp"
#include "Failure.hpp"

namespace {

using cutwater::tool::kFailed;
using cutwater::tool::kUsage;

constexpr const char* kName = "cutwater-mpi";

void describe(CLI::App& program) {
  program.name(kName);
  program.description(
      "AMR meshes around surface meshes on many processes (MPI). Links p4est, which is GPL.");
  program.set_version_flag("--version", "cutwater-mpi " CUTWATER_VERSION);
  program.require_subcommand(1);
  program.footer(
      "Example:\n"
      "  mpirun -n 4 cutwater-mpi amr hull.stl --level 8 -o hull.pvtu\n"
      "\n"
      "Exit status: 0 done; 1 a file or a surface is not what it must be; 2 wrong usage.");
}

/// The same on all ranks; rank 0 tells.
int run(int argc, const char* const* argv, bool tells) {
  CLI::App program;
  describe(program);
  cutwater::tool::addDistributedAmr(program, MPI_COMM_WORLD);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return tells ? program.exit(error) : 0;
    return tells ? cutwater::tool::failed(program, error) : kUsage;
  } catch (const cutwater::Error& error) {  // all ranks have got it
    return tells ? cutwater::tool::failed(kName, error.what(), kFailed) : kFailed;
  }
  std::cout.flush();
  return std::cout ? 0 : cutwater::tool::failed(kName, "cannot write to standard output", kFailed);
}

}  // namespace

int main(int argc, char** argv) {
  int provided = 0;
  MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  try {
    const int status = run(argc, argv, rank == 0);
    MPI_Finalize();
    return status;
  } catch (const std::exception& error) {  // of this rank alone; the others would wait for it
    MPI_Abort(MPI_COMM_WORLD, cutwater::tool::failed(kName, error.what(), kFailed));
  }
  return kFailed;
}
