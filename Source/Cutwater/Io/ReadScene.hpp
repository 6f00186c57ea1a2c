#pragma once

#include <Cutwater/Sdf/Solid.hpp>

#include <filesystem>
#include <string>

namespace cutwater {

/// Which solid of a scene, and how much of a file is read.
struct ReadSceneOptions {
  /// The name of the solid that is meant; empty: the one that the file says, or else its last.
  std::string solid = {};
  /// Refuse scenes of more bytes than this; what is read from files that they name does not count.
  std::uint64_t maxBytes = std::uint64_t{16} << 20U;
  /// Refuse conformal cells of more beams than this: a line may ask for any number.
  std::uint64_t maxBeams = 10'000'000;
};

/// Reads a solid from a scene: a file in TOML 1.0 that describes solids by name, each a shape, a
/// mesh, a lattice or an operator on others.
///
///     [pipe]
///     shape = "cylinder"
///     from = [0, 0, 0]
///     to = [0, 0, 4]
///     radius = 0.2
///
/// sceneKeys() tells every key. Solids may be named before they are described; all of the file is
/// checked, but only what is needed is made. Names of files are relative to the scene's folder.
///
/// @throws Error(File) "bracket.toml: line 12: ..." for what is no TOML; for keys that are missing,
/// not known or of another type; and for solids that there are not or that are made of themselves.
/// Errors of files, shapes and operators get the solid's line in front. Error(Limit) beyond
/// maxBytes or maxBeams, 100 operators on one another, or 65536 shapes in a solid; Error(Argument)
/// if the solid that the options name is not there; Error(File) in a library built without toml++.
[[nodiscard]] Solid<double> readScene(const std::filesystem::path& path,
                                      const ReadSceneOptions& options = {});

/// All that a scene may hold, each key with its default, as sections in Markdown.
[[nodiscard]] std::string sceneKeys();

}  // namespace cutwater
