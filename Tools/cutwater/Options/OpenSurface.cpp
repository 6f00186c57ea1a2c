#include "Options/OpenSurface.hpp"

#include <Cutwater/Mesh/Detail/TreatmentSearch.hpp>

#include <algorithm>

#include "Report/Format.hpp"

namespace cutwater::tool {

namespace {

/// Whether it is worth looking for a repair: a few open edges cost little.
bool isWorthAWord(const PolygonSoup& soup, const SignReport& signs) {
  const auto few = soup.polygonCount() / 50;
  return !signs.isClosed() && (signs.ambiguous > 0 || signs.unbalancedEdges > few);
}

/// The command that carries out the treatment or, for one of many steps, that tells of it.
std::string commandFor(const Treatment& treatment, const SurfaceOptions& options) {
  const auto file = fileWord(options.file) + options.motions;
  if (!treatment.closings.empty() || treatment.widestHole)
    return "see 'cutwater info " + file + "'";
  std::string command = "'cutwater repair " + file + " -o repaired.ply";
  const auto& [weld, junctions, opposite, orient, nested] = treatment.clean;
  if (weld) command += " --weld " + exactly(*weld);
  if (junctions) command += " --junctions " + exactly(*junctions);
  if (opposite == OppositeFaces::Cancel) command += " --cancel-opposite";
  return command + "'";
}

}  // namespace

std::string adviceOnOpenings(const PolygonSoup& soup, const SignReport& signs,
                             const SurfaceOptions& options) {
  if (!isWorthAWord(soup, signs)) return {};
  const auto found = detail::findTreatments(soup, {});
  const auto closing = std::ranges::find(found.treatments, true, &Treatment::isClosed);
  if (closing == found.treatments.end()) return {};
  return "the surface is open, which is slow and leaves many cells undecided; a repair closes "
         "it: " +
         commandFor(*closing, options) + " (" + closing->effect + ")\n";
}

}  // namespace cutwater::tool
