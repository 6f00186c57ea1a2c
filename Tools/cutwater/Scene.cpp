#include <Cutwater/Io/ReadScene.hpp>

#include <CLI/CLI.hpp>
#include <iostream>

#include "Commands.hpp"

namespace cutwater::tool {

void addScene(CLI::App& program) {
  auto& command = *program.add_subcommand("scene",
                                          "Say what a scene may hold: a TOML file that describes "
                                          "solids, for sample, amr, slice, render "
                                          "and info");
  command
      .add_flag_callback(
          "--keys", [] { std::cout << sceneKeys(); },
          "Every shape, mesh, lattice and operator, and each key with its default")
      ->required();
  command.footer(
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
