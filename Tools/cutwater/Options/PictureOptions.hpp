#pragma once

#include <Cutwater/Render/Slice.hpp>

#include <optional>
#include <string>

#include "Options/Command.hpp"

namespace cutwater::tool {

/// A picture of a plane through the surface.
struct PictureOptions {
  std::string output;
  int axis = 1;              ///< the plane's normal
  std::optional<double> at;  ///< its position; without it: the middle of the surface, or 0
  SliceOptions<double> slice;
};

/// Adds --size.
void addSizeOption(Command command, int& width, int& height);
void addPictureOptions(Command command, PictureOptions& options);

}  // namespace cutwater::tool
