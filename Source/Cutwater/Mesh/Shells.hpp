#pragma once

#include <Cutwater/Mesh/DcelMesh.hpp>
#include <Cutwater/Mesh/InsideOut.hpp>

#include <vector>

namespace cutwater {

/// Which faces of a mesh are to be turned, so that it faces outward.
struct ShellOrientation {
  std::vector<bool> turned;  ///< per face; empty if there is none
  /// Per face: whether it disagreed; it is turned unless its whole shell is. Empty if there is
  /// none.
  std::vector<bool> disagreeing;
  std::size_t turnedFaces = 0;   ///< disagreed with the other faces of their shell
  std::size_t unorientable = 0;  ///< shells like a Moebius strip: left as good as they can be
  std::vector<std::uint32_t> firstFaces;  ///< the lowest of each shell, ascending
  std::vector<std::uint32_t> insideOut;   ///< shells that stood so: indices into firstFaces

  /// How many shells there are, and how many stood inside out.
  [[nodiscard]] std::size_t shells() const { return firstFaces.size(); }
  [[nodiscard]] std::size_t turnedShells() const { return insideOut.size(); }
  [[nodiscard]] bool changesNothing() const { return turned.empty(); }
};

/// Orients a mesh. Faces connected across edges of exactly two faces are made to agree;
/// the majority decides. Faces connected across any edges are then a shell, and judged as one.
///
/// A closed shell is inside out if its volume is negative and it is no cavity, that is, lies within
/// no other closed shell (decided exactly, by a vertex of it). It is turned together with the
/// shells within it, so that its cavities stay cavities. An open shell is judged by the volume that
/// fans from the middle of its rim would close; but one whose rim is longer than the root of its
/// area, and which would close less than a tenth of a sphere of the same area, is a sheet and stays
/// as it is. So it is with NestedShells::AsTheyAre; else whether a shell is turned depends on how
/// many closed shells it lies within, or not even on that.
template <std::floating_point T>
[[nodiscard]] ShellOrientation orientShells(const DcelMesh<T>& mesh,
                                            NestedShells nested = NestedShells::AsTheyAre);

extern template ShellOrientation orientShells(const DcelMesh<float>&, NestedShells);
extern template ShellOrientation orientShells(const DcelMesh<double>&, NestedShells);

}  // namespace cutwater
