#include <new>
#include <string>

#include "Commands/Commands.hpp"
#include "Options/OutputFile.hpp"
#include "Report/Failure.hpp"

namespace cutwater::tool {

namespace {

int run(int argc, const char* const* argv) {
  Program program(
      "cutwater",
      "Signed distance fields and AMR meshes from surface meshes, for embedded-boundary CFD.",
      "Examples:\n"
      "  cutwater info hull.stl\n"
      "  cutwater repair hull.stl --cap z=0.4 -o closed.stl\n"
      "  cutwater sample hull.stl --cells 200 -o hull.vti\n"
      "  cutwater query hull.stl points.csv -o distances.csv\n"
      "  cutwater amr hull.stl --level 6 -o hull.vtu\n"
      "  cutwater cells hull.stl --cells 128 -o cells.vtu\n"
      "  cutwater mesh case/ hull.stl --level 5\n"
      "  cutwater slice hull.stl --axis y -o hull.png\n"
      "  cutwater render hull.stl --view iso -o hull.png\n"
      "  cutwater render exchanger.toml -o exchanger.png\n"
      "\n"
      "'cutwater SUBCOMMAND --help' tells more.\n"
      "Exit status: 0 done; 1 a file or a surface is not what it must be; 2 wrong usage.");
  program.addHelpForAll();
  addInfo(program);
  addRepair(program);
  addSample(program);
  addQuery(program);
  addAmr(program);
  addCells(program);
  addMesh(program);
  addSlice(program);
  addRender(program);
  addIsosurface(program);
  addConvert(program);
  addPrepare(program);
  addMake(program);
  addScene(program);
  return program.run(argc, argv);
}

int runOrFail(int argc, const char* const* argv) {
  removeOutputsOnSignals();
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    const std::string command = argc > 1 ? argv[1] : "";
    return failed("cutwater", "out of memory in 'cutwater " + command + "'", kFailed);
  } catch (const std::exception& error) {
    return failed("cutwater", error.what(), kFailed);
  }
}

}  // namespace

}  // namespace cutwater::tool

int main(int argc, char** argv) {
  return cutwater::tool::runOrFail(argc, argv);
}
