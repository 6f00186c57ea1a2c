#pragma once

#include <Cutwater/Core/Block.hpp>

#include <filesystem>

namespace cutwater::formats {

/// The file's bytes, read-only: mapped into memory where it is a regular file and the system can,
/// so that all processes of a node share one copy; else read. They begin at a multiple of
/// BlockWriter::kAlignment.
/// @throws Error(File) for what cannot be read.
[[nodiscard]] Block mapFile(const std::filesystem::path& path);

}  // namespace cutwater::formats
