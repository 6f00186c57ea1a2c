#pragma once

#include <Cutwater/Lattice/BeamGraph.hpp>
#include <Cutwater/Lattice/PackedBed.hpp>

#include <cstdint>
#include <filesystem>
#include <vector>

namespace cutwater {

/// Options for reading text tables: beams and balls.
struct ReadTableOptions {
  /// Coordinates and radii are multiplied by this (0.001: a file in millimetres, a model in
  /// metres).
  double scale = 1;
  /// Refuse files that decompress to more bytes than this.
  std::uint64_t maxBytes = std::uint64_t{16} << 30U;
};

/// Reads the beams of a lattice from a text table, optionally compressed by gzip: a line for each
/// node, beam and ball, with fields separated by commas.
///
///     node, 0, 0, 0
///     node, 1, 0, 0
///     # the hull of a ball about each node, with the radii at the nodes
///     beam, 0, 1, 0.1, 0.2
///     # a frustum, with its caps: butt, hemisphere or sphere
///     beam, 0, 1, 0.1, 0.1, butt, sphere
///     # about a node, with its radius
///     ball, 1, 0.3
///
/// Nodes are numbered from 0 in the order of their lines, and come before the lines that refer to
/// them. Empty lines and those that begin with # are skipped. Numbers are always read in the C
/// locale.
/// @throws Error(File) "path: line 7: ..." for a line that is none of these, refers to a node that
/// does not exist, or has a coordinate or radius that is not finite, a negative radius, no radius
/// above 0, or a frustum of length 0; and if there are neither beams nor balls. Error(Limit) beyond
/// maxBytes or 2^32 - 2 lines of a kind; Error(Argument) unless 0 < scale < infinity.
[[nodiscard]] BeamGraph readBeams(const std::filesystem::path& path,
                                  const ReadTableOptions& options = {});

/// Writes such a table, which reads back as the same graph, to the bit. (Caps have no meaning for
/// beams that are not frusta, and read back as the default.)
/// @throws Error(File) if the file cannot be written, Error(Argument) if it could not be read back.
void writeBeams(const std::filesystem::path& path, const BeamGraph& graph);

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
