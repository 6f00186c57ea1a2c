#pragma once

#include <cstdint>

namespace cutwater {

/// Options of readBeams() and readBalls().
struct ReadTableOptions {
  /// Coordinates and radii are multiplied by this (0.001: a file in millimetres, a model in
  /// metres).
  double scale = 1;
  /// Refuse files that decompress to more bytes than this.
  std::uint64_t maxBytes = std::uint64_t{16} << 30U;
};

}  // namespace cutwater
