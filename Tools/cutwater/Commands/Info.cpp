#include <iostream>
#include <memory>

#include "Commands/Commands.hpp"
#include "Report/InfoFacts.hpp"

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

void addInfo(Program& program) {
  const auto options = std::make_shared<InfoOptions>();
  auto command = program.addCommand(
      "info",
      "Read and check a surface, and say what it is: size, patches, defects and what they mean, "
      "memory, what to do next; of a scene, its solid's expression, box and patches");
  addSurfaceOptions(command, *options, Reads::SurfacesAndScenes);
  command.addFlag("--float", "Say also what it takes in single precision", options->inFloat);
  command.addFlag("--json", "Say it in JSON, for programs", options->json);
  command.setFooter(
      "Examples:\n"
      "  cutwater info hull.stl.gz --float\n"
      "  cutwater info part.stl --scale 0.001 --rotate 90,x\n"
      "  cutwater info part.stl --json | jq .defects");
  command.setAction([=] { run(*options); });
}

}  // namespace cutwater::tool
