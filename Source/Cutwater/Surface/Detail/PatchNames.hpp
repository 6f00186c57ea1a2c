#pragma once

#include <Cutwater/Surface/DcelMesh.hpp>

#include <string>
#include <vector>

namespace cutwater::detail {

/// The names of the mesh's patches. Those up to the highest id of a face that have no name are
/// called "surface", so that there is one for every id.
/// @throws Error(Argument) for an id without a name from 2^20 on: memory for so many is not needed.
template <std::floating_point T>
[[nodiscard]] std::vector<std::string> patchNamesOf(const DcelMesh<T>& mesh);

extern template std::vector<std::string> patchNamesOf(const DcelMesh<float>&);
extern template std::vector<std::string> patchNamesOf(const DcelMesh<double>&);

}  // namespace cutwater::detail
