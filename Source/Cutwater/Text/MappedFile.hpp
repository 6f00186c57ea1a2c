#pragma once

#include <Cutwater/Core/Block.hpp>

#include <filesystem>

namespace cutwater::text {

/// The file's bytes, read-only: mapped into memory if it is a regular file and the system supports
/// that, so that all processes of a node share one copy; otherwise read. They begin at a multiple
/// of BlockWriter::kAlignment.
/// @throws Error(File) if it cannot be read.
[[nodiscard]] Block mapFile(const std::filesystem::path& path);

}  // namespace cutwater::text
