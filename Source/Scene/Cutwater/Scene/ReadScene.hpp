#pragma once

#include <Cutwater/Sdf/Solid.hpp>

#include <filesystem>
#include <string>
#include <string_view>

namespace cutwater {

/// Which solid of a scene to read, and limits on its size.
struct ReadSceneOptions {
  /// The name of the solid to read; empty: the one that the file selects, or else its last.
  std::string solid = {};
  /// Refuse scenes of more bytes than this, not counting the files that they refer to.
  std::uint64_t maxBytes = std::uint64_t{16} << 20U;
  /// Refuse conformal cells of more beams than this: a single line may request any number.
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
/// sceneKeys() lists every key. Solids may be used before they are described. The whole file is
/// checked, but only the solids that are needed are made. File names are relative to the scene's
/// folder.
///
/// @throws Error(File) "bracket.toml: line 12: ..." for text that is not TOML; for keys that are
/// missing, unknown or of the wrong type; and for solids that do not exist or that contain
/// themselves. Errors of files, shapes and operators are prefixed with the solid's line.
/// Error(Limit) beyond maxBytes or maxBeams, 100 nested operators, or 65536 shapes in a solid;
/// Error(Argument) if the solid named in the options does not exist; Error(File) in a library built
/// without toml++.
[[nodiscard]] Solid<double> readScene(const std::filesystem::path& path,
                                      const ReadSceneOptions& options = {});

/// Returns a list of all that a scene may contain, each key with its default, as Markdown sections.
/// With a word: only the sections that mention it, in capitals or not; an empty text if none does.
[[nodiscard]] std::string sceneKeys(std::string_view word = {});

}  // namespace cutwater
