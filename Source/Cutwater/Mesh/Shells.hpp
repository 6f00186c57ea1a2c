#pragma once

#include <Cutwater/Mesh/DcelMesh.hpp>

#include <vector>

namespace cutwater {

/// The shells of a closed, oriented mesh (sets of faces connected across edges) that stand inside
/// out.
struct InsideOutShells {
  std::size_t count = 0;
  std::vector<bool> faces;  ///< per face of the mesh: to be turned
};

/// A shell is inside out if its normals point into it (negative volume) and it is no cavity, that
/// is, lies within no other shell. It is to be turned together with the shells within it, so that
/// its cavities stay cavities. A shell of negative volume within the bounding box of one of
/// positive volume counts as a cavity, as the file has it.
template <std::floating_point T>
[[nodiscard]] InsideOutShells findInsideOutShells(const DcelMesh<T>& mesh);

extern template InsideOutShells findInsideOutShells(const DcelMesh<float>&);
extern template InsideOutShells findInsideOutShells(const DcelMesh<double>&);

}  // namespace cutwater
