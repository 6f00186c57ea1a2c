#include <Cutwater/Scene/Detail/ParseToml.hpp>
#include <Cutwater/Scene/Detail/SceneGraph.hpp>
#include <Cutwater/Scene/ReadScene.hpp>
#include <Cutwater/Text/LoadFile.hpp>

namespace cutwater {

Solid<double> readScene(const std::filesystem::path& path, const ReadSceneOptions& options) {
  const auto name = path.string();
  const auto bytes = text::loadFile(path, options.maxBytes);
  scene::SceneGraph graph(scene::parseToml(bytes.view(), name), {.file = name,
                                                                 .folder = path.parent_path(),
                                                                 .maxBeams = options.maxBeams,
                                                                 .solids = {},
                                                                 .records = {}});
  return graph.make(options.solid);
}

}  // namespace cutwater
