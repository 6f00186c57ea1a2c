#include <Cutwater/Core/Detail/DisjointSets.hpp>
#include <Cutwater/Surface/Cleaning/CapOnPlane.hpp>
#include <Cutwater/Surface/Cleaning/Detail/PlanarRegions.hpp>
#include <Cutwater/Surface/Cleaning/Detail/PlaneFrame.hpp>
#include <Cutwater/Surface/Cleaning/Detail/SoupEdits.hpp>

#include <utility>

namespace cutwater {
namespace {

/// The open edges on the plane, except for chains that continue off it, which are reported.
std::vector<OpenEdge> closedRims(const PolygonSoup& soup, const detail::PlaneFrame& plane,
                                 OpeningReport& report) {
  std::vector<OpenEdge> edges;
  for (const auto& edge : detail::openEdgesOf(soup)) {
    if (plane.contains(soup.points[edge.lower]) && plane.contains(soup.points[edge.upper])) {
      edges.push_back(edge);
    }
  }
  std::vector<std::int64_t> balance(soup.points.size());
  detail::DisjointSets rims(soup.points.size());
  for (const auto& edge : edges) {
    balance[edge.lower] -= edge.multiplicity;
    balance[edge.upper] += edge.multiplicity;
    rims.unite(edge.lower, edge.upper);
  }
  std::vector<bool> goesOn(soup.points.size());
  for (std::uint32_t i = 0; i < balance.size(); ++i) {
    if (balance[i] == 0 || goesOn[rims.find(i)]) continue;
    goesOn[rims.find(i)] = true;
    report.left.add(soup.points[i]);
  }
  std::erase_if(edges, [&](const OpenEdge& edge) { return goesOn[rims.find(edge.lower)]; });
  return edges;
}

}  // namespace

OpeningReport capOnPlane(PolygonSoup& soup, const SurfacePlane& plane, const CapOptions& options) {
  soup.validate();
  const detail::PlaneFrame frame("capOnPlane", plane, options.tolerance);
  OpeningReport report;
  report.before = report.after = measure(soup);
  const auto loops = detail::loopsAround(closedRims(soup, frame, report));
  const auto filling = detail::fillLoops(soup.points, loops, frame.axis());
  for (std::size_t i = 0; i < loops.size(); ++i) {
    const auto& place = soup.points[loops[i].front()];
    (filling.left[i] ? report.left : report.closed).add(place);
    if (!filling.left[i]) report.rimEdges += loops[i].size();
  }
  if (filling.triangles.empty()) return report;
  PolygonSoup work = soup;
  const auto patch = detail::patchNamed(work, options.patch);
  for (const auto& triangle : filling.triangles) work.addPolygon(triangle, patch);
  report.facesAdded = filling.triangles.size();
  report.areaAdded = detail::areaFrom(work, soup.polygonCount());
  report.after = measure(work);
  soup = std::move(work);
  return report;
}

}  // namespace cutwater
