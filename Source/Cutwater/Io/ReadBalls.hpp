#pragma once

#include <Cutwater/Lattice/PackedBed.hpp>

#include <filesystem>
#include <vector>

namespace cutwater {

struct ReadBallsOptions {
  /// Centres and radii are multiplied by this (0.001: a file in millimetres, a model in metres).
  double scale = 1;
  /// Refuse files that decompress to more bytes than this.
  std::uint64_t maxBytes = std::uint64_t{16} << 30U;
};

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
                                                  const ReadBallsOptions& options = {});

}  // namespace cutwater
