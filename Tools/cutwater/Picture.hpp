#pragma once

#include <Cutwater/Render/Slice.hpp>

#include <optional>
#include <string>

#include "Surface.hpp"

namespace CLI {
class App;
}

namespace cutwater::tool {

/// A picture of a plane through the surface.
struct PictureOptions {
  std::string output;
  int axis = 1;              ///< the plane's normal
  std::optional<double> at;  ///< its position; without it: the middle of the surface, or 0
  SliceOptions<double> slice;
};

/// Adds --size.
void addSizeOption(CLI::App& command, int& width, int& height);
void addPictureOptions(CLI::App& command, PictureOptions& options);

/// Draws and writes the picture, and reports that unless --quiet is given.
void writePicture(const Solid<double>& solid, const SurfaceOptions& surface,
                  PictureOptions options);

}  // namespace cutwater::tool
