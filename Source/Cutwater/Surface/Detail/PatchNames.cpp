#include <Cutwater/Core/Error.hpp>
#include <Cutwater/Surface/Detail/PatchNames.hpp>

#include <algorithm>

namespace cutwater::detail {

template <std::floating_point T>
std::vector<std::string> patchNamesOf(const DcelMesh<T>& mesh) {
  std::vector<std::string> names(mesh.patchNames().begin(), mesh.patchNames().end());
  std::uint32_t highest = 0;
  for (const FaceId face : mesh.faces()) highest = std::max(highest, mesh.patch(face));
  if (highest < names.size()) return names;
  constexpr std::uint32_t kMostWithoutName = 1U << 20U;
  require(highest < kMostWithoutName, "a patch id without a name must be below 2^20",
          Named{"patch", highest}, Named{"names", names.size()});
  names.resize(highest + 1, "surface");
  return names;
}

template std::vector<std::string> patchNamesOf(const DcelMesh<float>&);
template std::vector<std::string> patchNamesOf(const DcelMesh<double>&);

}  // namespace cutwater::detail
