#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/Detail/Surface/OpenPatches.hpp>
#include <Cutwater/Triangles/TriangleIntersection.hpp>

#include <algorithm>
#include <array>
#include <map>

namespace cutwater {

namespace {

std::string listOf(std::span<const std::string> names) {
  constexpr std::size_t kFew = 20;
  std::string list;
  for (std::size_t i = 0; i < std::min(kFew, names.size()); ++i) {
    list += (i > 0 ? ", \"" : "\"") + names[i] + "\"";
  }
  return names.size() > kFew ? list + ", ..." : list;
}

}  // namespace

std::vector<std::uint32_t> patchesCalled(std::span<const std::string> names,
                                         std::span<const std::string> patchNames, PatchRole role) {
  const bool isOpen = role == PatchRole::Open;
  std::vector<std::uint32_t> result;
  for (std::size_t n = 0; n < names.size(); ++n) {
    const auto before = result.size();
    for (std::uint32_t patch = 0; patch < patchNames.size(); ++patch) {
      if (patchNames[patch] == names[n]) result.push_back(patch);
    }
    if (result.size() == before) {
      throw Error(ErrorKind::Argument,
                  "cut cells: no patch is called \"" + names[n] +
                      (isOpen ? "\" that could be open" : "\" that could be a baffle") +
                      "; there are: " + listOf(patchNames));
    }
    if (std::ranges::count(names.first(n), names[n]) > 0) {
      throw Error(ErrorKind::Argument, std::string("cut cells: the ") +
                                           (isOpen ? "open patch \"" : "baffle \"") + names[n] +
                                           "\" is named twice; there are: " + listOf(patchNames));
    }
  }
  return result;
}

std::vector<OpenKind> findOpenKinds(const MovedSurface& surface,
                                    std::span<const std::uint32_t> patches,
                                    std::span<const std::uint32_t> openPatches) {
  if (openPatches.empty()) return {};
  std::vector<OpenKind> kinds(surface.meshTriangleCount(), OpenKind::Wall);
  std::map<std::uint32_t, std::array<bool, 3>>
      planesOf;  // of a patch: whether any is across an axis
  std::vector<std::uint32_t> empty;
  for (std::uint32_t id = 0; id < kinds.size(); ++id) {
    if (std::ranges::count(openPatches, patches[id]) == 0) continue;
    const auto triangle = surface.positionsOf(id);
    if (!hasArea(triangle)) {
      empty.push_back(id);
      continue;
    }
    kinds[id] = OpenKind::Inclined;
    for (int axis = 0; axis < 3; ++axis) {
      if (!lieAcross(triangle, axis)) continue;
      kinds[id] = static_cast<OpenKind>(axis);
      planesOf[patches[id]][static_cast<std::size_t>(axis)] = true;
    }
  }
  for (const auto id : empty) {
    const auto triangle = surface.positionsOf(id);
    for (int axis = 0; axis < 3; ++axis) {
      const bool isOfPatch = planesOf[patches[id]][static_cast<std::size_t>(axis)];
      if (isOfPatch && lieAcross(triangle, axis)) kinds[id] = static_cast<OpenKind>(axis);
    }
  }
  return kinds;
}

}  // namespace cutwater
