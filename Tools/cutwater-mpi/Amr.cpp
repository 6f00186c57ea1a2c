#include "Amr.hpp"

#include <Cutwater/Core/Detail/PartFile.hpp>
#include <Cutwater/Core/Error.hpp>
#include <Cutwater/P4est/Agreement.hpp>
#include <Cutwater/P4est/DistributedVtu.hpp>
#include <Cutwater/P4est/SharedGeometry.hpp>

#include <algorithm>
#include <iostream>
#include <memory>

#include "Memory.hpp"
#include "Options/LoadSurface.hpp"
#include "Options/MeshOptions.hpp"
#include "Options/OutputFile.hpp"
#include "Report/Format.hpp"
#include "Report/MeshFields.hpp"
#include "Report/Stopwatch.hpp"

namespace cutwater::tool {

namespace {

struct Options {
  MPI_Comm comm = MPI_COMM_NULL;
  SurfaceOptions surface;
  std::string output;
  MeshOptions mesh;
  int cutWeight = 1;
  bool isPrivate = false;
};

struct Seconds {
  double startUp = 0;
  double mesh = 0;
  double values = 0;
  double file = 0;
};

struct Memory {
  ResidentMemory before;
  ResidentMemory withSurface;
  ResidentMemory atEnd;
};

int rankIn(MPI_Comm comm) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  return rank;
}
int sizeOf(MPI_Comm comm) {
  int size = 0;
  MPI_Comm_size(comm, &size);
  return size;
}

/// As many as there are for each of the ranks on this node.
int threadsOf(MPI_Comm comm) {
  MPI_Comm node = MPI_COMM_NULL;
  MPI_Comm_split_type(comm, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
  const int ranks = sizeOf(node);
  MPI_Comm_free(&node);
  return std::max(availableThreads() / ranks, 1);
}

/// The surface on this rank: its node's copy, or one of its own.
class Surface {
 public:
  explicit Surface(const Options& options) {
    auto quietly = options.surface;
    quietly.quiet = quietly.quiet || rankIn(options.comm) != 0;
    if (options.isPrivate) {
      quietly.threads = options.surface.threads;
      agreed(options.comm, [&] { own_.emplace(loadMesh(quietly)); });
    } else {
      quietly.threads = 0;  // the other ranks wait
      shared_ =
          std::make_unique<SharedGeometry<double>>(options.comm, [&] { return loadMesh(quietly); });
    }
  }
  [[nodiscard]] const MeshSDF<double>& mesh() const { return own_ ? *own_ : shared_->mesh(); }

 private:
  std::optional<MeshSDF<double>> own_;
  std::unique_ptr<SharedGeometry<double>> shared_;
};

CellCounts countsOnAll(const DistributedOctree<double>& mesh) {
  CellCounts counts(mesh.local());
  const auto add = [&](auto& numbers) {
    MPI_Allreduce(MPI_IN_PLACE, numbers.data(), static_cast<int>(numbers.size()), MPI_UINT64_T,
                  MPI_SUM, mesh.communicator());
  };
  add(counts.onLevel);
  add(counts.ofKind);
  return counts;
}

/// "ranks: 4; cells on each: 10 20 30 40". Collective.
std::string cellsOnRanks(const DistributedOctree<double>& mesh) {
  const auto comm = mesh.communicator();
  std::vector<std::uint64_t> cells(static_cast<std::size_t>(sizeOf(comm)));
  const std::uint64_t own = mesh.local().cells().size();
  MPI_Allgather(&own, 1, MPI_UINT64_T, cells.data(), 1, MPI_UINT64_T, comm);
  constexpr std::size_t kMost = 16;  // as much as fits on a line or two
  std::string text = "ranks: " + grouped(cells.size()) + "; cells on each: ";
  if (cells.size() > kMost) {
    const auto [least, most] = std::ranges::minmax(cells);
    return text + grouped(least) + " to " + grouped(most);
  }
  for (std::size_t r = 0; r < cells.size(); ++r) text += (r > 0 ? ", " : "") + grouped(cells[r]);
  return text;
}

/// Collective; rank 0 tells.
void report(const Options& options, const DistributedOctree<double>& mesh, std::uint64_t sum,
            const Seconds& seconds, const Memory& memory) {
  const auto counts = countsOnAll(mesh);
  const auto onRanks = cellsOnRanks(mesh);
  const auto forest = mesh.forestChecksum();
  if (rankIn(options.comm) != 0 || options.surface.quiet) return;
  std::cout << "wrote " << onOneLine(options.output) << ": " << grouped(mesh.cellCount(), "cell")
            << '\n';
  report(counts, mesh.local().domain());
  std::cout << onRanks << '\n'
            << "checksum: cells and values " << hexadecimal(sum) << ", p8est " << forest << '\n'
            << "start-up " << duration(seconds.startUp) << ", mesh " << duration(seconds.mesh)
            << ", values " << duration(seconds.values) << ", file " << duration(seconds.file)
            << "\nresident before start-up: " << text(memory.before) << "\nwith the surface, "
            << (options.isPrivate ? "a copy for each rank: " : "one copy for each node: ")
            << text(memory.withSurface) << "\nat the end: " << text(memory.atEnd) << '\n';
}

/// The number of nodes, each with memory of its own.
int nodesOf(MPI_Comm comm) {
  MPI_Comm node = MPI_COMM_NULL;
  MPI_Comm_split_type(comm, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
  int nodes = rankIn(node) == 0 ? 1 : 0;
  MPI_Comm_free(&node);
  MPI_Allreduce(MPI_IN_PLACE, &nodes, 1, MPI_INT, MPI_SUM, comm);
  return nodes;
}

/// The most cells that the limits allow, by the memory of rank 0's node. Rank 0 estimates the mesh.
/// @throws Error(Limit), on all ranks, if it has no room.
std::size_t mostCellsOf(const Options& options, const MeshSDF<double>& solid,
                        const OctreeDomain<double>& domain, const Refinement<double>& rules) {
  // A quadrant of p4est's with its data, and what cutwater keeps of a cell, at the peak.
  constexpr double kBytesOfQuadrant = 80;
  const double each = bytesPerCell(options.mesh) + kBytesOfQuadrant;
  const int nodes = nodesOf(options.comm);
  agreed(options.comm, [&] {
    if (rankIn(options.comm) != 0) return;
    const auto mesh =
        estimate<double>(solid, domain, rules,
                         {.balance = options.mesh.balance, .threads = options.surface.threads});
    requireRoom(options.mesh, mesh, each, 0, !options.surface.quiet, nodes);
  });
  std::uint64_t most = static_cast<std::uint64_t>(mostCells(options.mesh, each, nodes));
  MPI_Bcast(&most, 1, MPI_UINT64_T, 0, options.comm);
  return most;
}

void run(Options options) {
  if (isScene(options.surface)) {
    throw Error(ErrorKind::File, options.surface.file +
                                     ": cutwater-mpi takes surfaces only; 'cutwater isosurface' "
                                     "makes one of a scene");
  }
  const auto comm = options.comm;
  if (options.surface.threads == 0) options.surface.threads = threadsOf(comm);
  const int threads = options.surface.threads;
  Seconds seconds;
  Memory memory;
  memory.before = residentMemory(comm);
  Stopwatch watch;
  const auto lap = [&] {
    MPI_Barrier(comm);
    return watch.lap();
  };
  lap();
  const Surface surface(options);
  returnFreedMemory();
  seconds.startUp = lap();
  memory.withSurface = residentMemory(comm);
  const auto& solid = surface.mesh();
  const auto domain = domainAround(boxAround(solid), options.mesh);
  const auto rules = rulesFor(options.mesh.refinement, solid.patchNames());
  const auto most = mostCellsOf(options, solid, domain, rules);
  lap();
  const DistributedOctree<double> mesh(solid, domain, rules, comm,
                                       {.balance = options.mesh.balance,
                                        .cutWeight = options.cutWeight,
                                        .maxCells = most,
                                        .threads = threads});
  seconds.mesh = lap();
  std::optional<MeshFields> fields;
  agreed(comm, [&] {
    fields.emplace(mesh.local(), options.mesh.write);
    fill(solid, mesh.local(), fields->targets(), {.threads = threads});
    if (fields->hasPatches()) {
      fields->setPatches(cellPatches(solid, mesh.local(), {.threads = threads}));
    }
  });
  seconds.values = lap();
  removeStaleParts(piecePath(options.output, rankIn(comm), sizeOf(comm)));
  writePvtu(options.output, mesh, fields->arrays(),
            {.threads = threads, .patchNames = fields->patchNamesOf(solid)});
  seconds.file = lap();
  memory.atEnd = residentMemory(comm);
  report(options, mesh, mesh.checksum(fields->targets()), seconds, memory);
}

}  // namespace

void addDistributedAmr(Program& program, MPI_Comm comm) {
  const auto options = std::make_shared<Options>();
  options->comm = comm;
  auto command = program.addCommand(
      "amr", "Build the octree mesh of 'cutwater amr' on all ranks; each writes a piece of it");
  addSurfaceOptions(command, options->surface);
  addSignOptions(command, options->surface);
  addOutput(command, "-o,--output", options->output, {".pvtu"},
            "The file that binds the pieces, which are written beside it")
      .required();
  addMeshOptions(command, options->mesh);
  command.addNumber(
      "--cut-weight", "N",
      "A cell that the surface may meet counts for so many others when ranks get their "
      "shares [default: 1]",
      options->cutWeight, {1, 1000});
  command.addFlag("--private", "Every rank reads the surface and has a copy of its own",
                  options->isPrivate);
  command.setFooter(
      "Examples:\n"
      "  mpirun -n 4 cutwater-mpi amr hull.stl --level 8 -o hull.pvtu\n"
      "  mpirun -n 64 cutwater-mpi amr hull.cutwater --level 10 --band 0.5:7 --cut-weight 4 -o "
      "hull.pvtu\n"
      "\n"
      "--threads N: of each rank; without it, those that there are, shared by a node's ranks.");
  command.setAction([=] { run(*options); });
}

}  // namespace cutwater::tool
