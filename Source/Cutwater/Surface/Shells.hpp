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

/// Orients a mesh. Faces connected across edges of exactly two faces are made to agree; the
/// majority decides. Faces connected across edges of any kind then form a shell and are judged
/// together.
///
/// A closed shell is inside out if its volume is negative and it is not a cavity, that is, not
/// within any other closed shell (decided exactly, for one of its vertices). It is turned together
/// with the shells within it, so its cavities stay cavities. An open shell is judged by the volume
/// that it encloses together with fans from the middle of its rim. But if its rim is longer than
/// the root of its area and it would enclose less than a tenth of a sphere of the same area, it is
/// a sheet and stays as it is. This holds for NestedShells::AsTheyAre; otherwise, whether a shell
/// is turned depends on how many closed shells it lies within, or not even on that.
template <std::floating_point T>
[[nodiscard]] ShellOrientation orientShells(const DcelMesh<T>& mesh,
                                            NestedShells nested = NestedShells::AsTheyAre);

extern template ShellOrientation orientShells(const DcelMesh<float>&, NestedShells);
extern template ShellOrientation orientShells(const DcelMesh<double>&, NestedShells);

}  // namespace cutwater
