#include <Cutwater/Scene/ReadScene.hpp>

#include <iostream>
#include <memory>

#include "Commands/Commands.hpp"

namespace cutwater::tool {

void addScene(Program& program) {
  auto command = program.addCommand("scene",
                                    "Say what a scene may hold: a TOML file that describes "
                                    "solids, for info, sample, amr, slice, render "
                                    "and isosurface");
  const auto keys = std::make_shared<bool>(false);
  command.addFlag("--keys",
                  "Every shape, mesh, lattice and operator, and each key with its default; "
                  "without it: this help",
                  *keys);
  command.setAction([&program, keys] { std::cout << (*keys ? sceneKeys() : program.help()); });
  command.setFooter(
      "A scene:\n"
      "  [pipe]\n"
      "  shape = \"cylinder\"\n"
      "  from = [0, 0, 0]\n"
      "  to = [0, 0, 4]\n"
      "  radius = 0.2\n"
      "\n"
      "Examples:\n"
      "  cutwater scene --keys\n"
      "  cutwater render pipe.toml -o pipe.png");
}

}  // namespace cutwater::tool
