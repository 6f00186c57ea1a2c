#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "Commands.hpp"
#include "InfoFacts.hpp"

namespace cutwater::tool {

namespace {

std::string report(const InfoOptions& options) {
  if (isScene(options)) return aboutScene(options);
  const auto facts = gather(options);
  return options.json ? jsonOf(facts) : pageOf(facts);
}

void run(const InfoOptions& options) {
  const auto text = report(options);
  if (options.json || !options.quiet) std::cout << text;
}

}  // namespace

void addInfo(CLI::App& program) {
  const auto options = std::make_shared<InfoOptions>();
  auto& command = *program.add_subcommand(
      "info",
      "Read and check a surface, and say what it is: size, patches, defects and what they mean, "
      "memory, what to do next; of a scene, its solid's expression, box and patches");
  addSurfaceOptions(command, *options, Reads::SurfacesAndScenes);
  command.add_flag("--float", options->inFloat, "Say also what it takes in single precision");
  command.add_flag("--json", options->json, "Say it in JSON, for programs");
  command.footer(
      "Examples:\n"
      "  cutwater info hull.stl.gz --float\n"
      "  cutwater info part.stl --scale 0.001 --rotate 90,x\n"
      "  cutwater info part.stl --json | jq .defects");
  command.callback([=] { run(*options); });
}

}  // namespace cutwater::tool
