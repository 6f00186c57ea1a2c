#include <CLI/CLI.hpp>
#include <iostream>
#include <new>
#include <string>

#include "Commands.hpp"
#include "Failure.hpp"

namespace {

using cutwater::tool::failed;
using cutwater::tool::kFailed;

void describe(CLI::App& program) {
  program.name("cutwater");
  program.description(
      "Signed distance fields and AMR meshes from surface meshes, for embedded-boundary CFD.");
  program.set_version_flag("--version", "cutwater " CUTWATER_VERSION);
  program.set_help_all_flag("--help-all", "Help for all subcommands");
  program.require_subcommand(1);
  program.footer(
      "Examples:\n"
      "  cutwater info hull.stl\n"
      "  cutwater repair hull.stl --cap z=0.4 -o closed.stl\n"
      "  cutwater sample hull.stl --cells 200 -o hull.vti\n"
      "  cutwater amr hull.stl --level 6 -o hull.vtu\n"
      "  cutwater slice hull.stl --axis y -o hull.png\n"
      "  cutwater render hull.stl --view iso -o hull.png\n"
      "  cutwater render exchanger.toml -o exchanger.png\n"
      "\n"
      "'cutwater SUBCOMMAND --help' tells more.\n"
      "Exit status: 0 done; 1 a file or a surface is not what it must be; 2 wrong usage.");
}

int run(int argc, const char* const* argv) {
  CLI::App program;
  describe(program);
  cutwater::tool::addInfo(program);
  cutwater::tool::addRepair(program);
  cutwater::tool::addSample(program);
  cutwater::tool::addAmr(program);
  cutwater::tool::addSlice(program);
  cutwater::tool::addRender(program);
  cutwater::tool::addIsosurface(program);
  cutwater::tool::addConvert(program);
  cutwater::tool::addPrepare(program);
  cutwater::tool::addMake(program);
  cutwater::tool::addScene(program);
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return program.exit(error);  // --help, --version: to stdout
    return failed(program, error);
  }
  std::cout.flush();
  return std::cout ? 0 : failed("cutwater", "cannot write to standard output", kFailed);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const std::bad_alloc&) {
    return failed("cutwater", "out of memory", kFailed);
  } catch (const std::exception& error) {
    return failed("cutwater", error.what(), kFailed);
  }
}
