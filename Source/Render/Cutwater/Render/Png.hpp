#pragma once

#include <Cutwater/Render/Image.hpp>

#include <filesystem>

namespace cutwater {

/// Writes a picture as a PNG file; an existing file is replaced only once the new one is complete.
/// @throws Error(File) naming the path if it cannot be written.
void writePng(const std::filesystem::path& path, const Image& image);

}  // namespace cutwater
