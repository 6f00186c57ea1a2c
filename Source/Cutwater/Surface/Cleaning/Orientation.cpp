#include <Cutwater/Surface/Cleaning/CleaningSteps.hpp>
#include <Cutwater/Surface/Cleaning/Detail/SoupEdits.hpp>
#include <Cutwater/Surface/Detail/Shells.hpp>
#include <Cutwater/Triangles/PolygonGeometry.hpp>

namespace cutwater {

OrientationCorrections orientFaces(PolygonSoup& soup, NestedShells nested) {
  PolygonSoup scaled = soup;
  scaled.points = normalizedPositions(soup.points, soup.corners);
  const auto orientation = orientShells(DcelMesh<double>(scaled), nested);
  OrientationCorrections result;
  result.unorientable = orientation.unorientable;
  for (const auto shell : orientation.insideOut) {
    result.shells.add(detail::middleOf(soup, orientation.firstFaces[shell]));
  }
  for (std::size_t i = 0; i < orientation.disagreeing.size(); ++i) {
    if (orientation.disagreeing[i]) result.faces.add(detail::middleOf(soup, i));
  }
  for (std::size_t i = 0; i < orientation.turned.size(); ++i) {
    if (orientation.turned[i]) detail::turnPolygon(soup, i);
  }
  return result;
}

}  // namespace cutwater
