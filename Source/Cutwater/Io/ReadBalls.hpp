#pragma once

#include <Cutwater/Io/ReadTableOptions.hpp>
#include <Cutwater/Lattice/PackedBed.hpp>

#include <filesystem>
#include <vector>

namespace cutwater {

/// Reads balls, for a PackedBed, from a text table, optionally compressed by gzip: a line per ball
/// with its centre and radius, separated by commas.
///
///     x, y, z, r
///     0.1, 0.2, 0.3, 0.05
///
/// The line of names is optional; empty lines and those that begin with # are skipped. Numbers are
/// always read in the C locale.
/// @throws Error(File) "path: line 7: ..." for a line that does not have four finite numbers and a
/// positive radius, or if there is no ball; Error(Limit) beyond maxBytes or 2^32 - 2 balls;
/// Error(Argument) unless 0 < scale < infinity.
[[nodiscard]] std::vector<Ball<double>> readBalls(const std::filesystem::path& path,
                                                  const ReadTableOptions& options = {});

}  // namespace cutwater
