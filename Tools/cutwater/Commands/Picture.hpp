#pragma once

#include <Cutwater/Sdf/Solid.hpp>

#include "Options/PictureOptions.hpp"
#include "Options/SurfaceOptions.hpp"

namespace cutwater::tool {

/// Draws and writes the picture, and reports that unless --quiet is given.
void writePicture(const Solid<double>& solid, const SurfaceOptions& surface,
                  PictureOptions options);

}  // namespace cutwater::tool
