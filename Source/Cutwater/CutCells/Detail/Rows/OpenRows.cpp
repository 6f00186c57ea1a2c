#include <Cutwater/Core/Error.hpp>
#include <Cutwater/CutCells/Detail/Faces/EdgeLoops.hpp>
#include <Cutwater/CutCells/Detail/Faces/JoinedLoops.hpp>
#include <Cutwater/CutCells/Detail/Rows/OpenRows.hpp>

#include <algorithm>
#include <string>
#include <tuple>

namespace cutwater {

std::vector<Vec3<double>> openOutline(const CutCells::Polygons& parts, const FaceAxes& axes,
                                      bool isBelow) {
  EdgeLoops rims;
  for (std::size_t n = 0; n < parts.count(); ++n) rims.add(parts.of(n), isBelow);
  return joinedLoops(axes, rims.loopsAcross(axes.across));
}

namespace {

/// What is wrong with a triangle of an open patch.
std::string faultOf(const CutSurface& surface, const OpenMisfit& misfit) {
  return hasAxis(surface.openKinds()[misfit.triangle]) ? "lies in no plane of the grid"
                                                       : "is across no axis";
}

}  // namespace

void refuseMisfits(const CutSurface& surface, std::span<const OpenMisfit> misfits) {
  if (misfits.empty()) return;
  const auto inOrder = [](const OpenMisfit& m) {
    return std::tuple(m.triangle, m.point.z, m.point.y, m.point.x);
  };
  const auto& first = *std::ranges::min_element(misfits, {}, inOrder);
  const auto& name = surface.patchNames()[surface.patches()[first.triangle]];
  const auto p = surface.frame().toWorld(first.point);
  throw Error(ErrorKind::Topology, "cut cells: the open patch \"" + name + "\" " +
                                       faultOf(surface, first) + " at (" + detail::toText(p.x) +
                                       ", " + detail::toText(p.y) + ", " + detail::toText(p.z) +
                                       "); it must lie in planes of the grid");
}

}  // namespace cutwater
