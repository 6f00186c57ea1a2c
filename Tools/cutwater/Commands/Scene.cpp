#include <Cutwater/Scene/ReadScene.hpp>

#include <iostream>
#include <memory>
#include <optional>

#include "Commands/Commands.hpp"
#include "Options/UsageError.hpp"

namespace cutwater::tool {

namespace {

void printKeys(const std::string& word) {
  const auto text = sceneKeys(word);
  if (text.empty()) throw UsageError("--keys", "nothing in a scene is called '" + word + "'");
  std::cout << text;
}

}  // namespace

void addScene(Program& program) {
  auto command = program.addCommand("scene",
                                    "Say what a scene may hold: a TOML file that describes "
                                    "solids, for info, sample, amr, cells, slice, "
                                    "render and isosurface");
  const auto word = std::make_shared<std::optional<std::string>>();
  command.addOptional(
      "--keys", "WORD",
      "Every shape, mesh, lattice and operator, and each key with its default; with "
      "a word, those that mention it",
      [word](const std::string& text) { *word = text; });
  command.setAction([&program, word] {
    if (*word) {
      printKeys(**word);
    } else {
      std::cout << program.help();
    }
  });
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
      "  cutwater scene --keys torus\n"
      "  cutwater render pipe.toml -o pipe.png");
}

}  // namespace cutwater::tool
