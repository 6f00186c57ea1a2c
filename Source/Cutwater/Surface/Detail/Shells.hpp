#pragma once

#include <Cutwater/Surface/DcelMesh.hpp>
#include <Cutwater/Surface/Detail/InsideOut.hpp>

#include <vector>

namespace cutwater {

/// The faces of a mesh that must be turned for it to face outward.
struct ShellOrientation {
  std::vector<bool> turned;  ///< per face; empty if no face is turned
  /// Per face: whether it disagreed with its shell; it is turned unless its whole shell is. Empty
  /// if none did.
  std::vector<bool> disagreeing;
  std::size_t turnedFaces = 0;   ///< disagreed with the other faces of their shell
  std::size_t unorientable = 0;  ///< shells like a Moebius strip: oriented as far as possible
  std::vector<std::uint32_t> firstFaces;  ///< the lowest of each shell, ascending
  std::vector<std::uint32_t> insideOut;   ///< those that were inside out: indices into firstFaces

  /// The number of shells, and of those that were inside out.
  [[nodiscard]] std::size_t shells() const { return firstFaces.size(); }
  [[nodiscard]] std::size_t turnedShells() const { return insideOut.size(); }
  [[nodiscard]] bool changesNothing() const { return turned.empty(); }
};

/// Finds what orientFaces() turns.
template <std::floating_point T>
[[nodiscard]] ShellOrientation orientShells(const DcelMesh<T>& mesh,
                                            NestedShells nested = NestedShells::AsTheyAre);

extern template ShellOrientation orientShells(const DcelMesh<float>&, NestedShells);
extern template ShellOrientation orientShells(const DcelMesh<double>&, NestedShells);

}  // namespace cutwater
