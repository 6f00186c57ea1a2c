#pragma once

#include <Cutwater/Io/ReadTableOptions.hpp>
#include <Cutwater/Lattice/PackedBed.hpp>

#include <filesystem>
#include <vector>

namespace cutwater {

/// Reads balls, for a PackedBed, from a table in text, compressed by gzip or not: a line per ball
/// with its centre and radius, separated by commas.
///
///     x, y, z, r
///     0.1, 0.2, 0.3, 0.05
///
/// The names may be missing; empty lines and those that begin with # are skipped. Numbers are read
/// in the C locale always.
/// @throws Error(File) "path: line 7: ..." for a line that has not four numbers, finite ones, with
/// a positive radius, or if there is no ball; Error(Limit) beyond maxBytes or 2^32 - 2 balls;
/// Error(Argument) unless 0 < scale < infinity.
[[nodiscard]] std::vector<Ball<double>> readBalls(const std::filesystem::path& path,
                                                  const ReadTableOptions& options = {});

}  // namespace cutwater
